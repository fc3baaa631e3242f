"""Operators on what is done, in which order and how often."""


def statement(body, context):
    """A statement left out."""
    tokens = body.tokens
    for s in body.statements:
        if s.kind in ("expression", "jump", "if", "for", "while", "do", "switch") and not s.otherwise:
            yield tokens[s.first].start, tokens[s.last - 1].end, ";"
        elif s.kind == "return" and s.last < len(tokens) and tokens[s.last].text != "}":
            yield tokens[s.first].start, tokens[s.last - 1].end, ";"


def branch(body, context):
    """A condition that is always or never met."""
    for s in body.statements:
        if s.kind not in ("if", "while"):
            continue
        first, last = s.header
        start, end = body.tokens[first].start, body.tokens[last - 1].end
        if s.kind == "if":
            yield start, end, "true"
            if s.otherwise:
                yield start, end, "false"
        yield start, end, f"!({body.source[start:end]})"


def loop(body, context):
    """A loop that ends one earlier, or after its first round."""
    tokens = body.tokens
    for s in body.statements:
        if s.kind == "for":
            parts = [i for i in range(*s.header) if tokens[i].text == ";"]
            if len(parts) == 2:
                yield from shorter(body, parts[0] + 1, parts[1])
        if s.kind in ("for", "while"):
            first, last = s.body
            inside = body.source[tokens[first].start:tokens[last - 1].end]
            yield tokens[first].start, tokens[last - 1].end, f"{{ {inside} break; }}"


def shorter(body, first, last):
    for i in range(first, last):
        if body.tokens[i].text in ("<", "<=") and body.is_binary(i):
            yield body.tokens[first].start, body.tokens[first].start, "1 + "
        elif body.tokens[i].text == ">" and body.is_binary(i):
            yield body.tokens[i].end, body.tokens[i].end, " 1 +"


def early(body, context):
    """What the end returns is returned before it is ready."""
    top = [s for s in body.statements if not any(o.first < s.first and s.last <= o.last or
                                                  (o.first <= s.first and s.last < o.last) for o in body.statements)]
    top = [s for s in top if s.kind != "label"]
    if len(top) < 3 or top[-1].kind != "return":
        return
    result = body.text(top[-1].first, top[-1].last)
    for before, s in zip(top[:-1], top[1:-1]):
        place = body.tokens[s.first].start
        if before.kind != "return":
            yield place, place, f"{result} "


def exchange(body, context):
    """Two arguments that stand beside each other exchanged."""
    tokens = body.tokens
    for opening, first, _ in body.groups():
        if opening < 0 or tokens[opening].text not in "({" or (first, body.partners[opening]) in body.blocks:
            continue
        before = tokens[opening - 1].text if opening else ""
        if before in ("for", "if", "while", "switch"):
            continue
        if before in ("min", "max"):
            continue  # differ for NaN alone
        pieces = body.arguments(opening)
        for (a, b), (c, d) in zip(pieces[:-1], pieces[1:]):
            one, other = body.text(a, b), body.text(c, d)
            if one != other:
                between = body.source[tokens[b - 1].end:tokens[c].start]
                yield tokens[a].start, tokens[d - 1].end, f"{other}{between}{one}"


FLOW = {"statement": statement, "branch": branch, "loop": loop, "early": early, "exchange": exchange}
