"""What a lesson says of its tables is what stands in them.

Below a paragraph, a list or a table of a lesson a comment, which no page shows, says where its numbers come from:

    <!-- numbers
    1.4 times = quantity.csv: SPPM by pass ① | error in the caustic after 128 passes
    a ninth (0.11) = quantity.csv: …
    over a thousand times (over 1000) = quantity.csv: …
    about a third more (about 1.3) = speed_accuracy.csv time: projection | distance=1 ÷ textbook quadratic | distance=1
    -->

Left is what the paragraph says, word for word, and in brackets what that is in digits where it isn't. Right are the table, its
column (`value` where none is named; failures / trials where a table has these) and cells that one row alone has; a second
row's cells after ÷ mean the quotient. `mean of` before the table takes the geometric mean of all rows that have the cells. A page
of docs/ names the chapter's folder too: 04_kd_tree/rays.csv.

A number agrees when the value rounds to it; `about` allows a quarter, `over` is the least value, `under` the greatest, signs aside.
"""

import csv
import math
import re
import tempfile
import unittest
from pathlib import Path

from course_lib.chapters import all_chapters
from course_lib.paths import ROOT

BLOCK = re.compile(r"^<!-- numbers\n(.*?)\n-->$", re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r"(?P<text>.+?)(?: \((?P<stated>[^()]+)\))? = "
                   r"(?P<mean>mean of )?(?P<table>[\w/]+\.csv)(?: (?P<column>\w+))?: (?P<rows>.+)")
STATED = re.compile(r"(?P<bound>about|over|under)?\s*(?P<number>[-−]?\d[\d,]*(?:\.\d+)?(?:e-?\d+)?)")
ABOUT = 0.25  # of the number: what is measured by the clock differs from day to day
PARAGRAPH = re.compile(r"(?:.+\n)+")  # or a list, a table, a formula: what stands between two empty lines


def values_of(table, column, cells):
    """The values in a column of all rows that have these cells."""
    found = []
    with open(table, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if set(cells) <= set(row.values()):
                found.append(number_in(row, column))
    return found


def number_in(row, column):
    if column:
        return float(row[column])
    return float(row["value"]) if "value" in row else int(row["failures"]) / int(row["trials"])


def looked_up(entry, folder):
    """What the table has for an entry of a block."""
    values = []
    for part in entry["rows"].split(" ÷ "):
        cells = [cell.strip() for cell in part.split(" | ")]
        found = values_of(folder / entry["table"], entry["column"], cells)
        if not found or len(found) > 1 and not entry["mean"]:
            raise LookupError(f"{entry['table']} has {len(found)} rows with {cells}")
        values.append(math.exp(sum(map(math.log, found)) / len(found)) if entry["mean"] else found[0])
    return values[0] if len(values) == 1 else values[0] / values[1]


def agrees(stated, value):
    """Whether a value is what was stated: 1.4 is all that rounds to it, 1,300 all that rounds to it in hundreds."""
    matched = STATED.search(stated)
    if not matched:
        raise ValueError(f"no number in {stated!r}")
    digits = matched["number"].replace(",", "").replace("−", "-")
    number = float(digits)
    if matched["bound"] == "about":
        return abs(value - number) <= ABOUT * abs(number)
    if matched["bound"]:
        return value >= number if matched["bound"] == "over" else abs(value) <= number
    return abs(value - number) <= 0.5000001 * place(digits)


def place(digits):
    """The value of one in the last place that counts: 0.1 of 1.4, 100 of 1300, 1 of 7."""
    mantissa, _, exponent = digits.lstrip("-").partition("e")
    scale = 10.0 ** int(exponent or 0)
    if "." in mantissa:
        return scale * 10.0 ** -len(mantissa.partition(".")[2])
    return scale * 10.0 ** (len(mantissa) - len(mantissa.rstrip("0"))) if float(mantissa) else scale


def problems(text, folder):
    """What is wrong with the numbers of a lesson whose tables lie in a folder."""
    found = []
    for paragraph in PARAGRAPH.findall(text + "\n"):
        block = BLOCK.search(paragraph)
        said = " ".join(paragraph[:block.start() if block else None].split())
        if block:
            found += [problem for line in block[1].splitlines() for problem in problems_of(line, said, folder)]
        elif "\n<!-- numbers" in "\n" + paragraph:
            found.append(f"not understood: {paragraph}")
    return found


def problems_of(line, said, folder):
    """What is wrong with one line of a block below a paragraph that says this."""
    entry = ENTRY.fullmatch(line)
    if not entry:
        return [f"not understood: {line}"]
    if entry["text"] not in said:
        return [f"the paragraph doesn't say {entry['text']!r}: {line}"]
    try:
        value = looked_up(entry, folder)
        right = agrees(entry["stated"] or entry["text"], value)
    except (LookupError, OSError, ValueError) as error:
        return [f"{error}: {line}"]
    return [] if right else [f"the table has {value:.6g}: {line}"]


class Numbers(unittest.TestCase):
    def test_lessons_say_what_their_tables_have(self):
        for chapter in all_chapters():
            with self.subTest(chapter=chapter):
                text = (ROOT / "chapters" / chapter / "README.md").read_text(encoding="utf-8")
                self.assertIn("<!-- numbers", text)
                self.assertEqual(problems(text, ROOT / "figures" / chapter), [])

    def test_other_pages_do(self):
        for page in (ROOT / "docs").glob("*.md"):
            with self.subTest(page=page.name):
                self.assertEqual(problems(page.read_text(encoding="utf-8"), ROOT / "figures"), [])

    def test_a_number_agrees_with_what_rounds_to_it(self):
        for stated, value in (("1.4 times", 1.4369), ("1.4", 1.35), ("about 8,000", 8151), ("over 1e12", 6.2e12), ("under 0", 0.0),
                              ("1,300", 1349), ("−0.3 %", -0.304), ("2.0", 1.996)):
            self.assertTrue(agrees(stated, value), (stated, value))
        for stated, value in (("1.3 times", 1.4369), ("1.4", 1.46), ("about 20", 10), ("over 8", 7.9), ("under 0", 1), ("under 0.05", -0.06),
                              ("1,300", 1351), ("−0.3 %", 0.304), ("2.0", 1.94)):
            self.assertFalse(agrees(stated, value), (stated, value))

    def test_what_the_table_does_not_have_is_found(self):
        table = "method,case,value\na,x,1.44\na,y,2\nb,x,0.5\n"
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "quantity.csv").write_text(table, encoding="utf-8")
            for entry, problem in (("1.4 times = quantity.csv: a | x", None), ("1.3 = quantity.csv: a | x", "the table has 1.44"),
                                   ("1.4 times = quantity.csv: a", "2 rows"), ("1.4 times = quantity.csv: c", "0 rows"),
                                   ("1.4 times = other.csv: a | x", "other.csv"), ("8 = quantity.csv: a | x", "doesn't say '8'"),
                                   ("1.4 times", "not understood"), ("2.9 (2.88) = quantity.csv: a | x ÷ b | x", None),
                                   ("1.7 = mean of quantity.csv: a", None)):
                found = problems(f"It takes 1.4 times, 1.3, 1.7 or\n2.9.\n<!-- numbers\n{entry}\n-->\n", Path(folder))
                self.assertEqual(len(found), problem is not None, (entry, found))
                self.assertIn(problem or "", "".join(found), entry)
