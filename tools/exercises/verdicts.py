"""Runs one graded test and decides what became of it.

The test program is somebody else's code, so nothing that is easy to forge counts: not what it prints, no file, no exit
code. When the test is over, the program asks for a random word through a pipe, gets it through another, and only a verdict
that carries this word is believed (tests/support/verdict.h is the other end). So no code of the test meets the word.
"""

import json
import math
import os
import secrets
import selectors
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

from course_lib.paths import cores
from course_lib.terminal import printable
from exercises import sandbox as box
from exercises.trees import remove_tree

LAUNCH = box.LAUNCH
MOST_OUTPUT = 16 * 1024  # bytes of a test's output that are kept
MOST_VERDICT = 256 * 1024
MOST_FILE = 256  # MiB of one file that a test may write

PASSED = "passed"
FAILED = "failed"
NOT_IMPLEMENTED = "not implemented"
CRASHED = "crashed"
TIMED_OUT = "timed out"
NO_VERDICT = "no verdict"
NOT_BUILT = "did not build"
REFUSED = "refused"
TRIED = (FAILED, CRASHED, TIMED_OUT, NO_VERDICT)  # a body ran and was wrong
STATES = (PASSED, FAILED, NOT_IMPLEMENTED, CRASHED, TIMED_OUT, NO_VERDICT, NOT_BUILT, REFUSED)
ASKS = b"over\n"  # what the test program sends when the test is over, to get the word
TMP = 256  # MiB of a test's /tmp


@dataclass
class Outcome:
    """What became of one test."""

    state: str
    reason: str = ""  # one line; empty when it passed
    failures: list = field(default_factory=list)  # [{"place": "graded_x.cpp:14", "message": "...", "times": 1}], one a place
    output: str = ""  # what it printed, cut
    seconds: float = 0

    @property
    def passed(self):
        return self.state == PASSED


class TestProcess:
    """A test program that runs in a sandbox, or in a process group and an empty folder of its own."""

    def __init__(self, program, test, time_limit, memory_limit, folder, sandboxed):
        word_read, self._word_write = os.pipe()
        self.verdict, verdict_write = os.pipe()
        self.word = secrets.token_hex(16)
        self.time_limit = time_limit
        self._sandboxed = sandboxed
        self._watch = None
        self.start = time.monotonic()
        command = [program, f"--gtest_filter={test}", "--gtest_brief=1", f"--verdict={word_read},{verdict_write}"]
        command = box.limited(command, memory_limit, math.ceil(time_limit) * cores() + 1, MOST_FILE,
                              box.MOST_PROCESSES if sandboxed else 0)
        inherited = [word_read, verdict_write]
        if sandboxed:
            info, info_write = os.pipe()
            calls = box.childless()
            inherited += [info_write, calls]
            command = box.wrapped(command, [box.LAUNCH, program], size=TMP, info=info_write, calls_from=calls)
        try:
            self.process = subprocess.Popen(list(map(str, command)), cwd=folder, stdin=subprocess.DEVNULL,
                                            env=environment(box.HOME if sandboxed else folder), stdout=subprocess.PIPE,
                                            stderr=subprocess.STDOUT, start_new_session=True, pass_fds=inherited)
        finally:
            for end in inherited:
                os.close(end)
        if sandboxed:
            self._watch = box.Watch(info)

    def finish(self):
        """Waits for the end, or brings it about; returns (exit code or None when time ran out, output, verdict line)."""
        texts = {self.process.stdout.fileno(): bytearray(), self.verdict: bytearray()}
        limits = {self.process.stdout.fileno(): MOST_OUTPUT, self.verdict: MOST_VERDICT}
        with selectors.DefaultSelector() as selector:
            for descriptor in texts:
                os.set_blocking(descriptor, False)
                selector.register(descriptor, selectors.EVENT_READ)
            ended = self._collect(selector, texts, limits)
            self._end_all()
            code = self.process.wait()
            for descriptor in list(selector.get_map()):
                drain(descriptor, texts[descriptor], limits[descriptor])
        output, verdict = (bytes(text).decode("utf-8", "replace") for text in texts.values())
        for descriptor in (self.verdict, self._word_write):
            if descriptor is not None:
                os.close(descriptor)
        self.process.stdout.close()
        return (code if ended else None), printable(output), verdict.removeprefix(ASKS.decode())

    def _collect(self, selector, texts, limits):
        """Reads until the program has ended (True) or its time is over (False)."""
        while True:
            left = self.start + self.time_limit - time.monotonic()
            if left <= 0:
                return False
            if not selector.get_map():
                time.sleep(min(left, 0.005))
            for key, _ in selector.select(min(left, 0.05)) if selector.get_map() else ():
                if not drain(key.fd, texts[key.fd], limits[key.fd]):
                    selector.unregister(key.fd)
            self._answer(texts[self.verdict])
            if self._has_ended():
                return True

    def _answer(self, sent):
        """Sends the word, once the program has said that the test is over."""
        if self._word_write is None or not sent.startswith(ASKS):
            return
        try:
            os.write(self._word_write, (self.word + "\n").encode())
        except BrokenPipeError:
            pass  # it is gone
        os.close(self._word_write)
        self._word_write = None

    def _has_ended(self):
        if not hasattr(os, "waitid"):  # macOS before Python 3.13
            return self.process.poll() is not None
        return os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None

    def _end_all(self):
        if self._watch:
            self._watch.end()
        # The leader is not waited for yet, so its group's number cannot belong to anybody else.
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            pass


