"""Line coverage of the shared library by the chapters' executables alone: what they never run has no place in common/.
Run are the drafts of all figures, and the commands that inspect files.

Error paths are left out, for good input never gets there. A line belongs to one when it is part of
- a statement that throws, or that calls a function declared [[noreturn]],
- the block of an `if`, `else` or `case` that ends with such a statement,
- a `catch` block.
"""

import concurrent.futures
import glob
import json
import re
import shutil
import subprocess

from course_lib import cmake
from course_lib.chapters import all_chapters
from course_lib.cpp_source import COMMENT_OR_TEXT
from course_lib.errors import CourseError
from course_lib.paths import ROOT, build_dir, cores, program
from course_lib.process import output_of, run
from course_lib.terminal import Step, say

LEAST = 95.0  # per cent of the lines of common/, error paths aside
PRESET = "coverage"
# What chapters inspect besides drawing, by their --inspect: our files and real ones of the test packages.
INSPECTED = {"01_bezier_curves": ("assets/profiles/*", "/usr/share/icons/Adwaita/**/*.svg"), "04_kd_tree": ("assets/meshes/*",)}
MOST_INSPECTED = 100  # files for each pattern, spread evenly

NO_RETURN = re.compile(r"\[\[noreturn\]\][^;{(]*?\b(\w+)\s*\(")
BRANCH_HEAD = re.compile(r"(\bif\b[^;{}]*|\belse\s*|\bcase\b[^;{}]*:\s*)$")
CATCH_HEAD = re.compile(r"\bcatch\s*\([^{}]*\)\s*$")


def blank(match):
    """As many characters, line breaks kept: positions stay what they are."""
    return re.sub(r"[^\n]", " ", match[0])


def blocks(text):
    """(position of {, position of }) of each block."""
    found, opened = [], []
    for position, character in enumerate(text):
        if character == "{":
            opened.append(position)
        elif character == "}" and opened:
            found.append((opened.pop(), position))
    return found


def error_lines(source, no_return=()):
    """The numbers of the lines of a C++ source that belong to error paths."""
    text = COMMENT_OR_TEXT.sub(blank, source)
    leaves = re.compile(r"\bthrow\b" + "".join(rf"|\b{name}\s*\(" for name in sorted(no_return)))
    spans = []
    for match in leaves.finditer(text):
        end = text.find(";", match.start())
        spans.append((match.start(), len(text) if end < 0 else end))
    ends = {end for _, end in spans}
    for start, end in blocks(text):
        head = text[max(0, start - 400):start]
        last = text.rfind(";", start, end)
        ends_by_leaving = last in ends and not text[last + 1:end].strip()
        if CATCH_HEAD.search(head) or (ends_by_leaving and BRANCH_HEAD.search(head)):
            spans.append((start, end))
    lines = set()
    for start, end in spans:
        lines.update(range(text.count("\n", 0, start) + 1, text.count("\n", 0, end) + 2))
    return lines


def no_return_functions(sources):
    return {name for source in sources for name in NO_RETURN.findall(source)}


def measured_lines(report, root=ROOT):
    """(file, line, count) of each line of common/ that gcovr counts, error paths left out."""
    files = {entry["file"]: entry["lines"] for entry in report["files"]}
    sources = {name: (root / name).read_text() for name in files}
    no_return = no_return_functions(sources.values())
    for name, lines in files.items():
        left_out = error_lines(sources[name], no_return)
        for line in lines:
            if line["line_number"] not in left_out and not line.get("gcovr/noncode"):
                yield name, line["line_number"], line["count"]


def chapter_coverage():
    """Builds the chapters with counters, draws drafts, and reads the counters. Returns a note with the share."""
    chapters = all_chapters()
    cmake.build(PRESET, chapters, title="build the chapters with counters")
    for counters in build_dir(PRESET).rglob("*.gcda"):
        counters.unlink()
    out = build_dir(PRESET) / "figures"
    shutil.rmtree(out, ignore_errors=True)
    with Step("draw the chapters") as step, concurrent.futures.ThreadPoolExecutor(cores()) as pool:
        drawn = [pool.submit(draw, chapter, out) for chapter in chapters]
        for done, finished in enumerate(concurrent.futures.as_completed(drawn), start=1):
            finished.result()
            step.progress(done, len(chapters))
    return verdict(list(measured_lines(gcovr_report())))


def draw(chapter, out):
    """Draws a chapter's drafts by one thread (several would fight for the counters) and inspects files."""
    output_of([program(chapter, PRESET), "--out", out, "--threads", 1])
    for path in inspected(chapter):
        # Files that are refused count too: their error paths are left out anyway.
        subprocess.run([program(chapter, PRESET), "--inspect", path], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)


def inspected(chapter, root=ROOT):
    """The files that a chapter inspects."""
    for pattern in INSPECTED.get(chapter, ()):
        files = sorted(glob.glob(str(root / pattern), recursive=True))
        yield from files[::1 + len(files) // MOST_INSPECTED]


def gcovr_report():
    path = build_dir(PRESET) / "coverage.json"
    command = ["gcovr", "--root", ROOT, "--filter", "common/", "--json", path, build_dir(PRESET)]
    finished = run(command, "read the counters", cwd=ROOT)
    if finished.code != 0:
        raise CourseError(f"gcovr failed: {finished.output.strip().splitlines()[-1]}")
    return json.loads(path.read_text())


def verdict(lines):
    """A note with the share of lines that ran. @throws CourseError when it is too low; names the lines that never ran"""
    if not lines:
        raise CourseError("gcovr counted no line of common/; was the coverage preset built from this tree?")
    never = [(name, number) for name, number, times in lines if times == 0]
    share = 100 * (len(lines) - len(never)) / len(lines)
    by_file = {}
    for name, number in never:
        by_file.setdefault(name, []).append(str(number))
    for name, numbers in sorted(by_file.items()):
        say(f"  no chapter runs {name}:{','.join(numbers)}")
    note = f"{share:.1f} % of {len(lines)} lines"
    if share < LEAST:
        raise CourseError(f"the chapters run {note} of common/, at least {LEAST:.0f} % are asked for; "
                          "remove what no chapter runs, or let one show it")
    return note
