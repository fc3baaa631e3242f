"""Operators that need to know a type: a name for another of its type, a channel, an octant, a precision."""

import re
from dataclasses import dataclass

from mutation.signature import split_commas
from mutation.structure import LEVELS
from mutation.operators_values import FACTORS, TERMS, innermost

DIRECTIONS = ("Vec3", "Ray")
# What a spoilt value is the same as: wrapped, it would be no mistake.
CONSTANT = r"^-?[\d.]+$|^\w+::(?:Zero|Ones|Unit[XYZ])\(\)$|^(?:true|false|nullptr)$|^std::nullopt$"
UNCHANGED = {"narrowed": re.compile(CONSTANT), "firstChannel": re.compile(CONSTANT),
             "unsignedOf": re.compile(CONSTANT + r"|^std::(?:sqrt|abs|hypot)\([^()]*\)$|^[\w.>-]+\.(?:squaredNorm|norm|stableNorm)\(\)$")}


@dataclass(frozen=True)
class Context:
    """What stands around a body."""

    signature: object
    enumerations: dict  # "VertexUse" -> ["LightPoint", ...]


def parameter(body, context):
    """A parameter for another of its type."""
    yield from others_of_their_type(body, [(p.type, p.name) for p in context.signature.parameters if p.name], pairs=True)


def local(body, context):
    """A local variable for the next of its type."""
    yield from others_of_their_type(body, locals_of(body), pairs=False)


def others_of_their_type(body, declared, pairs):
    by_type = {}
    for type_, name in declared:
        if name not in by_type.setdefault(type_, []):
            by_type[type_].append(name)
    for i, token in enumerate(body.tokens):
        if token.kind != "name" or not is_use(body, i):
            continue
        for names in by_type.values():
            if token.text in names and len(names) > 1:
                others = [n for n in names if n != token.text]
                following = names[(names.index(token.text) + 1) % len(names)]
                for other in others if pairs else [following]:
                    yield token.start, token.end, other


def is_use(body, i):
    """Whether a name is neither a member nor declared here."""
    before = body.tokens[i - 1] if i else None
    if before and (before.text in (".", "->", "::") or before.kind == "name" and before.text not in ("return", "case", "else")):
        return False
    if before and before.text in ("&", "*", ">") and not body.tokens[i - 1].spaced:
        return False  # const Vec3& wi
    return True


def locals_of(body):
    """(type, name) of the variables that statements declare with a type."""
    found = []
    for s in body.statements:
        if s.kind == "declaration" or s.kind == "for":
            first, last = (s.first, s.last) if s.kind == "declaration" else s.header
            text = body.source[body.tokens[first].start:body.tokens[last - 1].end]
            match = re.match(r"(?:static\s+)?(?:const\s+|constexpr\s+)?([A-Za-z_][\w:]*(?:<[^;=()]*>)?)\s*&?\s+(\w+)\s*(?:[={;:]|$)",
                             text)
            if match and match[1] not in ("using", "struct", "return", "auto"):
                found.append((match[1], match[2]))
    return found


def enumerator(body, context):
    """An enumerator for its neighbours."""
    tokens = body.tokens
    for i, token in enumerate(tokens[:-2]):
        names = context.enumerations.get(token.text)
        if names and tokens[i + 1].text == "::" and tokens[i + 2].text in names:
            place = names.index(tokens[i + 2].text)
            for other in dict.fromkeys((names[(place + 1) % len(names)], names[place - 1])):
                yield tokens[i + 2].start, tokens[i + 2].end, other


def initialisers(body):
    """(type or "", first, last) of what is assigned, handed on or returned as a whole."""
    tokens = body.tokens
    for s in body.statements:
        if s.kind == "return" and s.last - s.first > 2 and tokens[s.first + 1].text != "{":
            yield "return", s.first + 1, s.last - 1
        elif s.kind in ("declaration", "expression"):
            equals = next((i for i in own_tokens(body, s.first, s.last) if tokens[i].text in ("=", "+=", "-=", "*=")), None)
            if equals and tokens[equals + 1].text not in ("{", "["):
                yield tokens[s.first].text, equals + 1, s.last - 1


def own_tokens(body, first, last):
    i = first
    while i < last:
        yield i
        i = body.skip(i)


def precision(body, context):
    """float for double on the way."""
    yield from wrapped(body, "narrowed")


def magnitude(body, context):
    """The sign of a value lost."""
    yield from wrapped(body, "unsignedOf")


def wrapped(body, function):
    for _, first, last in initialisers(body):
        start, end = body.tokens[first].start, body.tokens[last - 1].end
        if UNCHANGED[function].search(body.source[start:end]):
            continue
        yield start, end, f"mutation::{function}({body.source[start:end]})"


def channel(body, context):
    """The first channel of a colour for all three."""
    if not any(token.text == "Color" for token in body.tokens) and "Color" not in context.signature.result and \
            not any(p.type == "Color" for p in context.signature.parameters):
        return
    yield from wrapped(body, "firstChannel")
    for first, last in body.expressions():
        for a, b in innermost(body, first, last, LEVELS.index(FACTORS)):
            if (a, b) != (first, last) and body.tokens[a].kind != "number":
                start, end = body.tokens[a].start, body.tokens[b - 1].end
                yield start, end, f"mutation::firstChannel({body.source[start:end]})"


def octant(body, context):
    """The result off in one octant of a direction that is given."""
    directions = [p.name for p in context.signature.parameters if p.name and p.type.split("::")[-1] in DIRECTIONS]
    for kind, first, last in initialisers(body):
        if kind != "return":
            continue
        start, end = body.tokens[first].start, body.tokens[last - 1].end
        for name in directions:
            yield start, end, f"mutation::offInOctant({body.source[start:end]}, {name})"
    for opening, first, last in body.groups():  # return T{a, b, c}, return {a, b}
        if opening > 0 and body.tokens[opening].text == "{" and returned(body, opening):
            for a, b in split_commas(body.tokens, body.partners, first, last):
                start, end = body.tokens[a].start, body.tokens[b - 1].end
                for name in directions:
                    yield start, end, f"mutation::offInOctant({body.source[start:end]}, {name})"


def returned(body, opening):
    before = opening - 1
    while before > 0 and (body.tokens[before].kind == "name" and body.tokens[before].text != "return" or
                          body.tokens[before].text == "::"):
        before -= 1
    return body.tokens[before].text == "return"


TYPES = {"parameter": parameter, "local": local, "enumerator": enumerator, "precision": precision, "magnitude": magnitude,
         "channel": channel, "octant": octant}
