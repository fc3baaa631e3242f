"""clang-tidy on the sources of chapters, by the rules of .clang-tidy, and clang-format on their sources and headers.

A file's chapter is that which adds it. Both read the files as they are, without precompiled headers, so that a forgotten include
is found too. A file that was clean is not read again until it, a header that it includes, the rules, this file or a tool change.
"""

import concurrent.futures
import functools
import os
import re
import subprocess
from pathlib import Path

from chapter_order import INCLUDE
from course_lib import cmake, green
from course_lib.chapters import add_chapters_argument, all_chapters, choose_chapters
from course_lib.checks import chapter_of
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import ROOT, build_dir, cores, declarations
from course_lib.terminal import Step, count, say
from exercises.trees import source_files

HELP = "clang-tidy and clang-format"
PRESET = "plain"
TIDY = ("clang-tidy", "--quiet", "-p", build_dir(PRESET), "--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wno-error")
# In a test the analyzer's time goes into GoogleTest's own functions (13 of 18 s): it follows fewer of a test's calls.
SHALLOW = ("--extra-arg=-Xclang", "--extra-arg=-analyzer-config", "--extra-arg=-Xclang", "--extra-arg=mode=shallow")
SOURCES = re.compile(r"^(common|chapters|tests)/.*\.(cpp|h)$")
CHECK_BY_NAME = re.compile(r"(?:^ *|,)([a-z][\w-]*)(?=,|$)", re.MULTILINE)
# Of a library's header an error alone: what the analyzer thinks of its insides is not ours to mend.
FINDING = re.compile(r"^(?:(?!/usr/).*warning|.*error): .*$", re.MULTILINE)


def add_arguments(parser):
    add_chapters_argument(parser)


def run(args):
    ensure_packages("full")
    chapters = choose_chapters(args.chapters)
    refuse_unknown_checks()
    cmake.configure(PRESET)
    for chapter in all_chapters():
        write_inputs(build_dir(PRESET) / "chapters" / chapter / "chapter_inputs.h")
    files = files_of({int(chapter[:2]) for chapter in chapters})
    found = findings(files)
    for line in found:
        say(line.replace(f"{ROOT}/", ""))
    say(f"{len(files) - len({line.split(':')[0] for line in found})} passed, {len({line.split(':')[0] for line in found})} failed")
    if found:
        raise CourseError(f"{count(len(found), 'finding')}, the first: {found[0].replace(f'{ROOT}/', '')}")
    return 0


def refuse_unknown_checks():
    """clang-tidy passes over the name of a check that it doesn't have, without a word."""
    rules = (ROOT / ".clang-tidy").read_text()
    asked = CHECK_BY_NAME.findall(rules[rules.index("Checks:"):rules.index("HeaderFilterRegex:")])
    has = subprocess.run(["clang-tidy", "--list-checks"], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    unknown = [name for name in asked if name not in has]
    if unknown:
        raise CourseError(f".clang-tidy: this clang-tidy has no {', '.join(unknown)}")


def write_inputs(header):
    """What a chapter includes and its build generates, from all that it compiles: here its shape will do. The next build, which
    knows nothing of this file, writes it anew."""
    if header.exists():
        return
    header.parent.mkdir(parents=True, exist_ok=True)
    header.write_text('#pragma once\n\n#include "figure/figure.h"\n\ninline const caustic::ChapterInputs thisChapter = {};\n')


def files_of(numbers):
    """The C++ files that chapters of these numbers add."""
    tags = {name: tag["chapter"] for name, tag in declarations(PRESET)["files"].items()}
    return [name for name in source_files() if SOURCES.match(name) and chapter_of(name, tags) in numbers]


def read_with(name):
    """A file and those of ours that it includes, directly or through another."""
    found, waiting = {name}, [name]
    while waiting:
        more = included_by(waiting.pop()) - found
        found |= more
        waiting += more
    return found


@functools.lru_cache(maxsize=None)
def included_by(name):
    """Those of our files that a file includes itself, found where the build looks: in its folder and those above, in common/ and
    tests/, and in its chapter's folder."""
    places = [*Path(name).parents, Path("common"), Path("tests"), Path("chapters", *Path(name).parts[1:2])]
    named = [found[1] for found in map(INCLUDE.match, (ROOT / name).read_text().splitlines()) if found]
    return {os.path.normpath(place / path) for path in named for place in places if (ROOT / place / path).is_file()}


def findings(files):
    """What the two tools say of the files, one line each."""
    memory = green.Memory()
    rules = [".clang-tidy", ".clang-format", "tools/commands/tidy.py"]
    inputs = {name: green.digest([green.toolchain(), green.files_digest([*rules, *read_with(name)])]) for name in files}
    due = [name for name in files if memory.passed(f"tidy {name}", inputs[name]) is None]
    found = []
    with Step(f"read {count(len(due), 'file')}, {len(files) - len(due)} clean before") as step, \
            concurrent.futures.ThreadPoolExecutor(cores()) as pool:
        waiting = {pool.submit(findings_of, name): name for name in due}
        for done, finished in enumerate(concurrent.futures.as_completed(waiting), start=1):
            name, lines = waiting[finished], finished.result()
            found += lines
            if lines:
                memory.forget(f"tidy {name}")
            else:
                memory.remember(f"tidy {name}", inputs[name], 1)
            step.progress(done, len(due))
    return sorted(set(found))


def findings_of(name):
    lines = said(["clang-format", "--dry-run", name])
    depth = SHALLOW if name.startswith("tests/") else ()
    return lines + (said([*TIDY, *depth, name]) if name.endswith(".cpp") else [])


def said(command):
    finished = subprocess.run([str(word) for word in command], cwd=ROOT, env={**os.environ, "LC_ALL": "C"}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    lines = FINDING.findall(finished.stdout)
    if finished.returncode != 0 and not lines:
        return [f"{command[-1]}: error: {command[0]} failed: {(finished.stdout.strip().splitlines() or ['it says nothing'])[-1]}"]
    return lines
