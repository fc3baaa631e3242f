"""Every drawn path of Debian's adwaita-icon-theme after its transforms: ours beside Chromium's, point by point.

Which paths are drawn, points at equal distances along each (getPointAtLength through getScreenCTM) and lengths where a
transform only turns, moves and scales. The files of tests/01_bezier_curves/field are compared too, and a circle, whose
length is known, to see whose arcs are to blame for what remains. Fails when a path is drawn by one of the two alone, a
point is off by more than 0.05 % of its path's size, a length by more than 0.1 %, or ours refuses more than 1 % of the
files.
"""

import json
import math
import subprocess
import tempfile
from pathlib import Path

from course_lib import cmake
from course_lib.benchmarks import QUANTITY, end_with, option_parser, save_quantities, save_table
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import FIGURES, ROOT, program, shown
from course_lib.terminal import Step, say
from docs.browser import Browser

CHAPTER = "01_bezier_curves"
TABLE = FIGURES / CHAPTER / "svg_paths.csv"
CASES = ("icon theme and files from the field", "circle")
NEEDS = ("chromium", "adwaita-icon-theme")
ICONS = Path("/usr/share/icons/Adwaita")
FIELD = ROOT / "tests" / CHAPTER / "field"
LARGEST_DISTANCE = 5e-4
LARGEST_LENGTH = 1e-3
CIRCLE_RADIUS = 7
CIRCLE = "M7 0A7 7 0 0 1 -7 0A7 7 0 0 1 7 0z"


class Tally:
    """What has been compared, and where the worst is."""

    def __init__(self):
        self.files = self.paths = self.moved = 0
        self.refused = []
        self.wrong = []
        self.distance = (0, "")
        self.length = (0, "")

    def add(self, name, ours, answer):
        self.files += 1
        if answer["paths"] != len(ours):
            self.wrong.append(f"{name}: {len(ours)} paths are drawn here, {answer['paths']} in Chromium")
            return
        for number, path in enumerate(answer["compared"], start=1):
            self.paths += 1
            self.moved += path["moved"]
            distance = path["distance"] if path["distance"] is not None else math.inf  # JSON has no infinity
            self.distance = max(self.distance, (distance, f"{name}#{number}"))
            self.length = max(self.length, (path.get("length") or 0, f"{name}#{number}"))
            if distance > LARGEST_DISTANCE or (path.get("length") or 0) > LARGEST_LENGTH:
                self.wrong.append(f"{name}#{number}: points off by {distance:.2e}, length by {path.get('length')}")


def control_points(file):
    """Of each path that we draw, its subpaths' segments; the reason when the file is refused."""
    finished = subprocess.run([program(CHAPTER), "--inspect", str(file)], capture_output=True, text=True)
    if finished.returncode == 2:
        reason = finished.stderr.strip()
        return ([], None) if "draws no path" in reason else (None, reason)
    if finished.returncode != 0:
        raise CourseError(f"{file}: {finished.stderr.strip()}")
    paths = json.loads(finished.stdout)["paths"]
    return [[subpath["segments"] for subpath in path["subpaths"]] for path in paths], None


def compare(files, browser, script):
    tally = Tally()
    browser.open("data:text/html,<!DOCTYPE html><meta charset=utf-8><body>")
    for file in files:
        ours, reason = control_points(file)
        if ours is None:
            tally.refused.append(reason)
            continue
        text = file.read_text(encoding="utf-8")
        tally.add(file.name, ours, browser.evaluate(f"{script}({json.dumps(text)}, {json.dumps(ours)})"))
    return tally


def circles(browser):
    """A circle's length by each, relative to the truth."""
    with tempfile.TemporaryDirectory(prefix="caustic-svg-") as name:
        file = Path(name) / "circle.svg"
        file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg"><path d="{CIRCLE}"/></svg>')
        browser.open(file)
        chromium = browser.evaluate("document.querySelector('path').getTotalLength()")
        finished = subprocess.run([program(CHAPTER), "--inspect", str(file)], capture_output=True, text=True, check=True)
    ours = json.loads(finished.stdout)["paths"][0]["length"]
    exact = 2 * math.pi * CIRCLE_RADIUS
    return ours / exact - 1, chromium / exact - 1


def measured(tally, circle):
    case = "icon theme and files from the field"
    reference = "Chromium"
    return [("ours", f"{case}: files", tally.files, "files", ""),
            ("ours", f"{case}: refused with a reason", len(tally.refused), "files", ""),
            ("ours", f"{case}: drawn paths", tally.paths, "paths", reference),
            ("ours", f"{case}: of them moved by a transform", tally.moved, "paths", reference),
            ("ours", f"{case}: largest distance of a point", tally.distance[0], "of the path's size", reference),
            ("ours", f"{case}: largest difference of a length", tally.length[0], "of the length", reference),
            ("ours", "circle: length off by", circle[0], "of the length", "2 pi r"),
            ("Chromium", "circle: length off by", circle[1], "of the length", "2 pi r")]


def main():
    chosen = option_parser("svg", __doc__, TABLE).parse_args()
    ensure_packages("test")
    cmake.build(targets=[CHAPTER])
    if not ICONS.is_dir():
        raise CourseError(f"{ICONS} is missing; ./course setup --group test installs adwaita-icon-theme")
    files = [*sorted(ICONS.rglob("*.svg")), *sorted(FIELD.glob("*.svg"))]
    script = Path(__file__).with_name("compare.js").read_text()
    with Browser(timeout=300) as browser, Step(f"compare {len(files)} files"):
        tally = compare(files, browser, script)
        circle = circles(browser)
    rows = measured(tally, circle)
    save_table(chosen.table, [QUANTITY, *rows])
    save_quantities(chosen.csv, rows)

    say(f"{tally.paths} drawn paths of {tally.files} files, {tally.moved} moved by transforms; the largest distance is "
        f"{tally.distance[0]:.2e} of the path's size, in {tally.distance[1]}, the largest difference of lengths "
        f"{tally.length[0]:.2e}, in {tally.length[1]}; in {shown(chosen.table)}")
    say(f"a circle's length is off by {circle[0]:+.1e} here and by {circle[1]:+.1e} in Chromium, which makes fewer, longer "
        "cubics of an arc")
    for line in tally.refused + tally.wrong:
        say(line)
    return 1 if tally.wrong or 100 * len(tally.refused) > len(files) else 0


if __name__ == "__main__":
    end_with(main, "svg")
