"""clang-tidy on the sources of chapters, by the rules of .clang-tidy, and clang-format on their sources and headers.

A file's chapter is that which adds it. Both read the files as they are, without precompiled headers, so that a forgotten include
is found too. A file that was clean is not read again until it, a header of the course or a tool changes.
"""

import concurrent.futures
import os
import re
import subprocess

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
SOURCES = re.compile(r"^(common|chapters|tests)/.*\.(cpp|h)$")
FINDING = re.compile(r"^.*(?:warning|error): .*$", re.MULTILINE)


def add_arguments(parser):
    add_chapters_argument(parser)


def run(args):
    ensure_packages("full")
    chapters = choose_chapters(args.chapters)
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


def findings(files):
    """What the two tools say of the files, one line each."""
    memory = green.Memory()
    headers = green.files_digest([name for name in source_files() if name.endswith((".h", ".clang-tidy", ".clang-format"))])
    inputs = {name: green.digest([green.toolchain(), headers, ROOT / name]) for name in files}
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
    return lines + (said([*TIDY, name]) if name.endswith(".cpp") else [])


def said(command):
    finished = subprocess.run([str(word) for word in command], cwd=ROOT, env={**os.environ, "LC_ALL": "C"}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    lines = FINDING.findall(finished.stdout)
    if finished.returncode != 0 and not lines:
        return [f"{command[-1]}: error: {command[0]} failed: {(finished.stdout.strip().splitlines() or ['it says nothing'])[-1]}"]
    return lines
