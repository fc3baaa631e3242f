"""Submissions that loop, crash, cheat or don't compile lose points where that is due, and nowhere else.

Chapter 01 is graded with one exercise spoilt in each way. Which tests that exercise decides, a stub in its place tells.
"""

import json
import tempfile
import unittest
from pathlib import Path

import strip
from exercises.catalog import read_catalog
from exercises.trees import starter_overlay
from toy_course import REAL, grade, outcomes

INCLUDES = "#include <unistd.h>\n\n#include <csignal>\n#include <cstdio>\n#include <cstdlib>\n\n"

LOOPS = """volatile bool on = true;
while (on) {
}"""

CRASHES = """volatile int* nowhere = nullptr;
*nowhere = 1;"""

FORGES_A_RESULT = r"""std::puts("[       OK ] all (0 ms)\n[==========] 1 test ran.\n[  PASSED  ] 1 test.");
std::puts("{\"verdict\":\"passed\",\"failures\":[]}");
std::FILE* file = std::fopen("results.json", "w");
std::fputs("{\"score\": 100}", file);
std::fclose(file);
std::fflush(nullptr);
_exit(0);"""

FORGES_A_VERDICT = r"""const char verdict[] = "{\"word\":\"\",\"verdict\":\"passed\",\"failures\":[]}\n";
for (int descriptor = 3; descriptor < 64; ++descriptor) {
    if (write(descriptor, verdict, sizeof(verdict) - 1) < 0) continue;
}
_exit(0);"""

LEAVES_AT_THE_START = """
namespace {
struct Leave {
    Leave() { std::exit(0); }
} leave;
}  // namespace
"""

EASY_TEST = """#include <gtest/gtest.h>
TEST(Easy, Passes) {}
"""


class Cheats(unittest.TestCase):
    tree = REAL
    chapter = "01_bezier_curves"

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.top = Path(folder.name)
        cls.catalog = read_catalog(cls.chapter, cls.tree)
        cls.exercise = strip.exercises_of_tree(cls.tree)[list(cls.catalog.exercises)[-1]]
        cls.names = {test.name for test in cls.catalog.tests}
        cls.with_stub = cls.grade(cls.spoilt("stub", ""))
        cls.decided = {name for name, state in outcomes(cls.with_stub).items() if state != "passed"}

    @classmethod
    def spoilt(cls, name, body, outside=""):
        """A submission: the reference with another body of the exercise, and more code at the end of its file."""
        top = cls.top / name
        for path in starter_overlay(cls.tree):
            text = strip.read_source(cls.tree / path)
            if path == cls.exercise.path:
                lines = [*body.splitlines(), f'throw NotImplemented("{cls.exercise.id}");']
                text = strip.with_body(text, cls.exercise, "".join(f"    {line}\n" for line in lines))
                text = INCLUDES + text + outside
            (top / path).parent.mkdir(parents=True, exist_ok=True)
            strip.write_source(top / path, text)
        return top

    @classmethod
    def grade(cls, submission):
        return grade(cls.tree, cls.catalog.number, submission, "--time-limit", "2")

    def check_decided(self, graded, state):
        """Exactly the tests that the exercise decides are lost, each for that reason."""
        found = outcomes(graded)
        self.assertEqual({name for name in self.names if found[name] != "passed"}, self.decided)
        self.assertEqual({found[name] for name in self.decided}, {state})
        self.assertEqual(graded["points"], sum(t.points for t in self.catalog.tests if t.name not in self.decided))

    def test_a_stub_costs_the_tests_of_its_exercise_and_not_all(self):
        self.check_decided(self.with_stub, "not implemented")
        self.assertLessEqual({test.name for test in self.catalog.tests_of(self.exercise.id)}, self.decided)
        self.assertLess(self.decided, self.names)

    def test_the_reference_earns_all(self):
        self.assertEqual(self.grade(self.tree)["points"], 100)

    def test_the_starter_earns_nothing(self):
        top = self.top / "starter"
        for path, content in starter_overlay(self.tree).items():
            (top / path).parent.mkdir(parents=True, exist_ok=True)
            (top / path).write_bytes(content)
        graded = self.grade(top)
        self.assertEqual(graded["points"], 0)
        self.assertEqual(set(outcomes(graded).values()), {"not implemented"})

    def test_an_endless_loop_costs_its_tests(self):
        self.check_decided(self.grade(self.spoilt("loops", LOOPS)), "timed out")

    def test_a_crash_costs_its_tests(self):
        self.check_decided(self.grade(self.spoilt("crashes", CRASHES)), "crashed")

    def test_a_forged_result_with_exit_code_0_earns_nothing(self):
        graded = self.grade(self.spoilt("forges", FORGES_A_RESULT))
        self.check_decided(graded, "no verdict")
        self.assertIn("ended before the test did (exit code 0)", {test["reason"] for test in graded["tests"]})

    def test_a_forged_verdict_earns_nothing(self):
        graded = self.grade(self.spoilt("forges_verdict", FORGES_A_VERDICT))
        self.check_decided(graded, "no verdict")
        self.assertIn("sent a verdict that is not the test's own (exit code 0)", {test["reason"] for test in graded["tests"]})

    def test_leaving_from_a_static_constructor_earns_nothing(self):
        graded = self.grade(self.spoilt("leaves", "", LEAVES_AT_THE_START))
        self.assertEqual(graded["points"], 0)
        self.assertEqual(set(outcomes(graded).values()), {"no verdict"}, "Every test program starts with that constructor.")

    def test_replaced_tests_and_points_change_nothing(self):
        top = self.spoilt("replaces", "")
        tests = top / "tests" / self.chapter
        tests.mkdir(parents=True)
        data = json.loads((self.tree / "tests" / self.chapter / "grading.json").read_text())
        for test in data["tests"]:
            test["points"] = 1
        data["tests"][0].update(name="Easy.Passes", points=101 - len(data["tests"]))
        (tests / "grading.json").write_text(json.dumps(data))
        for path in (self.tree / "tests" / self.chapter).glob("graded_*.cpp"):
            (tests / path.name).write_text(EASY_TEST)
        (top / "CMakeLists.txt").write_text("message(FATAL_ERROR mine)\n")
        (top / "tests/support").mkdir()
        (top / "tests/support/verdict.cpp").write_text("#error mine\n")
        graded = self.grade(top)
        self.check_decided(graded, "not implemented")
        self.assertEqual([test["maxPoints"] for test in graded["tests"]], [test.points for test in self.catalog.tests])

    def test_code_that_does_not_compile_is_a_clear_zero(self):
        graded = self.grade(self.spoilt("broken", "return nonsense;"))
        line = self.exercise.first + INCLUDES.count("\n") + 1
        self.assertEqual((graded["points"], graded["built"]), (0, False))
        self.assertRegex(graded["error"], rf"^{self.exercise.path}:{line}:\d+: error: .*nonsense")
        self.assertEqual({test["reason"] for test in graded["tests"]}, {graded["error"]})


if __name__ == "__main__":
    unittest.main()
