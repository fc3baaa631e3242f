"""The queue of heavy checks: what is green is not run again, what failed is, and time is kept to."""

import contextlib
import io
import os
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from commands import test as command
from course_lib import queue
from course_lib.green import Memory
from course_lib.queue import Check, Queue, counted, full_checks, run_within

SCRIPT = """#!/bin/sh
echo "$@" >>ran.txt
case "$1" in
counts) echo "7 passed, 0 failed" ;;
fails) echo "5 passed, 2 failed"; exit 1 ;;
breaks) echo "course: broken"; exit 1 ;;
sleeps) sleep 60 & wait ;;
esac
"""


class InMadeUpTree(unittest.TestCase):
    """A tree whose ./course does what it is told and writes down that it ran."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "course").write_text(SCRIPT)
        (self.root / "course").chmod(0o755)
        (self.root / "source.cpp").write_text("int a;\n")
        self.memory = Memory(self.root / "green.json")
        for name, value in (("ROOT", self.root), ("source_files", lambda: [])):
            patch = mock.patch.object(queue, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def check(self, word):
        return Check(f"{word} 01", (word, "01"), lambda: [os.path.relpath(self.root / "source.cpp", queue.green.ROOT)])

    def run_queue(self, *words, **options):
        """Runs a queue; returns (exit code, last line, names left out, what was run)."""
        (self.root / "ran.txt").write_text("")
        parts = command.Parts(memory=self.memory)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            line = Queue(parts, self.memory, **options)
            line.run([self.check(word) for word in words])
            code = parts.report()
        return code, printed.getvalue().splitlines()[-1], line.left_out, (self.root / "ran.txt").read_text().splitlines()


class Queues(InMadeUpTree):
    def test_what_was_green_is_counted_and_not_run_again(self):
        self.assertEqual(self.run_queue("counts", "other"), (0, "8 passed, 0 failed", [], ["counts 01", "other 01"]))
        self.assertEqual(self.run_queue("counts", "other"), (0, "8 passed, 0 failed", [], []))
        self.assertEqual(self.run_queue("counts", again=True)[3], ["counts 01"])

    def test_a_changed_input_makes_it_due_again(self):
        self.run_queue("counts")
        (self.root / "source.cpp").write_text("int b;\n")
        self.assertEqual(self.run_queue("counts")[3], ["counts 01"])

    def test_what_failed_is_counted_and_run_again(self):
        for _ in range(2):
            self.assertEqual(self.run_queue("fails", "breaks", "counts")[:2], (1, "12 passed, 3 failed"))
        self.assertEqual(self.run_queue("fails")[3], ["fails 01"])

    def test_nothing_begins_when_patience_is_over_and_what_was_left_out_is_named(self):
        self.run_queue("counts")
        code, last, left_out, ran = self.run_queue("counts", "other", patience=-1)
        self.assertEqual((code, last, left_out, ran), (0, "7 passed, 0 failed", ["other 01"], []))

    def test_what_runs_beyond_the_limit_is_stopped_with_all_that_it_started(self):
        begin = time.monotonic()
        code, last, left_out, _ = self.run_queue("counts", "sleeps", limit=5)
        self.assertLess(time.monotonic() - begin, 40)
        self.assertEqual((code, last), (0, "7 passed, 0 failed"))
        self.assertRegex(left_out[0], r"^sleeps 01 \(stopped after \d")
        self.assertEqual(self.run_queue("counts")[1], "7 passed, 0 failed")


class Parts(unittest.TestCase):
    def test_a_command_counts_by_its_last_line_or_as_one(self):
        self.assertEqual(counted("1 passed, 0 failed\nmore\n12 passed, 3 failed\n", 1), (12, 3))
        self.assertEqual((counted("", 0), counted("", 1)), ((1, 0), (0, 1)))

    def test_output_is_kept_and_codes_are_told(self):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            self.assertEqual(run_within(["sh", "-c", "echo a; echo b >&2; exit 3"], None), (3, "a\nb\n"))
        self.assertEqual(printed.getvalue(), "a\nb\n")

    def test_chapters_come_in_the_order_given_and_sanitizers_first(self):
        names = [check.name for check in full_checks(["04", "01"], {"04"}, everything=True)]
        self.assertEqual(names[:4], ["sanitize 04", "mutants 04", "sanitize 01", "mutants 01"])
        self.assertLess(names.index("mutants 01"), names.index("large 04"))
        self.assertEqual(names[-2:], ["coverage by the chapters", "a student's way through all chapters"])
        self.assertNotIn("large 01", names)
        self.assertEqual(len(names), len(set(names)))

    def test_mistakes_by_rule_are_asked_of_the_chapters_that_catch_them(self):
        names = [check.name for check in full_checks(["07", "08"], set(), everything=False)]
        self.assertIn("mutants by rule 08", names)
        self.assertNotIn("mutants by rule 07", names)


if __name__ == "__main__":
    unittest.main()
