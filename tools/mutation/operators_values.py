"""Operators on what an expression computes."""

from mutation.structure import LEVELS

TURNED = {"<": ("<=", ">"), "<=": ("<", ">="), ">": (">=", "<"), ">=": (">", "<="), "==": ("!=",), "!=": ("==",)}
OTHER_SIGN = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
OTHER_PRODUCT = {"*": "/", "/": "*", "*=": "/=", "/=": "*="}
EXCHANGED = {"min": "max", "max": "min"}
LARGE = 16  # from here on an integer is a limit or a size, and off by one says nothing
TINY = 1e-3  # below it a number is a tolerance
FACTORS, TERMS = LEVELS[-1], LEVELS[-2]

# Names that stand beside each other and are easily taken for one another.
TWINS = (("ns", "ng"), ("wo", "wi"), ("dpdu", "dpdv"), ("front", "back"), ("first", "second"), ("lower", "upper"),
         ("low", "high"), ("left", "right"), ("enter", "leave"), ("before", "after"), ("forward", "back"), ("tMin", "tMax"),
         ("tNear", "tFar"), ("begin", "end"), ("sin", "cos"), ("point", "vector"), ("vector", "normal"), ("pdfW", "pdfA"),
         ("origin", "direction"), ("cosTo", "cosFrom"), ("alphaX_", "alphaY_"), ("norm", "squaredNorm"), ("any", "all"),
         ("maxCoeff", "minCoeff"), ("maxCoeff", "sum"), ("Zero", "Ones"), ("UnitX", "UnitY"), ("UnitY", "UnitZ"),
         ("UnitZ", "UnitX"), ("eye", "light"), ("onwards", "back"), ("u", "v"), ("du", "dv"), ("degreeU_", "degreeV_"),
         ("degreeU", "degreeV"), ("min", "max"), ("radius", "height"), ("eta", "k"), ("nearer", "farther"), ("i", "j"))
COORDINATES = {"x": "y", "y": "z", "z": "x"}


def relation(body, context):
    """A comparison turned round, or made strict or not."""
    for i, token in enumerate(body.tokens):
        if token.text in TURNED and token.kind == "sign" and body.is_binary(i) and i not in body.partners:
            for other in TURNED[token.text]:
                yield token.start, token.end, other


def sign(body, context):
    """+ and - exchanged; a minus in front lost."""
    yield from exchanged(body, OTHER_SIGN)
    for i, token in enumerate(body.tokens):
        if token.text == "-" and not token.followed:
            yield token.start, token.end, ""


def product(body, context):
    """Times and divided by exchanged."""
    yield from exchanged(body, OTHER_PRODUCT)


def exchanged(body, other):
    for i, token in enumerate(body.tokens):
        if token.text in other and body.is_binary(i):
            yield token.start, token.end, other[token.text]


def minmax(body, context):
    """min for max, max for min; or the bound left out."""
    for i, token in enumerate(body.tokens[:-1]):
        if token.text not in ("min", "max", "clamp") or body.tokens[i - 1].text != "::":
            continue
        if token.text in EXCHANGED:
            yield token.start, token.end, EXCHANGED[token.text]
        if body.tokens[i + 1].text == "(":
            start = body.tokens[i - 2].start  # std
            for first, last in body.arguments(i + 1):
                yield start, body.tokens[body.partners[i + 1]].end, f"({body.text(first, last)})"


def constant(body, context):
    """A number off: an integer by one (a large one halved), another by a factor."""
    for i, token in enumerate(body.tokens):
        if token.kind == "number":
            for other in other_numbers(token.text):
                yield token.start, token.end, other
        elif token.text in ("true", "false"):
            yield token.start, token.end, "false" if token.text == "true" else "true"


