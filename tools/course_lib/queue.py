"""The heavy checks of ./course test --full and .ci/run: one after the other, each remembered for its inputs, so that a run
that was stopped, or that had no more time, is gone on with by the next.

A check is a command of ./course. What it leaves in build/ is kept, so one that was stopped is quicker the next time.
"""

import os
import re
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from course_lib import green
from course_lib.checks import known_files
from course_lib.paths import ROOT
from course_lib.terminal import format_duration, say
from exercises.trees import source_files

FIRST_BY_RULE = 8  # chapters from here on catch 95 % of the mistakes that are made by rule (docs/mutants.md)
SAMPLE = "60"  # of these mistakes, of each chapter

COUNT = re.compile(r"^(\d+) passed, (\d+) failed$", re.MULTILINE)


@dataclass(frozen=True)
class Check:
    """A command of ./course, and the files that can change how it ends."""

    name: str
    words: tuple
    files: Callable

    def inputs(self):
        return green.digest([green.toolchain(), *self.words, green.files_digest(self.files())])


def chapter_check(name, number, *words, more=()):
    """A check of one chapter: on what is known when it ends, and what lies below `more` besides."""
    def files():
        return [*known_files(int(number)), *(file for file in source_files() if file.startswith(tuple(more)))]
    return Check(f"{name} {number}", (*words, number), files)


def full_checks(numbers, large, everything):
    """The queue of --full for these chapters: chapter by chapter what finds most for its time, then the others.

    @param large  the numbers of the chapters that have large tests
    """
    first = [check for number in numbers for check in (
        chapter_check("sanitize", number, "test", "--preset", "sanitize"),
        chapter_check("mutants", number, "mutants", more=(f"tests/{number}_",)))]
    first += [chapter_check("tidy", number, "tidy", more=(".clang",)) for number in numbers]
    first += [chapter_check("mutants by rule", number, "mutants", "--systematic", "--sample", SAMPLE, more=(f"tests/{number}_",))
              for number in numbers if int(number) >= FIRST_BY_RULE]
    later = [check for number in numbers for check in (
        *([chapter_check("large", number, "test", "--large")] if number in large else []),
        chapter_check("thread", number, "test", "--preset", "thread"),
        chapter_check("debug", number, "test", "--preset", "debug"))]
    whole = [Check("without precompiled headers", ("build", "--preset", "plain"), source_files),
             Check("coverage by the chapters", ("test", "--coverage"), source_files),
             Check("a student's way through all chapters", ("test", "--walk"), source_files)]
    return first + later + (whole if everything else [])


class Queue:
    """Runs checks.

    @param patience  seconds since `start`: no check begins later; @param limit  seconds: one that still runs then is stopped
    """

    def __init__(self, parts, memory, again=False, patience=None, limit=None, start=None):
        self._parts = parts
        self._memory = memory
        self._again = again
        self._patience = patience
        self._limit = limit
        self._start = time.monotonic() if start is None else start
        self.left_out = []

    def run(self, checks):
        for check in checks:
            inputs = check.inputs()
            known = None if self._again else self._memory.passed(check.name, inputs)
            if known is not None:
                self._parts.add(check.name, known, [], 0, "unchanged since it passed")
            elif self._patience is not None and self._elapsed() > self._patience:
                self.left_out.append(check.name)
            else:
                self._try(check, inputs)
        if self.left_out:
            say(f"\nleft out for lack of time: {', '.join(self.left_out)}; the next ./course test --full goes on there")

    def _elapsed(self):
        return time.monotonic() - self._start

    def _try(self, check, inputs):
        say(f"== ./course {' '.join(check.words)}")
        begin = time.monotonic()
        left = None if self._limit is None else max(0, self._limit - self._elapsed())
        code, output = run_within([ROOT / "course", *check.words], left)
        seconds = time.monotonic() - begin
        if code is None:
            self.left_out.append(f"{check.name} (stopped after {format_duration(seconds)})")
            return
        passed, failed = counted(output, code)
        if code == 0:
            self._memory.remember(check.name, inputs, passed)
        else:
            self._memory.forget(check.name)
        # The command has shown what is wrong.
        failures = [(check.name, f"./course {' '.join(check.words)} failed")] * max(failed, 1) if code != 0 else []
        self._parts.add(check.name, passed, failures, seconds)


def counted(output, code):
    """(passed, failed) as a command of ours says it in its last line; else it is one check itself."""
    found = COUNT.findall(output)
    if found:
        return int(found[-1][0]), int(found[-1][1])
    return (1, 0) if code == 0 else (0, 1)


def run_within(command, seconds):
    """Runs a command visibly, at most so long (None: as long as it takes); returns (exit code, output), no code in time."""
    process = subprocess.Popen([str(word) for word in command], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
    lines = []

    def show():
        for line in process.stdout:
            lines.append(line)
            print(line, end="", flush=True)

    reader = threading.Thread(target=show)
    reader.start()
    try:
        code = process.wait(seconds)
    except subprocess.TimeoutExpired:
        code = None
    finally:
        end_group(process)
        reader.join()
        process.stdout.close()
    return code, "".join(lines)


def end_group(process):
    """Ends all that a command started and that is still there."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
            process.wait(10)
        except ProcessLookupError:
            return
        except subprocess.TimeoutExpired:
            continue