def drain(descriptor, text, most):
    """Reads what is there and keeps it up to `most` bytes; False at the end of the file."""
    while True:
        try:
            block = os.read(descriptor, 65536)
        except BlockingIOError:
            return True
        if not block:
            return False
        text += block[:max(0, most - len(text))]


def environment(folder):
    """The same for every test: nothing of the grader's, few threads (each takes address space)."""
    return {"PATH": os.defpath, "HOME": str(folder), "TMPDIR": str(folder), "LANG": "C.UTF-8",
            "OMP_NUM_THREADS": "2", "MALLOC_ARENA_MAX": "2"}


def run_test(program, test, time_limit, memory_limit, scratch, sandboxed=False):
    """Runs one test in a fresh folder below `scratch`.

    @param test  "Suite.Test"
    @param time_limit  seconds; @param memory_limit MiB of address space
    @param sandboxed  whether it runs in the sandbox, whose /tmp is its folder then
    """
    scratch.mkdir(parents=True, exist_ok=True)
    folder = tempfile.mkdtemp(dir=scratch)
    try:
        process = TestProcess(program, test, time_limit, memory_limit, folder, sandboxed)
        code, output, line = process.finish()
        seconds = time.monotonic() - process.start
    finally:
        remove_tree(folder)
    outcome = judge(box.exit_code(code) if sandboxed else code, line, process.word, output, time_limit)
    outcome.output = output
    outcome.seconds = seconds
    return outcome


def judge(code, line, word, output, time_limit):
    """What became of a test, from how its process ended (code; None when time ran out) and the verdict's line."""
    if code is None:
        return Outcome(TIMED_OUT, f"was still running after {time_limit:g} s")
    if code < 0:
        return Outcome(CRASHED, describe_signal(-code) + last_words(output))
    verdict = read_verdict(line, word)
    if verdict is None:
        why = "ended before the test did" if not line else "sent a verdict that is not the test's own"
        return Outcome(NO_VERDICT, f"{why} (exit code {code})")
    if verdict["verdict"] == "skipped":
        return Outcome(FAILED, "was skipped", verdict["failures"])
    if verdict["verdict"] not in (PASSED, FAILED, NOT_IMPLEMENTED):
        return Outcome(NO_VERDICT, f"the test program says: {verdict['verdict']}")
    passed = verdict["verdict"] == PASSED
    if passed and code != 0:
        return Outcome(CRASHED, f"the test passed, but the program left with exit code {code}")
    return Outcome(verdict["verdict"], "" if passed else first_reason(verdict["failures"]), verdict["failures"])


def read_verdict(line, word):
    """The verdict as it was sent; None unless it is whole and carries the grader's word."""
    try:
        verdict = json.loads(line)
    except ValueError:
        return None
    if not isinstance(verdict, dict) or not secrets.compare_digest(str(verdict.get("word")).encode(), word.encode()):
        return None
    failures = verdict.get("failures")
    if not isinstance(verdict.get("verdict"), str) or not isinstance(failures, list):
        return None
    if not all(map(is_failure, failures)):
        return None
    said = [{"place": printable(f["place"]), "message": printable(f["message"]), "times": f.get("times", 1)} for f in failures]
    return {"verdict": printable(verdict["verdict"]), "failures": said}


def is_failure(data):
    return (isinstance(data, dict) and isinstance(data.get("place"), str) and isinstance(data.get("message"), str)
            and isinstance(data.get("times", 1), int) and data.get("times", 1) >= 1)


def first_reason(failures):
    """The first failure in one line: the question that its message ends with, when the test asks one."""
    if not failures:
        return "failed without a message"
    lines = [line.strip() for line in failures[0]["message"].splitlines() if line.strip()]
    if not lines:
        return "failed without a message"
    questions = [line for line in lines[1:] if line.endswith("?")]
    return questions[-1] if questions else lines[0]


def describe_signal(number):
    names = {signal.SIGSEGV: "segmentation fault", signal.SIGABRT: "aborted", signal.SIGFPE: "arithmetic fault",
             signal.SIGKILL: "killed", signal.SIGBUS: "bus error", signal.SIGILL: "illegal instruction",
             signal.SIGXFSZ: f"wrote a file of more than {MOST_FILE} MiB"}
    try:
        name = signal.Signals(number).name
    except ValueError:
        name = f"signal {number}"
    return f"{names[number]} ({name})" if number in names else name


def last_words(output):
    """What the runtime said when it gave up: "terminate called after throwing an instance of ..."."""
    words = [line.strip() for line in output.splitlines() if "what():" in line or "terminate called" in line
             or "stack smashing" in line or "free():" in line or "Assertion" in line]
    return ": " + words[-1] if words else ""
