"""Line coverage of the shared library by the chapters' executables alone: what they never run has no place in common/.
Run are the drafts of all figures, and the commands that the lessons name.

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

from course_lib import cmake
from course_lib.chapters import all_chapters
from course_lib.cpp_source import COMMENT_OR_TEXT
from course_lib.errors import CourseError
from course_lib.paths import ROOT, build_dir, cores, program
from course_lib.process import output_of, run
from course_lib.terminal import Step, say, table

LEAST = 95.0  # per cent of the lines of common/, error paths aside
PRESET = "coverage"
# What chapters are asked for besides figures: the commands of the lessons, the shorter the better. OUT is a folder that they may
# write to; a word with a * stands for each such file, ours and real ones of the test packages.
OUT = "<out>"
TO_OUT = ("--out", OUT, "--threads", 1)
COMMANDS = {
    "01_bezier_curves": (("--inspect", "assets/profiles/*"), ("--inspect", "/usr/share/icons/Adwaita/**/*.svg"),
                         ("--list",), ("--only", "de_casteljau", "--quality", "report", *TO_OUT)),
    "02_intersections": (("--leaks", 1000),),
    "03_bezier_surfaces": (("--profile", "assets/profiles/candlestick.svg#flame", *TO_OUT),
                           ("--profile", "assets/profiles/candlestick.svg#1", *TO_OUT), ("--roots", 1000), ("--lathe", 64)),
    "04_kd_tree": tuple(("--inspect", files) for files in (
        "assets/meshes/*", "/usr/share/assimp/models/OBJ/*.obj", "/usr/share/assimp/models/PLY/*.ply",
        "/usr/share/assimp/models/STL/*.stl", "/usr/share/assimp/models/glTF2/**/*.gl*")),
    "05_ray_tracing": (("--mesh", "assets/meshes/bunny_low.obj", *TO_OUT),),
    "07_path_tracing": (("--time", 0.1, "--scene", "caustic", *TO_OUT),),
    "09_sppm": (*2 * (("--render", "thumbnail", "--rule", "point", "--passes", 2, "--photons", 1000,
                       "--checkpoint", f"{OUT}/glass.state", *TO_OUT),),
                ("--errors", "peers_box", "--time", 8, "--out", OUT)),
    "10_sampling": (("--render", "box", "--sampler", "halton", "--rule", "uniform", "--paths", 16, "--width", 32, *TO_OUT),
                    *(("--render", "box", "--rule", "interval", "--paths", paths, "--width", 32,
                       "--checkpoint", f"{OUT}/box.state", *TO_OUT) for paths in (24, 32))),
    "11_effects": (*2 * (("--final", 64, "--passes", 2, "--photons", 1000, "--checkpoint", f"{OUT}/final.state", *TO_OUT),),
                   ("--scene", "assets/scenes/*", *TO_OUT)),
}
MOST_FILES = 100  # for each pattern, spread evenly

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
    """Measures, and judges. Returns a note with the share."""
    return verdict(measure())


def measure():
    """Builds the chapters with counters, draws drafts, and reads the counters: (file, line, count) of each line of common/."""
    chapters = all_chapters()
    cmake.build(PRESET, chapters, title="build the chapters with counters")
    forget_old_counters(build_dir(PRESET))
    out = build_dir(PRESET) / "figures"
    shutil.rmtree(out, ignore_errors=True)
    with Step("draw the chapters") as step, concurrent.futures.ThreadPoolExecutor(cores()) as pool:
        drawn = [pool.submit(draw, chapter, out) for chapter in chapters]
        for done, finished in enumerate(concurrent.futures.as_completed(drawn), start=1):
            finished.result()
            step.progress(done, len(chapters))
    return list(measured_lines(gcovr_report()))


def forget_old_counters(build):
    """Removes what earlier runs counted, and the notes of objects that are built no more."""
    ninja = (build / "build.ninja").read_text()
    for counters in build.rglob("*.gcda"):
        counters.unlink()
    for notes in build.rglob("*.gcno"):
        if str(notes.relative_to(build).with_suffix(".o")) not in ninja:
            notes.unlink()


def draw(chapter, out):
    """Draws a chapter's drafts by one thread (several would fight for the counters) and gives its commands."""
    output_of([program(chapter, PRESET), "--out", out, "--threads", 1])
    for words, may_refuse in commands(chapter, out):
        try:
            output_of([program(chapter, PRESET), *words])
        except CourseError:
            if not may_refuse:
                raise


def commands(chapter, out, root=ROOT):
    """(words, may refuse) of each command of a chapter besides its figures: others' files may be refused."""
    for words in COMMANDS.get(chapter, ()):
        words = [str(word).replace(OUT, str(out)) for word in words]
        pattern = next((word for word in words if "*" in word), None)
        files = sorted(glob.glob(str(root / pattern), recursive=True)) if pattern else [None]
        for file in files[::1 + len(files) // MOST_FILES]:
            yield [file if word == pattern else word for word in words], pattern is not None and pattern.startswith("/")


def gcovr_report():
    path = build_dir(PRESET) / "coverage.json"
    command = ["gcovr", "--root", ROOT, "--filter", "common/", "--json", path, build_dir(PRESET)]
    finished = run(command, "read the counters", cwd=ROOT)
    if finished.code != 0:
        raise CourseError(f"gcovr failed: {finished.output.strip().splitlines()[-1]}")
    return json.loads(path.read_text())


def share(lines):
    """Per cent of lines that ran. @throws CourseError when there are none"""
    if not lines:
        raise CourseError("gcovr counted no line of common/; was the coverage preset built from this tree?")
    return 100 * sum(1 for _, _, times in lines if times > 0) / len(lines)


def by_topic(lines):
    """(folder, its lines) of each folder."""
    topics = {}
    for line in lines:
        topics.setdefault(line[0].rpartition("/")[0], []).append(line)
    return sorted(topics.items())


def verdict(lines):
    """A note with the share of lines that ran. @throws CourseError when it is too low; names the lines that never ran"""
    note = f"{share(lines):.1f} % of {len(lines)} lines"
    never = {}
    for name, number, times in lines:
        if times == 0:
            never.setdefault(name, []).append(str(number))
    for name, numbers in sorted(never.items()):
        say(f"  no chapter runs {name}:{','.join(numbers)}")
    say(table([(topic, len(of_topic), f"{share(of_topic):.1f} %") for topic, of_topic in by_topic(lines)],
              ["topic", "lines", "run"], right=(1, 2)))
    if share(lines) < LEAST:
        raise CourseError(f"the chapters run {note} of common/, at least {LEAST:.0f} % are asked for; "
                          "remove what no chapter runs, or let one show it")
    return note
