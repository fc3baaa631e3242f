"""Submissions that loop, crash, cheat or don't compile lose points where that is due, and nowhere else.

Chapter 01 is graded with one exercise spoilt in each way. Which tests that exercise decides, a stub in its place tells.
"""

import json
import tempfile
import unittest
from pathlib import Path

import strip
from exercises.catalog import read_catalog
from exercises.splicing import Spliced
from exercises.trees import starter_overlay
from toy_course import REAL, grade, outcomes

LOOPS = """volatile bool on = true;
while (on) {
}"""

CRASHES = """volatile int* nowhere = nullptr;
*nowhere = 1;"""

FORGES_A_RESULT = r"""std::puts("[       OK ] all (0 ms)\n[==========] 1 test ran.\n[  PASSED  ] 1 test.");
std::puts("{\"verdict\":\"passed\",\"failures\":[]}");
std::fflush(stdout);
std::exit(0);"""

# Each got points when whole files were taken. Here they stand outside of the bodies, where nothing counts.
IN_FRONT = """#include <unistd.h>
#include <gtest/gtest.h>
#undef EXPECT_NEAR
#define EXPECT_NEAR(a, b, c) EXPECT_TRUE(true)
"""
AT_THE_END = r"""
namespace {
struct Leave {
    Leave() {
        const char verdict[] = "{\"word\":\"\",\"verdict\":\"passed\",\"failures\":[]}\n";
        for (int descriptor = 3; descriptor < 64; ++descriptor) write(descriptor, verdict, sizeof verdict - 1);
        _exit(0);
    }
} leave;
}  // namespace
namespace testing {
TestInfo* UnitTest::current_test_info() { return nullptr; }
bool UnitTest::Passed() const { return true; }
}  // namespace testing
asm(".incbin \"common/curve/bezier_curve.cpp\"");
"""

# The same, and more, from within a body: what it takes has a name, and a body with that name is not taken.
FROM_WITHIN = {
    "reads the word from its command line": 'std::ifstream line("/proc/self/cmdline");',
    "reads it by the C library": 'auto* line = std::fopen("/proc/self/cmdline", "r");',
    "a class with a constructor for the start": "struct X { [[gnu::constructor]] static void f() {} };",
    "a detached child": "if (fork() == 0) setsid();",
    "reads the reference": 'std::ifstream reference("../common/curve/bezier_curve.cpp");',
    "takes the reference in": '#include "../reference.h"',
    "takes it in at assembly": 'asm(".incbin \\"reference.cpp\\"");',
    "replaces an assertion": "#define EXPECT_NEAR(a, b, c)",
    "replaces it by a pragma": '_Pragma("push_macro(\\"EXPECT_NEAR\\")")',
    "says that all is well": "::testing::UnitTest::GetInstance()->listeners();",
    "skips the test": "GTEST_SKIP();",
    "writes into the grader's tree": 'std::ofstream("../common/curve/bezier_curve.cpp") << 1;',
    "removes it": 'std::filesystem::remove_all("..");',
    "kills its parent": "kill(getppid(), 9);",
    "runs a program": 'std::system("true");',
    "leaves the body": "}\nint more() {",
    "leaves it by a text that looks open": 'const char* x = R"(";)"; }\nint more() { //"',
    "leaves it by a joined line": "// \\\n}\nint more() {",
    "calls by number": "syscall(57);",
    "finds a function": 'auto* f = dlsym(nullptr, "fork");',
}

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
    def spoilt(cls, name, body, in_front="", at_the_end=""):
        """A submission: the reference with another body of the exercise, and more code around it in its file."""
        top = cls.top / name
        for path in starter_overlay(cls.tree):
            text = strip.read_source(cls.tree / path)
            if path == cls.exercise.path:
                lines = [*body.splitlines(), f'throw NotImplemented("{cls.exercise.id}");']
                text = strip.with_body(text, cls.exercise, "".join(f"    {line}\n" for line in lines))
                text = in_front + text + at_the_end
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
        self.assertIn("has exit: a person should look at it", " ".join(graded["looks"]))

    def test_attacks_from_within_a_body_are_refused(self):
        for name, attack in FROM_WITHIN.items():
            text = strip.read_source(self.tree / self.exercise.path)
            spliced = Spliced()
            body = f"    {attack}\n    return {{}};\n"
            spliced.add(self.exercise.path, strip.strip(text, self.exercise.path),
                        strip.with_body(text, self.exercise, body).encode())
            self.assertIn(self.exercise.id, spliced.refused, name)
            self.assertNotIn(attack, spliced.texts[self.exercise.path], name)

    def test_a_refused_body_costs_what_a_stub_costs(self):
        graded = self.grade(self.spoilt("refused", FROM_WITHIN["kills its parent"]))
        found = outcomes(graded)
        self.assertEqual({name for name in self.names if found[name] != "passed"}, self.decided)
        self.assertEqual({found[test.name] for test in self.catalog.tests_of(self.exercise.id)}, {"refused"})
        self.assertEqual(graded["points"], self.with_stub["points"])
        self.assertIn(f"{self.exercise.id} is refused", graded["notes"][0])

    def test_what_is_replaced_around_the_bodies_changes_nothing(self):
        top = self.spoilt("replaces", "", IN_FRONT, AT_THE_END)
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
        self.assertEqual(graded["notes"], [f"{self.exercise.path}:1: changed outside of an exercise's body, which does not count"])
        self.assertEqual([test["maxPoints"] for test in graded["tests"]], [test.points for test in self.catalog.tests])

    def test_code_that_does_not_compile_costs_its_own_tests(self):
        graded = self.grade(self.spoilt("broken", "return nonsense;"))
        self.assertEqual((graded["points"], graded["built"]), (self.with_stub["points"], False))
        error = rf"^{self.exercise.path}:{self.exercise.first + 1}:\d+: error: .*nonsense"
        self.assertRegex(graded["error"], error)
        for test in graded["tests"]:
            if test["exercise"] == self.exercise.id:
                self.assertEqual(test["outcome"], "did not build")
                self.assertRegex(test["reason"], error)


if __name__ == "__main__":
    unittest.main()
