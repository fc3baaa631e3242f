"""./course test: every test in exactly one part, and counts that can be trusted."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from commands import test as command
from course_lib import ctest
from course_lib.errors import CourseError

REPORT = """<testsuite>
  <testcase name="01.graded.A" status="run"><system-out>[ OK ]</system-out></testcase>
  <testcase name="01.graded.B" status="fail"><system-out>expected 1</system-out></testcase>
  <testcase name="01.graded.C" status="notrun"><system-out/></testcase>
  <testcase name="course.setup" status="run"><system-out>....
Ran 14 tests in 0.5s</system-out></testcase>
</testsuite>
"""


def partition(parts, every):
    """Calls check_partition on made-up selections."""
    with mock.patch.object(command, "test_names", lambda preset, part: parts.get(part, [])), \
            mock.patch.object(command, "all_test_names", lambda preset: every):
        return command.check_partition([part for part in parts if part != ctest.of_kind("large")])


class Partition(unittest.TestCase):
    def test_every_test_in_one_part_passes(self):
        self.assertEqual(partition({"x": ["a", "b"], "y": ["c"]}, ["a", "b", "c"]), "3 ctest entries")

    def test_large_tests_are_a_part_of_their_own(self):
        self.assertEqual(partition({"x": ["a"], ctest.of_kind("large"): ["big"]}, ["a", "big"]), "2 ctest entries")

    def test_a_test_in_two_parts_is_named(self):
        with self.assertRaisesRegex(CourseError, "selected twice: b;"):
            partition({"x": ["a", "b"], "y": ["b"]}, ["a", "b"])

    def test_two_tests_of_one_name_are_named(self):
        with self.assertRaisesRegex(CourseError, "selected twice: a;"):
            partition({"x": ["a", "a"]}, ["a", "a"])

    def test_a_test_in_no_part_is_named(self):
        with self.assertRaisesRegex(CourseError, "selected by no part: c;"):
            partition({"x": ["a", "b"]}, ["a", "b", "c"])


class Counting(unittest.TestCase):
    def test_a_test_that_was_not_run_has_failed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "junit.xml"
            path.write_text(REPORT)
            outcome = ctest.read_report(path)
        self.assertEqual([name for name, _ in outcome.failed], ["01.graded.B", "01.graded.C"])
        self.assertEqual(outcome.passed, 1 + 14, "Does a file of Python tests count as many as it ran?")

    def verdict(self, *parts):
        report = command.Parts()
        for part in parts:
            report.add(*part)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            return report.report(), printed.getvalue().splitlines()[-1]

    def test_the_last_line_is_the_count(self):
        self.assertEqual(self.verdict(("a", 3, [], 1), ("b", 2, [], 1)), (0, "5 passed, 0 failed"))
        self.assertEqual(self.verdict(("a", 3, [], 1), ("b", 2, [("x", "why")], 1)), (1, "5 passed, 1 failed"))

    def test_no_tests_are_no_success(self):
        self.assertEqual(self.verdict(("a", 0, [], 1)), (1, "0 passed, 0 failed"))


if __name__ == "__main__":
    unittest.main()
