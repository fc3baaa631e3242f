"""Builds a tree that may hold somebody else's code."""

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
from exercises.verdicts import LAUNCH

PRESET = "student"
MOST_COMPILER_MEMORY = 8192  # MiB of address space of each process of the build
MOST_COMPILER_TIME = 300  # seconds of processor time of each process of the build
MOST_COMPILER_FILE = 4096  # MiB
FIRST_ERROR = re.compile(r"^(.*?(?:\berror:|undefined reference|multiple definition|FAILED:).*)$", re.MULTILINE)
SYSTEM_FOLDERS = ("/usr/", "/opt/", "/nix/", "/Library/", "/Applications/")


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


def build_tree(tree, targets, title, variables=()):
    """Configures a tree with the preset `student` and builds the targets.

    @param title  what the progress lines say; none are shown when it is empty
    @param variables  further CMake variables, "NAME=VALUE"
    @throws CourseError when CMake cannot configure it: that is no student's fault
    """
    folder = tree / "build" / PRESET
    if was_moved(tree, folder):
        shutil.rmtree(folder)
    if not is_configured(folder, variables):
        configured = execute(["cmake", "--preset", PRESET, *(f"-D{variable}" for variable in variables)],
                             title and f"configure {title}", tree)
        if configured.code != 0:
            reason = re.search(r"CMake Error.*?\n\s*(\S.*)", configured.output)
            raise CourseError(f"configuring {tree} failed: {reason[1] if reason else 'CMake said no more'}; "
                              "./course setup installs what is missing")
    limits = [str(MOST_COMPILER_MEMORY), str(MOST_COMPILER_TIME), str(MOST_COMPILER_FILE)]
    command = [sys.executable, "-I", "-S", LAUNCH, *limits, "cmake", "--build", folder, "-j", cores(), "--target", *targets]
    finished = execute(command, title and f"build {title}", tree)
    output = readable(finished.output, tree)
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


def foreign_files(tree):
    """Files that the compiler opened although they lie neither in the tree nor in a system folder, with who did.

    A submission that includes the reference's own source is no solution.
    @return [(object file, path)]
    """
    folder = tree / "build" / PRESET
    listed = subprocess.run(["ninja", "-C", str(folder), "-t", "deps"], stdout=subprocess.PIPE, check=True)
    top = str(tree.resolve()) + "/"
    found = []
    target = ""
    for line in listed.stdout.decode("utf-8", "surrogateescape").splitlines():
        if not line.startswith(" "):
            target = line.split(":")[0]
            continue
        if not line.strip():
            continue
        path = str((folder / line.strip()).resolve())
        if not path.startswith((top, *SYSTEM_FOLDERS)):
            found.append((target, path))
    return found


def excerpt(output, most_lines=12):
    """The compiler's output from the first error on, cut."""
    lines = [line for line in output.splitlines() if not re.match(r"^\[\d+/\d+\]", line)]
    start = next((i for i, line in enumerate(lines) if "error:" in line or "undefined reference" in line), 0)
    return "\n".join(lines[start:start + most_lines])


