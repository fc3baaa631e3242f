"""Lengths of 50 SVG paths of Debian's adwaita-icon-theme: ours beside Chromium's getTotalLength().

The paths are chosen by a hash of their names, so always the same ones, among those that no transform touches (Chromium
measures in the path's own units). Writes figures/01_bezier_curves/svg_lengths.csv; fails when two lengths differ by
more than 0.1 %. Both also measure a circle, whose length is known, to see whose arcs are to blame for what remains.
"""

import csv
import hashlib
import html
import json
import math
import os
import subprocess
import sys
import tempfile
from collections import namedtuple
from pathlib import Path
from xml.etree import ElementTree

from course_lib import cmake
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import FIGURES, program, shown
from course_lib.terminal import Step, say
from docs.browser import Browser

CHAPTER = "01_bezier_curves"
ICONS = Path("/usr/share/icons/Adwaita")
COUNT = 50
TOLERANCE = 1e-3
SVG = "{http://www.w3.org/2000/svg}"
CIRCLE_RADIUS = 7
CIRCLE = "M7 0A7 7 0 0 1 -7 0A7 7 0 0 1 7 0z"
DRAWN_CONTAINERS = {SVG + name for name in ("svg", "g", "a", "switch")}

Candidate = namedtuple("Candidate", "file number data")
Row = namedtuple("Row", "file path length length_error chromium relative_difference")


def candidates(file):
    """The drawn paths of a file that no transform touches; `number` counts all drawn ones, as ours does after a #."""
    found = []
    number = 0
    stack = [(ElementTree.parse(file).getroot(), False)]
    while stack:
        element, transformed = stack.pop()
        transformed = transformed or "transform" in element.attrib or "transform:" in element.get("style", "")
        if element.tag == SVG + "path":
            number += 1
            if not transformed and element.get("d"):
                found.append(Candidate(file, number, element.get("d")))
        elif element.tag in DRAWN_CONTAINERS:
            stack.extend((child, transformed) for child in reversed(element))
    return found


def chosen():
    """The same paths on every run, spread over all files."""
    if not ICONS.is_dir():
        raise CourseError(f"{ICONS} is missing; ./course setup --group test installs adwaita-icon-theme")
    every = [candidate for file in sorted(ICONS.rglob("*.svg")) for candidate in candidates(file)]

    def order(candidate):
        return hashlib.sha256(f"{candidate.file.relative_to(ICONS)}#{candidate.number}".encode()).digest()

    return sorted(every, key=order)[:COUNT]


def our_length(path):
    """Length and its error bound, from --inspect."""
    command = [program(CHAPTER), "--inspect", f"{path.file}#{path.number}"]
    finished = subprocess.run(command, capture_output=True, text=True)
    if finished.returncode != 0:
        raise CourseError(finished.stderr.strip())
    (inspected,) = json.loads(finished.stdout)["paths"]
    return inspected["length"], inspected["lengthError"]


def chromium_lengths(data, folder):
    page = folder / "paths.html"
    drawn = "\n".join(f'<path d="{html.escape(text)}"/>' for text in data)
    page.write_text(f"<!DOCTYPE html><meta charset='utf-8'><svg>{drawn}</svg>")
    with Browser() as browser:
        browser.open(page)
        return browser.evaluate("[...document.querySelectorAll('path')].map(path => path.getTotalLength())")


def compared(path, chromium):
    length, error = our_length(path)
    difference = abs(length - chromium) / chromium if chromium > 0 else float("inf")
    return Row(path.file.relative_to(ICONS), path.number, length, error, chromium, difference)


def measured(paths):
    """The rows of the table, and the circle's two lengths: ours and Chromium's."""
    with tempfile.TemporaryDirectory(prefix="caustic-svg-") as name:
        folder = Path(name)
        circle = folder / "circle.svg"
        circle.write_text(f'<svg xmlns="http://www.w3.org/2000/svg"><path d="{CIRCLE}"/></svg>')
        *lengths, chromium_circle = chromium_lengths([path.data for path in paths] + [CIRCLE], folder)
        our_circle, _ = our_length(Candidate(circle, 1, CIRCLE))
    return [compared(*pair) for pair in zip(paths, lengths, strict=True)], our_circle, chromium_circle


def save(rows, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.part.csv")
    with temporary.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(Row._fields)
        writer.writerows(rows)
    temporary.replace(path)


def main():
    ensure_packages("test")
    cmake.build(targets=[CHAPTER])
    paths = chosen()
    with Step(f"measure {len(paths)} paths"):
        rows, our_circle, chromium_circle = measured(paths)
    table = FIGURES / CHAPTER / "svg_lengths.csv"
    save(rows, table)

    worst = max(rows, key=lambda row: row.relative_difference)
    say(f"{len(rows)} lengths in {shown(table)}; the largest relative difference is {worst.relative_difference:.2e}, "
        f"in {worst.file}#{worst.path}")
    exact = 2 * math.pi * CIRCLE_RADIUS
    say(f"a circle's length is off by {our_circle / exact - 1:+.1e} here and by {chromium_circle / exact - 1:+.1e} in "
        "Chromium, which makes fewer, longer cubics of an arc")
    beyond = [row for row in rows if row.relative_difference > TOLERANCE]
    for row in beyond:
        say(f"{row.file}#{row.path}: ours {row.length:.9g} +- {row.length_error:.1g}, Chromium's {row.chromium:.9g}")
    return 1 if beyond or len(rows) != COUNT else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CourseError as error:
        sys.exit(f"svg: {error}")
