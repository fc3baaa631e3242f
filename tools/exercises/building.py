"""Builds a tree that may hold somebody else's code."""

import math
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import cores
from course_lib.process import Finished, run
from course_lib.terminal import printable
from exercises import sandbox as box

PRESET = "student"
MOST_COMPILER_MEMORY = 8192  # MiB of address space of each process of the build
MOST_COMPILER_TIME = 120  # seconds of processor time of each process of the build
MOST_COMPILER_FILE = 4096  # MiB
MOST_COMPILER_TMP = 2048  # MiB of the sandbox's /tmp
TIME_IS_UP = (124, 137)  # exit codes of timeout(1)
FIRST_ERROR = re.compile(r"^(.*?(?:\berror:|undefined reference|multiple definition|FAILED:).*)$", re.MULTILINE)
MENTION = re.compile(r"(?:^|[\s(])([\w./+-]+\.(?:h|cpp)):(\d+)", re.MULTILINE)
OF_ONE_COMMAND = re.compile(r"^FAILED: .*?(?=^FAILED: |^\[\d+/\d+\]|^ninja: |\Z)", re.MULTILINE | re.DOTALL)


@dataclass
class Built:
    """How a build ended."""

    error: str  # the first error in one line; empty when all went well
    output: str

    @property
    def warnings(self):
        return [line for line in self.output.splitlines() if "warning:" in line]


def program(tree, name):
    return tree / "build" / PRESET / "bin" / name


def build_tree(tree, targets, title, variables=(), keep_going=False, sandboxed=False, jobs=None,
               most_seconds=None):
    """Configures a tree with the preset `student` and builds the targets.

    @param title  what the progress lines say; none are shown when it is empty
    @param variables  further CMake variables, "NAME=VALUE"
    @param keep_going  whether to build what can be built behind the first error
    @param sandboxed  whether to build in the sandbox, where only the tree's build folder and ccache's can be written
    @param jobs  how many compilers at a time; None for one a processor
    @param most_seconds  when to give the build up; None for never
    @throws CourseError when CMake cannot configure it: that is no student's fault
    """
    folder = tree / "build" / PRESET
    if was_moved(tree, folder):
        shutil.rmtree(folder)
    if not is_configured(folder, variables):
        configured = execute(["cmake", "--preset", PRESET, f"-DPython3_EXECUTABLE={sys.executable}", *(f"-D{variable}" for variable in variables)],
                             title and f"configure {title}", tree)
        if configured.code != 0:
            reason = re.search(r"CMake Error.*?\n\s*(\S.*)", configured.output)
            raise CourseError(f"configuring {tree} failed: {reason[1] if reason else 'CMake said no more'}; "
                              "./course setup installs what is missing")
    command = ["cmake", "--build", folder, "-j", jobs or cores(), "--target", *targets, *(("--", "-k", "0") if keep_going else ())]
    command = box.limited(command, MOST_COMPILER_MEMORY, MOST_COMPILER_TIME, MOST_COMPILER_FILE)
    if sandboxed:
        cache = box.compiler_cache()
        command = ["env", *(f"CCACHE_DIR={place}" for place in cache),
                   *box.wrapped(command, [box.LAUNCH, tree], [tree / "build", *cache], MOST_COMPILER_TMP)]
    if most_seconds is not None:
        command = ["timeout", "-k", "5", max(1, math.ceil(most_seconds)), *command]
    finished = execute(command, title and f"build {title}", tree)
    output = printable(readable(finished.output, tree))
    if most_seconds is not None and finished.code in TIME_IS_UP:
        shutil.rmtree(folder)  # it may hold half a file that looks whole
        return Built("the build took longer than a hand-in gets", output)
    return Built("" if finished.code == 0 else first_error(output), output)


def is_configured(folder, variables):
    """Whether the build folder was configured with these variables."""
    if not (folder / "build.ninja").exists():
        return False
    cache = (folder / "CMakeCache.txt").read_text(errors="replace")
    cached = dict(re.findall(r"^(\w+):\w+=(.*)$", cache, re.MULTILINE))
    return all(cached.get(name) == value for name, value in (variable.split("=", 1) for variable in variables))


def was_moved(tree, folder):
    """Whether the tree was copied or moved together with its build folder, which is of no use then."""
    cache = folder / "CMakeCache.txt"
    if not cache.exists():
        return False
    home = re.search(r"^CMAKE_HOME_DIRECTORY:\w+=(.*)$", cache.read_text(errors="replace"), re.MULTILINE)
    return home is None or Path(home[1]).resolve() != tree.resolve()


def execute(command, title, folder):
    """Runs a program in a folder; shows its progress when there is a title."""
    env = {**os.environ, "LC_ALL": "C"}  # errors are looked for in English
    if title:
        return run(command, title, cwd=folder, env=env)
    start = time.monotonic()
    ended = subprocess.run([str(word) for word in command], cwd=folder, env=env, stdin=subprocess.DEVNULL,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    return Finished(ended.returncode, ended.stdout, time.monotonic() - start)


def readable(output, tree):
    """The compiler's output with paths below the top of the tree."""
    for prefix in (f"{tree.resolve()}/", f"{tree}/", "../../"):
        output = output.replace(prefix, "")
    return output


def first_error(output):
    lines = [match[1].strip() for match in FIRST_ERROR.finditer(output)]
    of_compiler = [line for line in lines if not line.startswith("FAILED:")]
    return (of_compiler or lines or ["the build failed without a message"])[0]


def failures(output):
    """What each command that failed said: [text], in the order in which they ended."""
    return [found[0] for found in OF_ONE_COMMAND.finditer(output)]


def mentions(said, paths):
    """Places in some files that the compiler names, the first error's own first: [(path, line)]."""
    error = re.search(r"^.*\berror:", said, re.MULTILINE)
    from_error = said[error.start():] if error else said
    before = said[:error.start()] if error else ""
    found = [(place[1], int(place[2])) for place in (*MENTION.finditer(from_error.split("\n")[0]), *MENTION.finditer(before),
                                                     *MENTION.finditer(from_error))]
    return [place for place in found if place[0] in paths]


def excerpt(output, most_lines=12):
    """The compiler's output from the first error on, cut; not what the next command that failed said: a header's error
    comes again with each file that includes it."""
    lines = [line for line in output.splitlines() if not re.match(r"^\[\d+/\d+\]", line)]
    start = next((i for i, line in enumerate(lines) if "error:" in line or "undefined reference" in line), 0)
    end = next((i for i in range(start, len(lines)) if lines[i].startswith(("FAILED: ", "ninja: "))), len(lines))
    return "\n".join(lines[start:min(end, start + most_lines)])


