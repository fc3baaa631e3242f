"""Runs the tests of a mutant until one notices it."""

import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass

from exercises.trees import remove_tree
from exercises.verdicts import LAUNCH, MOST_FILE, environment
from mutation.schema import REFERENCE, STOP, VARIABLE

CAUGHT = "caught"
ESCAPED = "escaped"
LEAST_LIMIT = 3  # seconds of processor time; a mutant's tests get this, or ten times what the reference takes
SLOWER = 10
BATCH = 0.5  # seconds: tests of that much together share a process
WALL = 60  # seconds on the clock for each second of processor time: for what waits for ever
STARTED = re.compile(r"^\[ RUN      \] (\S+)")
FAILED = re.compile(r": Failure$")


@dataclass(frozen=True)
class Ended:
    """How a run of some tests ended."""

    passed: bool
    test: str = ""  # the first that didn't pass
    how: str = ""  # "failed", "crashed", "timed out"
    code: int = 0
    seconds: float = 0  # of processor time


@dataclass(frozen=True)
class Batch:
    """Tests that run one after the other in one process."""

    tests: tuple
    limit: int  # seconds of processor time
    memory: int  # MiB


def run_tests(program, batch, number, scratch):
    """Runs the tests of a batch with one body chosen, up to the first that does not pass."""
    scratch.mkdir(parents=True, exist_ok=True)
    folder = tempfile.mkdtemp(dir=scratch)
    # One thread: mutants run beside each other, and the answer is the same for any number of threads.
    env = {**environment(folder), VARIABLE: str(number), "OMP_NUM_THREADS": "1"}
    command = [sys.executable, "-I", "-S", str(LAUNCH), str(batch.memory), str(batch.limit), str(MOST_FILE), str(program),
               f"--gtest_filter={':'.join(batch.tests)}", "--gtest_fail_fast", "--gtest_color=no"]
    try:
        process = subprocess.Popen(command, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        clock = threading.Timer(WALL * batch.limit, kill_group, [process.pid])
        clock.start()
        try:
            test, failed, passed = read_output(process.stdout)
            if failed:
                kill_group(process.pid)
            for _ in process.stdout:
                pass  # a full pipe would hold up its end
            _, status, usage = os.wait4(process.pid, 0)
        finally:
            clock.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)  # it has been waited for
        process.stdout.close()
    finally:
        remove_tree(folder)
    seconds = usage.ru_utime + usage.ru_stime
    return judged(process.returncode, test, failed, passed, seconds, batch.limit)


def judged(code, test, failed, passed, seconds, limit):
    if failed:
        return Ended(False, test, "failed", code, seconds)
    if code == 0 and passed:
        return Ended(True, code=code, seconds=seconds)
    if code in (-signal.SIGKILL, -signal.SIGXCPU):
        return Ended(False, test, "timed out" if seconds > 0.9 * limit or code == -signal.SIGXCPU else "killed", code, seconds)
    return Ended(False, test, "crashed" if code < 0 else "ended", code, seconds)


def read_output(stream):
    """(the test that ran last, whether it failed, whether all passed); stops reading at the first failure."""
    test = ""
    for block in stream:
        line = block.decode("utf-8", "replace").rstrip("\n")
        started = STARTED.match(line)
        if started:
            test = started[1]
        elif FAILED.search(line):
            return test, True, False
        elif line.startswith("[  PASSED  ]"):
            return test, False, True
    return test, False, False


def kill_group(leader):
    try:
        os.killpg(leader, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass


def limit_for(seconds):
    return max(LEAST_LIMIT, math.ceil(SLOWER * seconds))


def touches(program, test, limit, scratch):
    """Whether a test enters the body."""
    return not run_tests(program, Batch((test.name,), limit, test.memory_limit), STOP, scratch).passed


def batches_of(tests, exercise, seconds):
    """The tests in the order in which they are asked: the exercise's own first, the quickest first of each."""
    found = []
    for own in (True, False):
        chosen = sorted((t for t in tests if (t.exercise == exercise) == own), key=lambda t: (round(seconds[t.name], 1), t.name))
        group, total = [], 0
        for test in chosen:
            if group and total + seconds[test.name] > BATCH:
                found.append(batch_of(group, total))
                group, total = [], 0
            group.append(test)
            total += seconds[test.name]
        if group:
            found.append(batch_of(group, total))
    return found


def batch_of(group, seconds):
    return Batch(tuple(test.name for test in group), limit_for(seconds), max(test.memory_limit for test in group))


def try_mutant(program, number, batches, scratch):
    """What becomes of a mutant: {"state": ..., "by": test, "how": ...}."""
    for batch in batches:
        ended = run_tests(program, batch, number, scratch)
        if not ended.passed:
            return {"state": CAUGHT, "by": ended.test, "how": ended.how}
    return {"state": ESCAPED, "by": "", "how": ""}


def try_reference(program, batch, scratch):
    return run_tests(program, batch, REFERENCE, scratch)
