"""What ./course check says: of a test, of what does not compile, of a picture."""

import unittest

from exercises import pictures, reports
from exercises.building import excerpt
from exercises.catalog import Catalog, ExerciseText, GradedTest
from exercises.grading import ChapterGrade, GradedOutcome
from exercises.pictures import Difference, describe
from exercises.verdicts import FAILED, NOT_BUILT, NOT_IMPLEMENTED, PASSED, STATES, TRIED, Outcome

TEST = GradedTest("Suite.First", "ex-01.1", 50, "Which values are added.")


def graded(state, reason="", failures=()):
    return GradedOutcome(TEST, Outcome(state, reason, list(failures)))


class Details(unittest.TestCase):
    def test_what_to_look_at_is_said_after_a_try_alone(self):
        for state in STATES:
            self.assertEqual("Look at" in reports.details(graded(state, "a reason")), state in TRIED, state)
        self.assertFalse({PASSED, NOT_IMPLEMENTED, NOT_BUILT} & set(TRIED))

    def test_failures_of_one_line_are_counted(self):
        one = {"place": "graded_a.cpp:7", "message": "Expected 1", "times": 1}
        many = {"place": "graded_a.cpp:9", "message": "Expected 2", "times": 71}
        said = reports.details(graded(FAILED, "Expected 1", [one, many]))
        self.assertEqual(said.count("(the first of"), 1)
        self.assertIn("Expected 2\n(the first of 71 failures on this line)", said)


class CompileErrors(unittest.TestCase):
    OUTPUT = "\n".join(("[1/9] Building", "FAILED: a.o", "c++ -c a.cpp", "In file included from a.cpp:1:", "h.h:3:1: error: no", "  3 | no",
                        "[2/9] Building", "FAILED: b.o", "c++ -c b.cpp", "h.h:3:1: error: no", "  3 | no", "ninja: build stopped"))

    def test_the_excerpt_ends_where_the_next_file_begins(self):
        self.assertEqual(excerpt(self.OUTPUT), "h.h:3:1: error: no\n  3 | no")

    def test_an_error_stands_once(self):
        tests = tuple(GradedTest(f"Suite.T{i}", f"ex-01.{1 + i // 2}", 25, "-") for i in range(4))
        exercises = {f"ex-01.{i}": ExerciseText(f"ex-01.{i}", "A sum", 5, ("-",)) for i in (1, 2)}
        errors = ["h.h:3:1: error: no"] * 2 + ["b.cpp:4:1: error: nor this"] * 2
        outcomes = [GradedOutcome(test, Outcome(NOT_BUILT, error)) for test, error in zip(tests, errors)]
        grade = ChapterGrade(Catalog("01_first", exercises, tests), outcomes, errors[0], excerpt(self.OUTPUT))
        said = "\n".join([reports.grade_table(grade), *reports.errors_and_notes(grade)])
        for error in errors:
            self.assertEqual(said.count(error), 1, said)
        self.assertIn("  3 | no", said)


class Pictures(unittest.TestCase):
    def test_it_is_said_whether_a_picture_is_right(self):
        for numbers, quality, words, wrong in (
                ((0, 0, 0, 0, 0, 0, 0), "draft", "the same as the reference", False),
                ((0.41, 255, 1.2, 1, 5, 0, 0), "report", "right: 0.41 % of the pixels differ, by noise alone", False),
                ((0.03, 80, 0.01, 0, 1, 0, 0), "report", "right: 0.03 % of the pixels differ, by rounding alone", False),
                ((0.41, 255, 1.2, 0.4, 9.8, 16, 48), "report",
                 "not right: 0.41 % of the pixels differ, around 16,48 by 10 of 255 on average", True),
                ((99.97, 40, 31, 1, 31, 16, 48), "report",
                 "not right: 100 % of the pixels differ, around 16,48 by 31 of 255 on average", True),
                ((42, 255, 9, 0, 70, 0, 0), "draft", "a draft: 42 % of the pixels differ; "
                 "./course check 09 --pictures takes longer, and says whether it is right", False)):
            self.assertEqual(describe(Difference(*numbers), quality, "09"), (words, wrong))

    def test_shares_have_two_digits_and_no_power_of_ten(self):
        for share, text in ((100, "100 %"), (42.4, "42 %"), (9.96, "10 %"), (9.9, "9.9 %"), (0.996, "1.0 %"), (0.03, "0.03 %"),
                            (0.0004, "less than 0.01 %")):
            self.assertEqual(pictures.percent(share), text)


if __name__ == "__main__":
    unittest.main()
