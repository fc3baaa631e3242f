"""The tokens of a piece of C++, and which bracket belongs to which.

No compiler: what a `<` is tells the space before it, for the course's sources are formatted by clang-format. Where that is
wrong a mutant does not compile, and is dropped.
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(
    r"""(?P<space>\s+|//[^\n]*|/\*.*?\*/)
      | (?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
      | (?P<number>(?:0[xX][0-9a-fA-F']+|(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][+-]?\d+)?)[uUlLzZfF]*)
      | (?P<name>[A-Za-z_]\w*)
      | (?P<sign><=>|->|::|&&|\|\||==|!=|<=|>=|\+=|-=|\*=|/=|%=|&=|\|=|\+\+|--|\.\.\.|.)""",
    re.VERBOSE | re.DOTALL)
PAIRS = {"(": ")", "[": "]", "{": "}"}


@dataclass(frozen=True)
class Token:
    text: str
    kind: str  # "text", "number", "name" or "sign"
    start: int  # where it stands in the source
    end: int
    spaced: bool  # whether white space stands before it
    followed: bool  # whether white space stands behind it


def tokens_of(source):
    """@return list of Token, white space and comments left out"""
    found = []
    place = 0
    while place < len(source):
        match = TOKEN.match(source, place)
        if match.lastgroup != "space":
            spaced = place == 0 or source[place - 1].isspace()
            followed = match.end() >= len(source) or source[match.end()].isspace()
            found.append(Token(match[0], match.lastgroup, match.start(), match.end(), spaced, followed))
        place = match.end()
    return found


def partners_of(tokens):
    """For each bracket, also those of template arguments, the index of the one that belongs to it.

    @return dict in both directions
    """
    partners = {}
    opened = []
    for i, token in enumerate(tokens):
        if token.kind != "sign":
            continue
        if token.text in PAIRS or is_template_opening(tokens, i):
            opened.append(i)
        elif token.text in PAIRS.values():
            while opened and tokens[opened[-1]].text == "<":
                opened.pop()  # it was a comparison after all
            if opened:
                join(partners, opened.pop(), i)
        elif token.text == ">" and opened and tokens[opened[-1]].text == "<" and not token.spaced:
            join(partners, opened.pop(), i)
    return partners


def is_template_opening(tokens, i):
    token = tokens[i]
    return token.text == "<" and not token.spaced and not token.followed and i > 0 and tokens[i - 1].kind == "name"


def join(partners, first, last):
    partners[first] = last
    partners[last] = first
