"""Which lines count as error paths, and what the coverage of the library by the chapters is made of."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from course_lib import coverage
from course_lib.chapters import all_chapters
from course_lib.errors import CourseError

SOURCE = """\
int read(const char* text) {
    if (text == nullptr) throw Bad("no text;");
    if (*text == 0) {
        count();
        throw Bad(
            "empty");
    }
    for (int i = 0; i < 3; ++i) {
        step("throw this");  // throw it
    }
    try {
        step(1);
    } catch (const Bad&) {
        forget();
    }
    if (*text == 'x') refuse(text, 'x');
    int best = 0;
    throw Bad("the end");
}
"""
ERROR_LINES = {2, 3, 4, 5, 6, 7, 13, 14, 15, 16, 18}


class ErrorPaths(unittest.TestCase):
    def test_only_lines_that_lead_to_a_throw_are_left_out(self):
        self.assertEqual(coverage.error_lines(SOURCE, {"refuse"}), ERROR_LINES)

    def test_functions_that_never_return_are_known(self):
        sources = ["[[noreturn]] void refuse(const char* text, char c);", "namespace x {\n[[noreturn]] static void end(\n"]
        self.assertEqual(coverage.no_return_functions(sources), {"refuse", "end"})


class Commands(unittest.TestCase):
    def test_a_pattern_stands_for_each_file_and_only_others_files_may_be_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.txt", "b.txt", "c.svg"):
                (Path(folder) / name).touch()
            given = {"01_x": (("--inspect", "*.txt"), ("--draw", 7, *coverage.TO_OUT), ("--inspect", f"{folder}/*.svg"))}
            with mock.patch.object(coverage, "COMMANDS", given):
                commands = list(coverage.commands("01_x", "there", Path(folder)))
        self.assertEqual(commands, [(["--inspect", f"{folder}/a.txt"], False), (["--inspect", f"{folder}/b.txt"], False),
                                    (["--draw", "7", "--out", "there", "--threads", "1"], False),
                                    (["--inspect", f"{folder}/c.svg"], True)])

    def test_every_chapter_that_is_given_commands_stands(self):
        self.assertLessEqual(set(coverage.COMMANDS), set(all_chapters()))


class OldCounters(unittest.TestCase):
    def test_counts_and_the_notes_of_objects_that_are_built_no_more_go_away(self):
        with tempfile.TemporaryDirectory() as folder:
            build = Path(folder)
            (build / "build.ninja").write_text("build x/new.cpp.o: compile new.cpp\n")
            (build / "x").mkdir()
            for name in ("new.cpp.gcno", "new.cpp.gcda", "old.cpp.gcno", "old.cpp.gcda", "new.cpp.o"):
                (build / "x" / name).touch()
            coverage.forget_old_counters(build)
            self.assertEqual(sorted(path.name for path in (build / "x").iterdir()), ["new.cpp.gcno", "new.cpp.o"])


class Verdict(unittest.TestCase):
    def verdict(self, lines):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            try:
                return coverage.verdict(lines), printed.getvalue()
            except CourseError as error:
                return str(error), printed.getvalue()

    def test_the_share_is_of_the_lines_that_are_no_error_paths(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.cpp").write_text(SOURCE)
            lines = [{"line_number": number, "count": 0 if number in ERROR_LINES else 7} for number in range(1, 20)]
            report = {"files": [{"file": "a.cpp", "lines": lines}]}
            measured = list(coverage.measured_lines(report, Path(folder)))
        # refuse() is not declared [[noreturn]] here, so its line counts, and is the only one that never ran.
        self.assertEqual([number for _, number, count in measured if count == 0], [16])
        self.assertEqual(len(measured), 19 - len(ERROR_LINES) + 1)

    def test_too_low_a_share_is_an_error_that_names_the_lines(self):
        text, printed = self.verdict([("common/a.cpp", 1, 3), ("common/a.cpp", 2, 0), ("common/a.cpp", 5, 0)])
        self.assertIn("33.3 % of 3 lines", text)
        self.assertIn("common/a.cpp:2,5", printed)

    def test_enough_is_a_note(self):
        text, _ = self.verdict([("common/a.cpp", number, number != 7) for number in range(100)])
        self.assertEqual(text, "99.0 % of 100 lines")

    def test_no_lines_at_all_is_an_error(self):
        self.assertIn("counted no line", self.verdict([])[0])


if __name__ == "__main__":
    unittest.main()
