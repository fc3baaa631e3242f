"""The head of the function whose body an exercise is: what it returns and what it is given."""

import re
from dataclasses import dataclass

from course_lib.errors import CourseError
from mutation.tokens import partners_of, tokens_of

ACCESS = {"public", "protected", "private"}
NOT_OF_THE_TYPE = {"inline", "static", "constexpr", "virtual", "explicit", "friend"}
BEHIND_PARAMETERS = {"const", "noexcept", "override", "final", "&"}


@dataclass(frozen=True)
class Parameter:
    type: str  # without const and &: "Vec3"
    name: str  # empty when the function does without


@dataclass(frozen=True)
class Signature:
    result: str  # "std::optional<TriangleHit>"
    parameters: tuple


def read_signature(before, place):
    """@param before  the source up to the body's opening marker
    @param place  for the message
    @throws CourseError when no function's head is recognised
    """
    head = head_of(before)
    tokens = tokens_of(head)
    partners = partners_of(tokens)
    last = len(tokens) - 1
    while last >= 0 and tokens[last].text in BEHIND_PARAMETERS:
        last -= 1
    if last < 0 or tokens[last].text != ")" or last not in partners:
        raise CourseError(f"{place}: mistakes by rule need a marker right behind a function's head, 'Type name(...) {{'")
    first = partners[last]
    result = result_type(head, tokens, partners, first)
    if not result:
        raise CourseError(f"{place}: mistakes by rule need a function that says its type before its name")
    inside = [split for split in split_commas(tokens, partners, first + 1, last)]
    return Signature(result, tuple(parameter(head, tokens, a, b) for a, b in inside))


def head_of(before):
    """From the end of what comes before the function up to its '{'."""
    brace = before.rindex("{")
    head = before[:brace]
    tokens = tokens_of(head)
    start = 0
    depth = 0
    for token in reversed(tokens):
        if token.text in ")]":
            depth += 1
        elif token.text in "([":
            depth -= 1
        elif depth == 0 and token.text in (";", "}", "{"):
            start = token.end
            break
    return "\n".join(line for line in head[start:].split("\n") if not line.lstrip().startswith("#"))


def result_type(head, tokens, partners, opening):
    """What stands before the function's name; empty when there is nothing."""
    name = opening - 1
    while name > 0 and tokens[name - 1].text in ("::", "operator"):
        name -= 2 if tokens[name - 1].text == "::" else 1
    first = 0
    while first < name:
        if tokens[first].text == "template" and first + 1 in partners:
            first = partners[first + 1] + 1
        elif tokens[first].text == "template":
            first = next(i for i in range(first, name) if tokens[i].text == ">") + 1
        elif tokens[first].text in NOT_OF_THE_TYPE:
            first += 1
        elif tokens[first].text in ACCESS:  # private: void split(...)
            first += 2
        elif tokens[first].text == "[" and first in partners:  # [[nodiscard]]
            first = partners[first] + 1
        else:
            break
    return head[tokens[first].start:tokens[name - 1].end] if first < name else ""


def split_commas(tokens, partners, first, last):
    """The pieces [a, b) of tokens[first:last] between commas outside brackets."""
    start = i = first
    while i < last:
        if tokens[i].text == ",":
            yield start, i
            start = i + 1
        i = partners[i] + 1 if partners.get(i, -1) > i else i + 1
    if start < last:
        yield start, last


def parameter(head, tokens, first, last):
    equals = next((i for i in range(first, last) if tokens[i].text == "="), last)
    named = equals - first > 1 and tokens[equals - 1].kind == "name" and tokens[equals - 2].text != "::"
    type_end = equals - 1 if named else equals
    words = [t for t in tokens[first:type_end] if t.text not in ("const", "&")]
    named = named and bool(words)
    type_text = re.sub(r"\s+", " ", head[words[0].start:words[-1].end]) if words else ""
    return Parameter(type_text.replace("const ", ""), tokens[equals - 1].text if named else "")
