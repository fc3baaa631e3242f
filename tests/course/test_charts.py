"""What the charts show can be told apart: no two methods of a legend have the same mark, colour and dashes.

Each gnuplot script is run on the committed data with SVG instead of PNG as its output, and what it drew is read.
"""

import csv
import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from course_lib.chapters import all_chapters
from course_lib.paths import FIGURES, ROOT

SHARED = ROOT / "common/figure"
SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"


def quoted(text):
    return "'" + str(text).replace("'", "''") + "'"


def fragile_methods(table):
    """The methods of a failure.csv that failed, as gnuplot's array."""
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    names = list(dict.fromkeys(row["method"] for row in rows if int(row["failures"]) > 0))
    return "; ".join([f"array fragile[{len(names)}]",
                      *(f"fragile[{i}] = {quoted(name)}" for i, name in enumerate(names, start=1))])


def charts():
    """(script, folder of its data, settings) of every chart that is drawn from committed data."""
    for chapter in all_chapters():
        folder = FIGURES / chapter
        scripts = sorted((ROOT / "chapters" / chapter).rglob("*.gp"))
        for script in scripts:
            yield script, folder, ""
        table = folder / "failure.csv"
        marks = SHARED / "failure_marks.gp"
        if marks.is_file() and table.is_file() and not any(script.name == "failure.gp" for script in scripts):
            yield marks, folder, fragile_methods(table)


def drawn(script, folder, settings):
    """The SVG that the script draws."""
    with tempfile.TemporaryDirectory(prefix="caustic-charts-") as name:
        copies = []
        for source in (SHARED / "style.gp", script):
            copy = Path(name) / source.name
            copy.write_text(source.read_text(encoding="utf-8").replace("pngcairo", "svg"), encoding="utf-8")
            copies.append(copy)
        output = Path(name) / "chart.svg"
        command = ["gnuplot", "-e", f"folder={quoted(folder)}; output={quoted(output)}; {settings}", *copies]
        finished = subprocess.run(command, capture_output=True, text=True)
        if finished.returncode != 0 or not output.is_file():
            raise AssertionError(f"{script}: {finished.stderr.strip()}")
        return ElementTree.parse(output).getroot()


def marks_and_lines(element, colour="black"):
    """(element, its colour) of all that is drawn below an element; texts aside."""
    colour = element.get("color") if element.get("color", "currentColor") != "currentColor" else colour
    if element.tag in (SVG + "use", SVG + "path", SVG + "polygon"):
        paints = [element.get(name) for name in ("color", "stroke", "fill")]
        yield element, next((paint for paint in paints if paint and paint.startswith("rgb")), colour)
    for child in element:
        yield from marks_and_lines(child, colour)


def look_of(plot):
    """Shape of a plot's marks, colour and dashes."""
    drawn_here = list(marks_and_lines(plot))
    shape = next((element.get(HREF) for element, _ in drawn_here if element.tag == SVG + "use"), None)
    dashes = next((element.get("stroke-dasharray", "solid") for element, _ in drawn_here if element.tag == SVG + "path"), None)
    return shape, drawn_here[0][1] if drawn_here else None, dashes


def legend(svg):
    """(panel, title, look) of all plots that a legend names: each is a group whose title stands in it as a text too.

    Panels of one picture have legends of their own; gnuplot numbers their plots 1, 2… and then 1a, 2a…
    """
    for group in svg.iter(SVG + "g"):
        title = group.findtext(SVG + "title", "").strip()
        texts = ("".join(text.itertext()).strip() for text in group.iter(SVG + "text"))
        if group.get("id", "").startswith("gnuplot_plot_") and title and title in texts:
            yield group.get("id").removeprefix("gnuplot_plot_").lstrip("0123456789"), title, look_of(group)


class Charts(unittest.TestCase):
    def test_no_legend_is_ambiguous(self):
        named = 0
        for script, folder, settings in charts():
            with self.subTest(script=str(script.relative_to(ROOT)), data=folder.name):
                seen = {}
                for panel, title, look in legend(drawn(script, folder, settings)):
                    named += 1
                    other = seen.setdefault((panel, look), title)
                    self.assertEqual(other, title, f"both look like {look}")
        self.assertGreater(named, 30, "are titles not found any more?")

    def test_a_legend_with_two_alike_is_found(self):
        with tempfile.TemporaryDirectory(prefix="caustic-charts-") as name:
            folder = Path(name)
            (folder / "data.csv").write_text("x,y,z\n1,2,3\n2,3,4\n")
            script = folder / "alike.gp"
            script.write_text("set terminal pngcairo\nfile = folder.'/data.csv'\nplot file using 1:2 with points pt 5 lc rgb "
                              "'#d55e00' title 'one', file using 1:3 with points pt 5 lc rgb '#d55e00' title 'two'\n")
            looks = {title: look for _, title, look in legend(drawn(script, folder, ""))}
            self.assertEqual(set(looks), {"one", "two"})
            self.assertEqual(looks["one"], looks["two"])


if __name__ == "__main__":
    unittest.main()
