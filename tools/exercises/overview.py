"""The grades of many hand-ins: a table, CSV, and one HTML page."""

import csv
import html
import io

from course_lib.terminal import table
from exercises.reports import details, errors_and_notes, points_text, shown_name, summary

PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Grades</title>
<style>
body {{ font: 16px/1.5 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; background: #fff }}
table {{ border-collapse: collapse }}
th, td {{ border: 1px solid #ccc; padding: .2em .6em; text-align: left; vertical-align: top }}
td.points {{ text-align: right }}
tr.passed td {{ background: #efe }}
pre {{ white-space: pre-wrap; margin: .5em 0 }}
.look {{ color: #a00 }}
details {{ margin: 1em 0 }}
@media (prefers-color-scheme: dark) {{
  body {{ color: #ddd; background: #1b1b1b }}
  th, td {{ border-color: #555 }}
  tr.passed td {{ background: #142 }}
  .look {{ color: #f88 }}
}}
</style>
<h1>Grades</h1>
<p>{chapters}; sandbox: {sandbox}</p>
{rows}
{sections}
</html>
"""


def heads(catalogs):
    """One column a chapter, named like it."""
    return [catalog.chapter for catalog in catalogs]


def points_of(hand_in, catalogs):
    """The points chapter by chapter; nothing where it could not be graded."""
    known = {grade.chapter: grade.points for grade in hand_in.grades}
    return [known.get(catalog.chapter, "") for catalog in catalogs]


def remark(hand_in):
    """What a person should know of it, in one line."""
    if hand_in.error:
        return f"not graded: {hand_in.error}"
    parts = [f"{grade.chapter}: {grade.error}" for grade in hand_in.grades if grade.error]
    parts += [line for grade in hand_in.grades for line in (*grade.notes, *grade.looks)]
    return "; ".join(dict.fromkeys(parts))


def to_look_at(hand_in):
    return sum(len(grade.looks) for grade in hand_in.grades)


def to_table(hand_ins, catalogs):
    rows = [[hand_in.name, *points_of(hand_in, catalogs), "" if hand_in.error else hand_in.points,
             "not graded" if hand_in.error else "look" if to_look_at(hand_in) else ""] for hand_in in hand_ins]
    columns = len(catalogs) + 1
    return table(rows, ["hand-in", *heads(catalogs), "points", ""], right=tuple(range(1, columns + 1)))


def to_csv(hand_ins, catalogs, sandbox):
    """A row a hand-in, for a spreadsheet; no cell of it is taken for a formula."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["hand_in", *heads(catalogs), "points", "max_points", "to_look_at", "sandbox", "remarks"])
    most = sum(catalog.points for catalog in catalogs)
    for hand_in in hand_ins:
        writer.writerow([plain(hand_in.name), *points_of(hand_in, catalogs), "" if hand_in.error else hand_in.points, most,
                         to_look_at(hand_in), sandbox, plain(remark(hand_in))])
    return text.getvalue().encode("utf-8", "replace")


def plain(cell):
    """Somebody else's text as a cell of a spreadsheet."""
    cell = " ".join(cell.split())
    return "'" + cell if cell.startswith(("=", "+", "-", "@")) else cell


def to_html(hand_ins, catalogs, sandbox):
    """All on one page: a table of points, and below it each hand-in's tests."""
    head = "".join(f"<th>{html.escape(text)}" for text in ("hand-in", *heads(catalogs), "points", "remarks"))
    rows = [f"<tr>{head}"] + [row(number, hand_in, catalogs) for number, hand_in in enumerate(hand_ins, start=1)]
    page = PAGE.format(chapters=html.escape(", ".join(heads(catalogs))), sandbox=html.escape(sandbox),
                       rows="<table>\n" + "\n".join(rows) + "\n</table>",
                       sections="\n".join(section(number, hand_in) for number, hand_in in enumerate(hand_ins, start=1)))
    return page.encode("utf-8", "replace")


def row(number, hand_in, catalogs):
    values = [*points_of(hand_in, catalogs), "" if hand_in.error else hand_in.points]
    points = "".join(f'<td class="points">{value}' for value in values)
    kind = ' class="look"' if to_look_at(hand_in) or hand_in.error else ""
    return f'<tr><td><a href="#h{number}">{html.escape(hand_in.name)}</a>{points}<td{kind}>{html.escape(remark(hand_in))}'


def section(number, hand_in):
    # The place that the table links to lies inside, so that a browser opens what is closed around it.
    lines = [f'<details><summary>{html.escape(hand_in.name)}</summary>', f'<div id="h{number}">']
    if hand_in.error:
        lines.append(f"<p>not graded: {html.escape(hand_in.error)}</p>")
    for grade in hand_in.grades:
        lines += [f"<h3>{html.escape(summary(grade))}</h3>"]
        lines += [f"<pre>{html.escape(text)}</pre>" for text in errors_and_notes(grade) if text]
        lines += [f'<p class="look">look: {html.escape(look)}</p>' for look in grade.looks]
        lines += ["<table>", *map(test_row, grade.outcomes), "</table>"]
    return "\n".join([*lines, "</div></details>"])


def test_row(graded):
    outcome = graded.outcome
    kind, said = ("passed", "") if outcome.passed else ("lost", f"<pre>{html.escape(details(graded))}</pre>")
    return (f'<tr class="{kind}"><td>{html.escape(shown_name(graded.test))}<td>{graded.test.exercise}'
            f'<td class="points">{points_text(graded.points, graded.test.points)}<td>{outcome.state}{said}')
