"""tools/exercises/verdicts.py: what a test program may do without being believed."""

import json
import sys
import tempfile
import time
import unittest
from pathlib import Path

from exercises import verdicts
from exercises.verdicts import judge

WORD = "0123abcd"


def line(verdict="passed", word=WORD, failures=()):
    return json.dumps({"word": word, "verdict": verdict, "failures": list(failures)}) + "\n"


class Judge(unittest.TestCase):
    def state(self, code, sent, output=""):
        return judge(code, sent, WORD, output, 10).state

    def test_a_verdict_with_the_word_counts(self):
        self.assertEqual(self.state(0, line()), "passed")
        self.assertEqual(self.state(1, line("failed")), "failed")
        self.assertEqual(self.state(1, line("not implemented")), "not implemented")

    def test_without_a_verdict_nothing_else_counts(self):
        for output in ("[  PASSED  ] 1 test.\n", line()):
            self.assertEqual(self.state(0, "", output), "no verdict")

    def test_a_verdict_without_the_word_does_not_count(self):
        for sent in (line(word="0123abce"), line(word=""), line(word=None), "passed\n", "[]", "{}", line() + line(), line()[:-9],
                     json.dumps({"word": WORD}), json.dumps({"word": WORD, "verdict": "passed"}),
                     json.dumps({"word": WORD, "verdict": "passed", "failures": [1]})):
            self.assertEqual(self.state(0, sent), "no verdict", sent)

    def test_unknown_verdicts_and_skipped_tests_earn_nothing(self):
        self.assertEqual(self.state(0, line("no such test")), "no verdict")
        self.assertEqual(self.state(0, line("skipped")), "failed")

    def test_a_signal_outweighs_a_verdict(self):
        outcome = judge(-11, line(), WORD, "", 10)
        self.assertEqual((outcome.state, outcome.reason), ("crashed", "segmentation fault (SIGSEGV)"))

    def test_a_bad_exit_after_a_passed_test_is_a_crash(self):
        self.assertEqual(self.state(3, line()), "crashed")

    def test_time_outweighs_a_verdict(self):
        outcome = judge(None, line(), WORD, "", 2.5)
        self.assertEqual((outcome.state, outcome.reason), ("timed out", "was still running after 2.5 s"))

    def test_the_reason_is_the_question_that_the_test_asks(self):
        failure = {"place": "a.cpp:1", "message": "Expected equality\n  1\n  2\nWhich end?"}
        self.assertEqual(judge(1, line("failed", failures=[failure]), WORD, "", 10).reason, "Which end?")
        failure["message"] = "Expected equality\n  1\n  2"
        self.assertEqual(judge(1, line("failed", failures=[failure]), WORD, "", 10).reason, "Expected equality")


# Test programs that Python plays: it gets the same command line, folder and pipes.
PROLOGUE = f"""#!{sys.executable}
import json, os, sys, time
word_from, verdict_to = map(int, sys.argv[-1].split("=")[1].split(","))
def verdict(state):
    os.write(verdict_to, b"over\\n")
    word = os.read(word_from, 100).decode().strip()
    os.write(verdict_to, (json.dumps({{"word": word, "verdict": state, "failures": []}}) + "\\n").encode())
"""


def ends_soon(pid):
    """Whether a process that was killed is gone, or waits for its parent to notice."""
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        try:
            if Path(f"/proc/{pid}/stat").read_text().rsplit(")")[1].split()[0] == "Z":
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.01)
    return False


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, text, time_limit=20.0, memory_limit=0):
        program = self.folder / "program"
        program.write_text(PROLOGUE + text)
        program.chmod(0o755)
        return verdicts.run_test(program, "Suite.Test", time_limit, memory_limit, self.folder / "scratch")

    def test_an_honest_program_passes(self):
        self.assertEqual(self.run_program('verdict("passed")').state, "passed")

    def test_it_starts_in_an_empty_folder_that_is_gone_afterwards(self):
        outcome = self.run_program('open("results.json", "w").write("100")\nprint(os.listdir())\nverdict("passed")')
        self.assertEqual(outcome.output, "['results.json']\n")
        self.assertEqual(list((self.folder / "scratch").iterdir()), [])

    def test_folders_that_it_locks_are_removed_and_links_not_followed(self):
        outside = self.folder / "outside"
        outside.mkdir(mode=0o755)
        (outside / "kept").write_text("")
        self.run_program(f'os.makedirs("a/b")\nos.symlink({str(outside)!r}, "link")\nos.chmod("a/b", 0)\nos.chmod("a", 0)\n')
        self.assertEqual(list((self.folder / "scratch").iterdir()), [])
        self.assertEqual((outside.stat().st_mode & 0o777, list(outside.iterdir())), (0o755, [outside / "kept"]))

    def test_it_sees_nothing_of_the_graders_environment(self):
        outcome = self.run_program('print(sorted(os.environ))\nverdict("passed")')
        self.assertNotIn("PYTHONPATH", outcome.output)

    def test_what_it_leaves_running_is_ended_and_not_waited_for(self):
        start = time.monotonic()
        outcome = self.run_program('verdict("passed")\nchild = os.fork()\nif child == 0:\n    time.sleep(60)\nprint(child)\n')
        self.assertEqual(outcome.state, "passed")
        self.assertLess(time.monotonic() - start, 30, "Does the grader wait for the pipe that the child holds?")
        self.assertTrue(ends_soon(int(outcome.output)), "Is the whole group ended, not its leader alone?")

    def test_a_program_that_goes_on_for_ever_is_ended(self):
        outcome = self.run_program("while True: pass", time_limit=0.5)
        self.assertEqual(outcome.state, "timed out")

    def test_one_that_closes_its_pipes_and_goes_on_is_ended_too(self):
        outcome = self.run_program("os.closerange(0, 50)\nwhile True: time.sleep(1)", time_limit=1)
        self.assertEqual(outcome.state, "timed out")

    def test_output_is_cut(self):
        outcome = self.run_program('print("x" * 50_000_000)\nverdict("passed")')
        self.assertEqual((outcome.state, len(outcome.output)), ("passed", verdicts.MOST_OUTPUT))

    def test_memory_is_limited(self):
        outcome = self.run_program('block = bytearray(1 << 30)\nverdict("passed")', memory_limit=512)
        self.assertEqual(outcome.state, "no verdict")
        self.assertIn("MemoryError", outcome.output)

    def test_the_size_of_files_is_limited(self):
        outcome = self.run_program('file = open("big", "wb")\nfile.truncate(1 << 30)\nverdict("passed")')
        self.assertNotEqual(outcome.state, "passed")

    def test_a_missing_program_earns_nothing(self):
        outcome = verdicts.run_test(self.folder / "none", "Suite.Test", 10, 0, self.folder / "scratch")
        self.assertEqual(outcome.state, "no verdict")


if __name__ == "__main__":
    unittest.main()