def other_numbers(text):
    try:
        value = int(text)
    except ValueError:
        try:
            value = float(text)
        except ValueError:
            return  # hexadecimal, or with a suffix
        if value == 0:
            yield "1.0"
        elif abs(value) < TINY:
            yield f"{value * 1e3:g}"
            yield "0.0"
        else:
            yield f"({text} * 2)"
            yield f"({text} / 2)"
        return
    if value >= LARGE:
        yield str(value // 2)
    else:
        yield str(value + 1)
        if value > 0:
            yield str(value - 1)


def factor(body, context):
    """A factor or a divisor left out."""
    for first, last in body.expressions():
        for piece_first, piece_last in innermost(body, first, last, LEVELS.index(TERMS)):
            factors, signs = body.operands(piece_first, piece_last, FACTORS)
            yield from left_out(body, factors, signs, "1 / ", "/")


def term(body, context):
    """A term of a sum left out."""
    for first, last in body.expressions():
        for piece_first, piece_last in innermost(body, first, last, LEVELS.index(TERMS) - 1):
            terms, signs = body.operands(piece_first, piece_last, TERMS)
            yield from left_out(body, terms, signs, "-", "-")


def innermost(body, first, last, deepest):
    """The operands of an expression after splitting at every level up to LEVELS[deepest]."""
    pieces = [(first, last)]
    for level in LEVELS[:deepest + 1]:
        pieces = [piece for a, b in pieces for piece in body.operands(a, b, level)[0]]
    return [(a, b) for a, b in pieces if a < b]


def left_out(body, operands, signs, prefix, inverse):
    tokens = body.tokens
    for n, (first, last) in enumerate(operands):
        if not signs or first == last:
            continue
        if n > 0:
            yield tokens[signs[n - 1]].start, tokens[last - 1].end, ""
        else:
            yield tokens[first].start, tokens[signs[0]].end, prefix if tokens[signs[0]].text == inverse else ""


def call(body, context):
    """A function of one argument left out (abs, sqrt), or a member function at an expression's end (normalized)."""
    for i, token in enumerate(body.tokens[:-1]):
        if token.kind != "name" or body.tokens[i + 1].text != "(":
            continue
        closing = body.partners[i + 1]
        arguments = body.arguments(i + 1)
        before = body.tokens[i - 1].text if i else ""
        if before == "." and not arguments:
            yield body.tokens[i - 1].start, body.tokens[closing].end, ""
        elif before == "::" and len(arguments) == 1 and body.tokens[i - 2].text == "std":
            yield body.tokens[i - 2].start, body.tokens[i].end, ""


def logic(body, context):
    """A condition of several left out, 'and' for 'or', a 'not' left out."""
    for i, token in enumerate(body.tokens):
        if token.text == "!":
            yield token.start, token.end, ""
        elif token.text in ("&&", "||") and body.is_binary(i):
            yield token.start, token.end, "||" if token.text == "&&" else "&&"
    for first, last in body.expressions():
        for n, level in enumerate(LEVELS[:2]):
            for a, b in innermost(body, first, last, n - 1):
                operands, signs = body.operands(a, b, level)
                yield from left_out(body, operands, signs, "", "")


def choice(body, context):
    """One side of c ? a : b for both."""
    for i, token in enumerate(body.tokens):
        if token.text == "?":
            first = i
            while first > 0 and not stops_condition(body, first - 1):
                first = body.partners[first - 1] if body.partners.get(first - 1, first) < first - 1 else first - 1
            for fixed in ("true", "false"):
                yield body.tokens[first].start, body.tokens[i - 1].end, fixed


def stops_condition(body, i):
    token = body.tokens[i]
    return token.text in (",", ";", "(", "{", "[", "}", "?", ":", "return", "=", "+=", "-=", "*=", "/=")


def twin(body, context):
    """A name taken for the one that stands beside it; a coordinate for the next."""
    others = {}
    for a, b in TWINS:
        others.setdefault(a, []).append(b)
        others.setdefault(b, []).append(a)
    for i, token in enumerate(body.tokens):
        if token.kind != "name":
            continue
        before = body.tokens[i - 1].text if i else ""
        if before == "." and token.text in COORDINATES and body.tokens[i + 1].text == "(":
            yield token.start, token.end, COORDINATES[token.text]
        elif before in (".", "->", "::") and not (token.text in EXCHANGED and before == "::"):
            for other in others.get(token.text, ()):
                yield token.start, token.end, other
        elif token.text.endswith("_"):
            for other in others.get(token.text, ()):
                yield token.start, token.end, other


VALUES = {"relation": relation, "sign": sign, "product": product, "minmax": minmax, "constant": constant, "factor": factor,
          "term": term, "call": call, "logic": logic, "choice": choice, "twin": twin}
