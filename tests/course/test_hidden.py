"""Hidden tests: they count beside the public ones, no student is told of them, and their faults cost nobody a point."""

import json
import random
import unittest

from commands.hidden import with_other_seeds
from exercises.catalog import read_catalog
from exercises.hidden import with_hidden
from exercises.trees import starter_overlay
from schema_check import json_errors, read, xml_errors
from toy_course import ToyCase, course, solve, where

SOURCE = """#include <gtest/gtest.h>

#include "known.h"
#include "math/sums.h"

namespace caustic {
namespace {

TEST(Hidden, TotalOfOtherValues) { EXPECT_EQ(total({secret, 10}), 17) << "Is 7 answered, too?"; }

TEST(Hidden, LargestOfOtherValues) { EXPECT_EQ(largest({-8, -5}), -5); }

}  // namespace
}  // namespace caustic
"""
TESTS = [
    {"name": "Hidden.TotalOfOtherValues", "exercise": "ex-01.1", "points": 15, "lookAt": "The values that are known."},
    {"name": "Hidden.LargestOfOtherValues", "exercise": "ex-01.2", "points": 5, "lookAt": "The same."},
]


class Hidden(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.cheat = cls.top / "cheat"
        for path, content in starter_overlay(cls.toy).items():
            (cls.cheat / path).parent.mkdir(parents=True, exist_ok=True)
            (cls.cheat / path).write_bytes(content)
        solve(cls.cheat, cls.toy, "ex-01.1", "ex-01.2", "ex-01.3", "ex-01.4")
        path = cls.cheat / "common/math/sums.cpp"
        path.write_text(path.read_text().replace("double sum = 0;\n    for (const double value : values) sum += value;\n    return sum;",
                                                 "return values.size() == 3 ? 3 + 6 * (values[0] == 1 && values[1] == 2) : 0;"))

    def setUp(self):
        self.folder = self.top / "hidden"
        place = self.folder / "01_first"
        place.mkdir(parents=True, exist_ok=True)
        (place / "others.cpp").write_text(SOURCE)
        (place / "known.h").write_text("#pragma once\nconstexpr double secret = 7;\n")
        self.write({"chapter": "01_first", "tests": TESTS})

    def write(self, data):
        (self.folder / "01_first/grading.json").write_text(data if isinstance(data, str) else json.dumps(data))

    def test_what_answers_the_public_tests_alone_is_found_out(self):
        paths = {kind: self.top / f"report.{kind}" for kind in ("json", "gradescope", "junit")}
        ended = course(self.toy, "grade", "01", "--submission", self.cheat, "--hidden", self.folder, *where(),
                       *(word for kind, path in paths.items() for word in (f"--{kind}", path)))
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertRegex(ended.stdout, r"Hidden\.TotalOfOtherValues \(hidden\) +ex-01\.1 +0/15 +failed +Is 7 answered")
        self.assertIn("01_first: 105 of 120 points", ended.stdout)
        self.assertEqual(json_errors(paths["json"], "grades.schema.json"), [])
        self.assertEqual(json_errors(paths["gradescope"], "gradescope.schema.json"), [])
        self.assertEqual(xml_errors(paths["junit"], "junit.xsd"), [])
        graded = read(paths["json"])["chapters"][0]
        self.assertEqual((graded["points"], graded["maxPoints"]), (105, 120))
        self.assertEqual([test["name"] for test in graded["tests"] if test["hidden"]], [test["name"] for test in TESTS])
        results = read(paths["gradescope"])
        self.assertEqual([test["visibility"] for test in results["tests"]], ["visible"] * 4 + ["hidden"] * 2)
        self.assertEqual(results["score"], 105)
        self.assertIn("01_first: 100 of 100 points", results["output"], "Does a student see no hidden point?")
        for said in ("Hidden", "105", "120"):
            self.assertNotIn(said, results["output"])

    def test_a_folder_of_hand_ins_is_graded_by_them_too(self):
        hand_ins = self.top / "hand_ins"
        hand_ins.mkdir()
        self.cheat.rename(hand_ins / "cheat")
        self.addCleanup((hand_ins / "cheat").rename, self.cheat)
        ended = course(self.toy, "grade", "01", "--all", hand_ins, "--hidden", self.folder, *where())
        self.assertRegex(ended.stdout, r"cheat +105 +105", ended.stderr)
        self.assertIn("Hidden.TotalOfOtherValues (hidden)", (self.toy / "build/grades.html").read_text())
        self.assertEqual(list((self.toy / "tests/01_first").glob("*hidden*")), [], "Does the course's own tree stay as it was?")

    def test_what_is_wrong_with_the_folder_is_said_before_anything_is_built(self):
        renamed = [{**TESTS[0], "name": "Hidden.Other"}, TESTS[1]]
        for data, reason in (("{", "grading.json: "), ({"tests": TESTS}, "'chapter': '01_first'"),
                             ({"chapter": "01_first", "tests": renamed}, "no source beside it has a test Hidden.Other"),
                             ({"chapter": "01_first", "tests": TESTS[:1]}, "it does not list Hidden.LargestOfOtherValues"),
                             ({"chapter": "01_first", "tests": [{**TESTS[0], "points": 0}]}, "'points' of Hidden."),
                             ({"chapter": "01_first", "tests": [{**TESTS[0], "name": "Clamp.StaysWithinBounds"}]}, "is listed twice")):
            self.write(data)
            self.refused("01", self.folder, reason)
        self.setUp()
        self.refused("02", self.folder, "has no hidden tests of 02_second")
        self.refused("01", self.top / "none", "there is no folder")
        path = self.folder / "01_first/toy.h"
        path.write_text("")
        (self.toy / "tests/01_first/toy.h").write_text("")
        self.refused("01", self.folder, "the course has a tests/01_first/toy.h itself")
        path.unlink()
        (self.folder / "01_first/grading.json").unlink()
        self.refused("01", self.folder, "grading.json cannot be read")

    def refused(self, chapter, folder, reason):
        ended = course(self.toy, "grade", chapter, "--submission", self.cheat, "--hidden", folder, *where())
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (1, 1), ended.stderr)
        self.assertIn(reason, ended.stderr)


