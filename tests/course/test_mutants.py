"""./course mutants: every mistake tried, every kind of bad patch and of weak test named."""

import unittest

from course_lib.errors import CourseError
from exercises.catalog import read_catalog
from exercises.mistakes import Mistake, MistakeResult, complaints, read_mistakes
from toy_course import ToyCase, course

TOTAL, LARGEST, MEAN, CLAMP = ("Sums.TotalAddsAllValues", "Sums.LargestIsTheLargest", "Sums.MeanIsTotalOverCount",
                               "Clamp.StaysWithinBounds")


class ToyTest(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.mistakes = cls.toy / "tests/01_first/mistakes"

    def change(self, path, old, new):
        """Changes a file of the toy for this test."""
        text = path.read_text()
        self.assertIn(old, text)
        self.addCleanup(path.write_text, text)
        path.write_text(text.replace(old, new))


class RunMutants(ToyTest):
    def test_all_mistakes_are_caught_by_their_tests(self):
        ended = course(self.toy, "mutants", "01")
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertIn("6 mistakes in 4 exercises, all caught by the test that they name; each of the 4 graded tests is the only "
                      "one to catch some mistake", ended.stdout)
        self.assertRegex(ended.stdout, rf"last_value_left_out +ex-01\.1 +{TOTAL} +caught +2")
        self.assertRegex(ended.stdout, r"from_behind +ex-01\.2 +full points")

    def test_what_is_wrong_is_named(self):
        # A mistake that the tests don't see, one that does not compile, one that hangs, one that warns.
        self.change(self.mistakes / "search_from_zero.patch", "+    double most = 0;", "+    double most = values.back();")
        self.change(self.mistakes / "divided_by_one_less.patch", "values.size() - 1", "value.size()")
        self.change(self.mistakes / "ends_swapped.patch", "return value > high ? low : value",
                    "volatile bool beyond = value > high; while (beyond) {} return value")
        self.change(self.mistakes / "last_value_left_out.patch", "std::size_t i = 0", "int i = 0")
        self.change(self.mistakes.parent / "alternatives/from_behind.patch", "+    double most = values.back();",
                    "+    double most = 0;")
        ended = course(self.toy, "mutants", "01")
        self.assertEqual(ended.returncode, 1)
        self.assertIn(f"wrong: search_from_zero: {LARGEST} does not catch it\n", ended.stdout)
        self.assertIn("wrong: divided_by_one_less: does not compile: common/math/sums.cpp:25:48: error:", ended.stdout)
        self.assertIn("wrong: last_value_left_out: compiles with a warning: common/math/sums.cpp:10:", ended.stdout)
        self.assertRegex(ended.stdout, rf"ends_swapped +ex-01\.4 +{CLAMP} +caught +1")
        for test in (LARGEST, MEAN):
            self.assertIn(f"wrong: {test} can be deleted and every mistake is still caught", ended.stdout)
        self.assertIn(f"wrong: from_behind: is right, and {LARGEST} fails", ended.stdout)
        self.assertIn("6 complaints, the first:", ended.stderr)
        self.assertEqual(ended.stderr.count("\n"), 1)


class ReadMistakes(ToyTest):
    def refused(self, old, new, reason):
        self.change(self.mistakes / "search_from_zero.patch", old, new)
        with self.assertRaisesRegex(CourseError, r"tests/01_first/mistakes/search_from_zero\.patch: " + reason):
            read_mistakes(read_catalog("01_first", self.toy), self.toy)

    def test_patches_are_read(self):
        found = {m.slug: m for m in read_mistakes(read_catalog("01_first", self.toy), self.toy)}
        self.assertEqual(len(found), 6)
        mistake = found["search_from_zero"]
        self.assertEqual((mistake.exercise, mistake.caught_by), ("ex-01.2", LARGEST))
        self.assertEqual(mistake.sentence, "The search for the largest starts with 0.")
        self.assertIn(b"double most = 0;", mistake.overlay["common/math/sums.cpp"])

    def test_line_numbers_may_be_off(self):
        self.change(self.toy / "common/math/sums.cpp", "namespace caustic {\n\n", "namespace caustic {\n\n// More.\n\n")
        self.assertEqual(len(read_mistakes(read_catalog("01_first", self.toy), self.toy)), 6)

    def test_context_must_fit(self):
        self.refused("     for (const double value : values) most", "     for (double value : values) most", "does not apply")

    def test_a_header_line_is_missed(self):
        self.refused("caught-by:", "caught:", "there is no line 'caught-by: ...' above the diff")

    def test_unknown_exercises_and_tests_are_named(self):
        self.refused("exercise: ex-01.2", "exercise: ex-01.9", "ex-01.9 is no exercise of 01_first")

    def test_unknown_tests_are_named(self):
        self.refused(f"caught-by: {LARGEST}", "caught-by: Sums.Nothing", "grading.json lists no test Sums.Nothing")

    def test_a_mistake_stays_in_its_exercise(self):
        self.refused("exercise: ex-01.2", "exercise: ex-01.1", "changes more than the body of ex-01.1")

    def test_a_mistake_stays_in_its_file(self):
        self.refused("+++ b/common/math/sums.cpp", "+++ b/common/math/sums.h", "a patch of ex-01.2 changes common/math/sums.cpp")


def result(slug, exercise, named, *caught):
    return MistakeResult(Mistake(slug, exercise, named, "", {}), list(caught))


class Complaints(ToyTest):
    def setUp(self):
        self.catalog = read_catalog("01_first", self.toy)
        self.good = [result("a", "ex-01.1", TOTAL, TOTAL), result("b", "ex-01.2", LARGEST, LARGEST),
                     result("c", "ex-01.3", MEAN, MEAN), result("d", "ex-01.4", CLAMP, CLAMP),
                     result("e", "ex-01.1", TOTAL, TOTAL, MEAN), result("f", "ex-01.1", MEAN, TOTAL, MEAN)]

    def test_good_mistakes_give_none(self):
        self.assertEqual(complaints(self.catalog, self.good), [])

    def test_too_few_mistakes(self):
        self.assertEqual(complaints(self.catalog, self.good[:5]), ["01_first has 5 mistakes; write at least 6"])

    def test_too_few_exercises(self):
        few = self.good[:3] + [result("d", "ex-01.3", CLAMP, CLAMP)] + self.good[4:]
        self.assertEqual(complaints(self.catalog, few),
                         ["the mistakes of 01_first lie in 3 exercises; spread them over at least 4"])

    def test_an_escape_names_the_tests_that_would_catch_it(self):
        self.good[4] = result("e", "ex-01.1", LARGEST, TOTAL, MEAN)
        self.assertEqual(complaints(self.catalog, self.good), [f"e: {LARGEST} does not catch it; {TOTAL}, {MEAN} would"])

    def test_a_test_that_is_never_alone_can_be_deleted(self):
        self.good[2] = result("c", "ex-01.3", MEAN, TOTAL, MEAN)
        self.assertEqual(complaints(self.catalog, self.good), [
            f"{MEAN} can be deleted and every mistake is still caught; write a mistake that only it catches, or merge it"])


if __name__ == "__main__":
    unittest.main()
