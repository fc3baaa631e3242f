"""What stands in a body: its blocks, statements and expressions, as far as operators need to know."""

from dataclasses import dataclass

from mutation.signature import split_commas
from mutation.tokens import partners_of, tokens_of

# A whole operand stands between two of these.
DELIMITERS = {",", ";", "{", "}", "(", ")", "[", "]", "?", ":", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "..."}
KEYWORDS = {"return", "case", "else", "throw", "do", "goto", "using", "new", "delete"}
LEVELS = (("||",), ("&&",), ("==", "!="), ("<", ">", "<=", ">="), ("+", "-"), ("*", "/", "%"))
DECLARING = {"const", "constexpr", "auto", "using", "struct", "static", "enum", "typename"}


@dataclass(frozen=True)
class Statement:
    kind: str  # "if", "for", "while", "do", "switch", "return", "jump", "declaration", "expression", "block", "label"
    first: int  # tokens [first, last)
    last: int
    header: tuple = ()  # tokens between the parentheses of if, for, while
    body: tuple = ()  # the statement below it
    otherwise: tuple = ()  # what stands behind else


class Body:
    """The tokens of a body with what they mean."""

    def __init__(self, source):
        self.source = source
        self.tokens = tokens_of(source)
        self.partners = partners_of(self.tokens)
        self.statements = []  # all, outer ones first
        self.blocks = []  # (first, last) tokens inside braces that hold statements; the body itself is one
        self._parse_all()

    def text(self, first, last):
        """The source of tokens [first, last)."""
        return self.source[self.tokens[first].start:self.tokens[last - 1].end] if last > first else ""

    def skip(self, i):
        """The index behind token i, or behind its bracket when it opens one."""
        return self.partners[i] + 1 if self.partners.get(i, -1) > i else i + 1

    def is_binary(self, i):
        """Whether + - * / & stand between two operands, not before one; formatted sources have spaces on both sides."""
        token = self.tokens[i]
        return token.spaced and token.followed

    def groups(self):
        """(opening token or -1, first, last) of everything between brackets, the body itself first."""
        yield -1, 0, len(self.tokens)
        for opening in sorted(self.partners):
            closing = self.partners[opening]
            if closing > opening and self.tokens[opening].text != "<":
                yield opening, opening + 1, closing

    def expressions(self):
        """(first, last) of every expression without a comma, assignment or ?: in it outside brackets."""
        for _, first, last in self.groups():
            start = i = first
            while i < last:
                token = self.tokens[i]
                nested = self.partners.get(i, -1) > i
                if nested and not self._is_block(i):
                    i = self.partners[i] + 1
                    continue
                if nested or token.text in DELIMITERS or token.text in KEYWORDS:
                    if start < i:
                        yield start, i
                    i = self.partners[i] + 1 if nested else i + 1
                    start = i
                else:
                    i += 1
            if start < last:
                yield start, last

    def operands(self, first, last, level):
        """Splits tokens [first, last) at the binary operators of a level: ([(first, last), ...], [operator token, ...])."""
        pieces, operators = [], []
        start = i = first
        while i < last:
            if self.tokens[i].text in level and self.is_binary(i) and self.partners.get(i) is None:
                pieces.append((start, i))
                operators.append(i)
                start = i + 1
            i = self.skip(i)
        pieces.append((start, last))
        return pieces, operators

    def arguments(self, opening):
        """The pieces between the commas of a bracket."""
        return list(split_commas(self.tokens, self.partners, opening + 1, self.partners[opening]))

    def _is_block(self, opening):
        return self.tokens[opening].text == "{" and (opening + 1, self.partners[opening]) in self.blocks

    def _parse_all(self):
        self.blocks.append((0, len(self.tokens)))
        for opening in sorted(self.partners):
            if self.tokens[opening].text == "{" and self._opens_statements(opening):
                self.blocks.append((opening + 1, self.partners[opening]))
        for first, last in self.blocks:
            i = first
            while i < last:
                i = self._parse(i, last).last
        self.statements = sorted(set(self.statements), key=lambda s: (s.first, -s.last))

    def _opens_statements(self, opening):
        before = self.tokens[opening - 1].text if opening else "{"
        if before in (";", "{", "}", "else", "do", "mutable", "noexcept"):
            return self._is_statement_place(opening)
        if before == ")":
            head = self.partners[opening - 1] - 1  # if (...) {, [&](...) {
            return head >= 0 and (self.tokens[head].text in ("if", "for", "while", "switch", "]", "constexpr", "catch")
                                  or self.tokens[head].kind == "name" and self._in_struct(opening))
        if before == ":":
            return True
        arrow = next((i for i in range(opening - 1, max(opening - 12, -1), -1) if self.tokens[i].text in ("->", ";", "{")), 0)
        return self.tokens[arrow].text == "->" and self.tokens[arrow - 1].text == ")" and \
            self.tokens[self.partners[arrow - 1] - 1].text == "]"

    def _in_struct(self, opening):
        return any(self.tokens[i].text == "struct" for i in range(opening))

    def _is_statement_place(self, opening):
        """A '{' behind ; { } begins a block, unless it is the first of a list in a list: {{a, b}, {c, d}}."""
        before = opening - 1
        if opening == 0 or self.tokens[before].text in (";", "}", "else", "do"):
            return True
        return (before + 1, self.partners.get(before, -1)) in self.blocks

    def _parse(self, i, last):
        """The statement that begins at token i."""
        text = self.tokens[i].text
        if text == "{" and (i + 1, self.partners[i]) in self.blocks:
            return self._keep(Statement("block", i, self.partners[i] + 1))
        if text in ("if", "for", "while", "switch"):
            opening = i + 2 if self.tokens[i + 1].text == "constexpr" else i + 1
            below = self._parse(self.partners[opening] + 1, last)
            otherwise = ()
            end = below.last
            if text == "if" and end < last and self.tokens[end].text == "else":
                other = self._parse(end + 1, last)
                otherwise, end = (other.first, other.last), other.last
            return self._keep(Statement(text, i, end, (opening + 1, self.partners[opening]), (below.first, below.last),
                                        otherwise))
        if text == "do":
            below = self._parse(i + 1, last)
            return self._keep(Statement("do", i, self._behind_semicolon(below.last, last), (), (below.first, below.last)))
        if text in ("case", "default"):
            colon = next(j for j in range(i, last) if self.tokens[j].text == ":")
            return self._keep(Statement("label", i, colon + 1))
        end = self._behind_semicolon(i, last)
        return self._keep(Statement(self._kind(i, end), i, end))

    def _kind(self, i, end):
        text = self.tokens[i].text
        if text == "return":
            return "return"
        if text in ("break", "continue"):
            return "jump"
        if text in DECLARING or self._declares(i, end):
            return "declaration"
        return "expression"

    def _declares(self, i, end):
        """Type name = ...; Type name{...}; Type name;"""
        while i + 1 < end and self.tokens[i].kind == "name":
            if self.tokens[i + 1].text == "::":
                i += 2
                continue
            i += 1
            if self.tokens[i].text == "<" and i in self.partners:
                i = self.partners[i] + 1
            if self.tokens[i].text == "::":
                i += 1
                continue
            while self.tokens[i].text in ("&", "*") and not self.tokens[i].spaced:
                i += 1
            return self.tokens[i].kind == "name"
        return False

    def _behind_semicolon(self, i, last):
        while i < last and self.tokens[i].text != ";":
            i = self.skip(i)
        return min(i + 1, last)

    def _keep(self, statement):
        self.statements.append(statement)
        return statement