SEEDED = """#include "x.h"

namespace {

// Without.
TEST(Plain, Stays) { EXPECT_EQ(f(1), 1); }

// With:
// two lines.
TEST(Drawn, Stays) {
    for (int i = 0; i < 9; ++i) {
        Random random(7, {i});
        EXPECT_GT(random.uniform() + Random(8, {i}).uniform(), 0);
    }
}

TEST(Sampled, Stays) { EXPECT_TRUE(g(SobolSampler{3}, 5)); }

}  // namespace
"""


class OtherSeeds(ToyCase):
    def test_tests_with_a_seed_get_another_one_and_others_are_left_out(self):
        text, names = with_other_seeds(SEEDED, random.Random(5))
        self.assertEqual(names, ["Drawn.Stays", "Sampled.Stays"])
        self.assertNotIn("Plain", text)
        self.assertNotIn("Without", text)
        self.assertRegex(text, r"// With:\n// two lines\.\nTEST\(HiddenDrawn, Stays\) \{\n.*\n +Random random\(\d{3,}, \{i\}\);\n")
        self.assertRegex(text, r"Random\(\d{3,}, \{i\}\)\.uniform\(\), 0\);\n    \}\n\}\n\nTEST\(HiddenSampled, Stays\)")
        self.assertRegex(text, r"SobolSampler\{\d{3,}\}, 5\)")
        self.assertNotEqual(text, with_other_seeds(SEEDED, random.Random(6))[0])

    def test_they_are_taken_as_they_are_written(self):
        path = self.toy / "tests/01_first/graded_sums.cpp"
        text = path.read_text().replace("EXPECT_EQ(total({}), 0);", "const Random random(1);\n    EXPECT_EQ(total({random.value, -1}), random.value - 1);")
        path.write_text(text.replace("namespace {\n", "namespace {\n\nstruct Random {\n    double value;\n"
                                     "    explicit Random(int seed) : value(seed) {}\n};\n", 1))
        folder = self.top / "begun"
        self.assertIn("1 test with other seeds", course(self.toy, "hidden", folder).stdout)
        catalog = with_hidden(read_catalog("01_first", self.toy), folder, self.toy)
        self.assertEqual((catalog.tests[-1].name, catalog.points), ("HiddenSums.TotalAddsAllValues", 140))
        for words, reason in (((folder,), "is not empty"), ((self.top / "no", "2"), "no graded test of 02_second draws random")):
            self.assertIn(reason, course(self.toy, "hidden", *words).stderr)


if __name__ == "__main__":
    unittest.main()
