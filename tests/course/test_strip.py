"""tools/strip.py: finding exercises, refusing broken markers, making the starter."""

import tempfile
import unittest
from pathlib import Path

import strip
from course_lib.errors import CourseError

TWO_EXERCISES = """int one() {
    //! [ex-01.1]
    const int x = 1;
    return x;
    //! [ex-01.1]
}

int two() {
  //! [ex-01.2]
  return 2;
  //! [ex-01.2]
}
"""

STARTER = """int one() {
    //! [ex-01.1]
    throw NotImplemented("ex-01.1");
    //! [ex-01.1]
}

int two() {
  //! [ex-01.2]
  throw NotImplemented("ex-01.2");
  //! [ex-01.2]
}
"""


def complaint(text):
    try:
        strip.find_exercises(text, "a.cpp")
    except CourseError as error:
        return str(error)
    return ""


class Strip(unittest.TestCase):
    def test_exercises_are_found_with_their_lines(self):
        found = strip.find_exercises(TWO_EXERCISES, "a.cpp")
        self.assertEqual([(e.id, e.place, e.last) for e in found], [("ex-01.1", "a.cpp:2", 5), ("ex-01.2", "a.cpp:9", 11)])
        self.assertEqual(found[0].chapter, "01")

    def test_bodies_become_stubs_and_markers_stay(self):
        self.assertEqual(strip.strip(TWO_EXERCISES, "a.cpp"), STARTER)

    def test_stripping_twice_changes_nothing_more(self):
        self.assertEqual(strip.strip(STARTER, "a.cpp"), STARTER)

    def test_only_the_chosen_exercises_are_stripped(self):
        text = strip.strip(TWO_EXERCISES, "a.cpp", lambda exercise: exercise.id == "ex-01.2")
        self.assertIn("const int x = 1;", text)
        self.assertNotIn("return 2;", text)

    def test_a_body_can_be_taken_and_put_back(self):
        exercise = strip.find_exercises(TWO_EXERCISES, "a.cpp")[0]
        taken = strip.body(TWO_EXERCISES, exercise)
        self.assertEqual(taken, "    const int x = 1;\n    return x;\n")
        starter = strip.find_exercises(STARTER, "a.cpp")
        whole = strip.with_body(STARTER, starter[0], taken)
        self.assertEqual(strip.find_exercises(whole, "a.cpp")[0], exercise)

    def test_every_byte_outside_the_bodies_stays(self):
        text = "// \x0c caf\udce9\r\n" + TWO_EXERCISES.replace("\n", "\r\n")
        stripped = strip.strip(text, "a.cpp")
        self.assertTrue(stripped.startswith("// \x0c caf\udce9\r\n"), "Does a form feed end a line, or a byte get lost?")
        self.assertNotIn("const int x", stripped)

    def test_an_unpaired_marker_is_an_error_at_its_line(self):
        self.assertIn("a.cpp:1: ex-01.1 has no closing marker", complaint("//! [ex-01.1]\nint x;\n"))

    def test_a_nested_marker_is_an_error_at_its_line(self):
        self.assertIn("a.cpp:2: ex-01.2 is nested in ex-01.1", complaint("//! [ex-01.1]\n//! [ex-01.2]\n"))

    def test_a_second_pair_is_an_error(self):
        pair = "//! [ex-01.1]\n//! [ex-01.1]\n"
        self.assertIn("a.cpp:3: ex-01.1 is marked twice", complaint(pair + pair))

    def test_a_marker_that_is_almost_right_is_an_error(self):
        for line in ("//! [ex-1.1]", "x; //! [ex-01.1]", "//! ex-01.1", "//! [ex-01.1] text", "//![EX-01.1]"):
            self.assertIn("a.cpp:1: a marker is", complaint(line + "\n"), line)

    def test_a_comment_that_mentions_an_exercise_is_no_marker(self):
        self.assertEqual(complaint("/// @param exercise  its marker, as in \"ex-01.1\"\n//! An example.\n"), "")

    def test_an_exercise_in_two_files_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            common = Path(folder) / "common" / "math"
            common.mkdir(parents=True)
            for name in ("a.cpp", "b.h"):
                (common / name).write_text("//! [ex-01.1]\n//! [ex-01.1]\n")
            with self.assertRaisesRegex(CourseError, r"b\.h:1: ex-01\.1 is marked at common/math/a\.cpp:1 too"):
                strip.exercises_of_tree(Path(folder))

    def test_the_tenth_exercise_follows_the_ninth(self):
        self.assertLess(strip.order_key("ex-01.9"), strip.order_key("ex-01.10"))
        self.assertLess(strip.order_key("ex-02.9"), strip.order_key("ex-10.1"))


if __name__ == "__main__":
    unittest.main()
