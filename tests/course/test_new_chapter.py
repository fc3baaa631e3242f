"""./course new-chapter: what it writes passes every gate of a chapter, in a course of two tiny chapters that it becomes the third of."""

import csv
import re
import shutil
import unittest

import strip
from docs.builder import Builder
from exercises.catalog import read_catalog
from schema_check import json_errors
from toy_course import REAL, ToyCase, course, grade, outcomes

CHAPTER = "03_rules_of_area"
SUPPORT = ("paths.h", "failure_checks.h", "failure_checks.cpp")
TOPIC_OF_SUPPORT = """caustic_topic(support USES core figure
  CHAPTER 1
    test_main.cpp
    verdict.h verdict.cpp
    paths.h
    failure_checks.h failure_checks.cpp
  LIBRARIES GTest::gtest)
"""
FRONT_PAGE = "# Toy\n\n| | chapter |\n| --- | --- |\n| 01 | [First](x) |\n| 02 | [Second](y) |\n\nEnd.\n"


class NewChapter(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in SUPPORT:
            shutil.copy2(REAL / "tests/support" / name, cls.toy / "tests/support" / name)
        cmake = cls.toy / "tests/support/CMakeLists.txt"
        cmake.write_text(re.sub(r"caustic_topic\([^)]*\)\n", TOPIC_OF_SUPPORT, cmake.read_text()))
        with (cls.toy / "chapters/CMakeLists.txt").open("a") as cmake:
            cmake.write("\nadd_custom_target(preview)  # the toy has no viewer\n")
        (cls.toy / "README.md").write_text(FRONT_PAGE)
        for chapter in ("01_first", "02_second"):
            (cls.toy / "chapters" / chapter / "README.md").write_text(f"# {chapter}\n")
        cls.made = course(cls.toy, "new-chapter", CHAPTER)
        assert cls.made.returncode == 0, cls.made.stderr

    def run_course(self, *words):
        ended = course(self.toy, *words)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        return ended.stdout

    def test_it_says_what_is_next_and_lists_the_chapter_everywhere(self):
        self.assertIn("./course test 03", self.made.stdout)
        self.assertIn(f"| 02 | [Second](y) |\n| 03 | [Rules of area](chapters/{CHAPTER}/README.md) |", (self.toy / "README.md").read_text())
        self.assertNotRegex(self.made.stdout, "@[A-Z]+@")
        for path in self.toy.rglob("*rules_of_area*"):
            if path.is_file() and "build" not in path.parts:
                self.assertNotRegex(path.read_text(), "@[A-Z]+@", path)

    def test_its_data_agree_and_fit_their_schema(self):
        place = self.toy / "tests" / CHAPTER / "grading.json"
        self.assertEqual(json_errors(place, "grading.schema.json"), [])
        catalog = read_catalog(CHAPTER, self.toy)
        marked = [id for id in strip.exercises_of_tree(self.toy) if id.startswith("ex-03")]
        self.assertEqual(marked, list(catalog.exercises))
        self.assertEqual(catalog.points, 100)

    def test_tests_pass_and_mistakes_are_caught(self):
        self.run_course("test", "03")
        said = self.run_course("mutants", "03")
        self.assertIn("7 mistakes in 4 exercises, all caught by the test that they name; each of the 4 graded tests is the only one", said)
        self.assertRegex(said, r"trapezoid_by_trapezoid +ex-03\.3 +full points")

    def test_figures_are_drawn_with_the_tables_that_a_chapter_owes(self):
        self.run_course("figures", "03", "--quality", "draft")
        folder = self.toy / "build/figures" / CHAPTER
        declared = re.search(rf"caustic_chapter\({CHAPTER} FIGURES ([^)]*)\)", (self.toy / "chapters/CMakeLists.txt").read_text())
        self.assertEqual(sorted(path.name for path in folder.glob("*.png")), sorted(declared[1].split()))
        with (folder / "speed_accuracy.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        methods = {row["method"] for row in rows}
        self.assertGreaterEqual(len(methods), 3)
        for method in methods:
            self.assertGreaterEqual(sum(row["method"] == method for row in rows), 5)
        with (folder / "failure.csv").open(newline="") as file:
            self.assertTrue(all(int(row["trials"]) >= 1000 for row in csv.DictReader(file)))
        self.assertTrue((folder / "quantity.csv").exists())

    def test_every_graded_test_fails_on_the_starter_by_a_stub(self):
        student = self.toy.parent / "student"
        self.run_course("start", student)
        graded = grade(self.toy, "03", student)
        self.assertEqual(set(outcomes(graded).values()), {"not implemented"})

    def test_its_lesson_shows_each_exercise(self):
        figures = self.toy / "figures" / CHAPTER
        figures.mkdir(parents=True)
        self.addCleanup(shutil.rmtree, figures)
        for name in ("order.png", "speed_accuracy.png", "failure.png"):
            (figures / name).write_bytes(b"")
        topics = {"topics": {"core": [], "math": []}, "files": {}, "chapters": {}}
        problems = Builder(self.toy, self.toy / "build/docs", self.toy / "build/declarations.json", topics).lesson_problems()
        self.assertEqual([problem for problem in problems if CHAPTER in problem and not problem.startswith("README.md")], [])

    def test_wrong_names_are_refused_in_one_line(self):
        for words, reason in ((["05_late"], "the next chapter is 04, not 05; write 04_late"),
                              (["4_x"], "is no chapter's name"), (["04_Big"], "is no chapter's name"),
                              (["04_x", "--topic", "light"], "there is no topic 'light'; there are core, figure, math"),
                              (["04_sums"], "common/math/sums.cpp is there already")):
            with self.subTest(words=words):
                ended = course(self.toy, "new-chapter", *words)
                self.assertEqual(ended.returncode, 1)
                self.assertIn(reason, ended.stderr)
                self.assertEqual(ended.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
