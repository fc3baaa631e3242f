"""Runs other programs."""

import re
import subprocess
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import Step

# "[12/80] Building ..." of ninja, " 3/80 Test #3: ..." of ctest
DONE_OF_TOTAL = re.compile(r"^\s*\[?(\d+)/(\d+)[\] ]")


@dataclass
class Finished:
    """How a program ended."""

    code: int
    output: str  # standard output and standard error as they came
    seconds: float


def run(command, title, cwd=ROOT, env=None):
    """Runs a program under a progress line of that title; keeps its output to itself.

    @throws CourseError when the program does not exist; a non-zero exit code is left to the caller
    """
    lines = []
    step = Step(title)
    try:
        process = subprocess.Popen([str(word) for word in command], cwd=cwd, env=env, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    except FileNotFoundError:
        raise CourseError(f"there is no program '{command[0]}'; ./course setup installs what the course needs") from None
    with process, step:
        for line in process.stdout:
            lines.append(line)
            matched = DONE_OF_TOTAL.match(line)
            if matched:
                step.progress(int(matched[1]), int(matched[2]))
        process.wait()
        if process.returncode != 0:
            step.note = "failed"
    return Finished(process.returncode, "".join(lines), step.seconds)


def run_visibly(command, cwd=ROOT, env=None):
    """Runs a program that shows its own progress; returns its exit code."""
    return subprocess.run([str(word) for word in command], cwd=cwd, env=env, stdin=subprocess.DEVNULL).returncode


def output_of(command, cwd=ROOT):
    """What a program that does its work at once writes to standard output.

    @throws CourseError when it fails
    """
    finished = subprocess.run([str(word) for word in command], cwd=cwd, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if finished.returncode != 0:
        raise CourseError(f"{command[0]} stopped with exit code {finished.returncode}: {finished.stderr.strip()}")
    return finished.stdout
