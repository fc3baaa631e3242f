"""The gates of every chapter: its data agree with its tests; the starter compiles and fails by its stubs alone; the
reference passes; the chapter builds from what is tagged up to it.

Each chapter has two trees in build/gates/. The starter's is built from nothing (ccache makes that quick), or its warnings
would be seen once only; the reference's stays, so that only what changed is built again.
"""

import json
import re
import shutil
import subprocess
import unittest

import strip
from course_lib.chapters import all_chapters
from course_lib.paths import ROOT
from exercises.building import PRESET, build_tree, program
from exercises.catalog import catalog_path, read_catalog
from exercises.grading import run_tests
from exercises.trees import files_to_build, lay_out, starter_overlay, work_folder
from schema_check import json_errors

FEWEST_EXERCISES, MOST_EXERCISES = 4, 8
OF_A_CHAPTER = re.compile(r"(?:chapters|tests)/(\d\d)_")


def listed_tests(test_program):
    """The names of the tests in a program: "Suite.Test"."""
    listing = subprocess.run([test_program, "--gtest_list_tests"], stdout=subprocess.PIPE, text=True, check=True).stdout
    names, suite = [], ""
    for line in listing.splitlines():
        word = line.split("#")[0].rstrip()
        if not line.startswith(" "):
            suite = word
        else:
            names.append(suite + word.strip())
    return names


class ChapterGates:
    """The gates of one chapter; `chapter` is set by the classes below."""

    chapter = ""

    @classmethod
    def setUpClass(cls):
        cls.number = int(cls.chapter[:2])
        cls.catalog = read_catalog(cls.chapter)
        cls.exercises = {id: e for id, e in strip.exercises_of_tree().items() if int(e.chapter) == cls.number}
        context = work_folder("gates", keep=True)
        cls.folder = context.__enter__()
        cls.addClassCleanup(context.__exit__, None, None, None)
        shutil.rmtree(cls.folder / f"{cls.chapter}_starter", ignore_errors=True)
        overlay = starter_overlay(ROOT, lambda exercise: int(exercise.chapter) >= cls.number)
        cls.starter, cls.starter_built = cls.build("starter", files_to_build(), overlay)
        cls.tags = json.loads((cls.starter / "build" / PRESET / "declarations.json").read_text())["files"]

    @classmethod
    def build(cls, name, names, overlay, variables=()):
        """Builds the graded tests and the chapter's own program."""
        tree = cls.folder / f"{cls.chapter}_{name}"
        lay_out(tree, names, overlay)
        return tree, build_tree(tree, [cls.catalog.target, cls.chapter], f"{cls.chapter}, {name}", variables)

    def outcomes(self, tree):
        ran = run_tests(self.catalog, program(tree, self.catalog.target), self.folder / "scratch")
        return {o.test.name: o.outcome for o in ran}

    def test_the_starter_compiles_without_warnings(self):
        self.assertEqual(self.starter_built.error, "")
        self.assertEqual(self.starter_built.warnings, [])

    def test_every_graded_test_fails_on_the_starter_by_a_stub(self):
        for name, outcome in self.outcomes(self.starter).items():
            self.assertEqual(outcome.state, "not implemented", f"{name}: {outcome.reason}")

    def test_the_reference_builds_from_what_is_tagged_up_to_the_chapter_and_passes(self):
        names = [name for name in files_to_build() if self.is_known(name)]
        tree, built = self.build("upto", names, {}, [f"CAUSTIC_LAST_CHAPTER={self.number}"])
        self.assertEqual(built.error, "")
        for name, outcome in self.outcomes(tree).items():
            self.assertTrue(outcome.passed, f"{name}: {outcome.state}: {outcome.reason}")

    def test_every_graded_test_is_listed(self):
        self.assertEqual(sorted(listed_tests(program(self.starter, self.catalog.target))),
                         sorted(test.name for test in self.catalog.tests))

    def test_exercises_lie_in_files_of_their_chapter(self):
        for exercise in self.exercises.values():
            self.assertEqual(self.tags[exercise.path]["chapter"], self.number, exercise.place)

    def is_known(self, name):
        """Whether a file was there when this chapter ended."""
        matched = OF_A_CHAPTER.match(name)
        number = int(matched[1]) if matched else self.tags.get(name, {}).get("chapter", 0)
        return number <= self.number

    def test_the_data_agree_with_the_sources(self):
        self.assertEqual(json_errors(catalog_path(self.chapter), "grading.schema.json"), [])
        self.assertEqual(list(self.exercises), list(self.catalog.exercises), "Is every marked exercise in grading.json?")
        self.assertTrue(FEWEST_EXERCISES <= len(self.exercises) <= MOST_EXERCISES, self.exercises)
        self.assertEqual(list(self.exercises), [f"ex-{self.number:02}.{k}" for k in range(1, len(self.exercises) + 1)])
        order = [strip.order_key(test.exercise) for test in self.catalog.tests]
        self.assertEqual(order, sorted(order), "Do the tests stand exercise by exercise?")
        for exercise in self.exercises.values():
            text = strip.read_source(ROOT / exercise.path)
            self.assertIn('#include "core/not_implemented.h"', text, exercise.path)
            self.assertTrue(strip.body(text, exercise).strip(), f"{exercise.place}: the body is empty")


def load_tests(loader, tests, pattern):
    """A class of gates for each chapter."""
    suite = unittest.TestSuite()
    for chapter in all_chapters():
        gates = type(f"Gates_{chapter}", (ChapterGates, unittest.TestCase), {"chapter": chapter})
        suite.addTests(loader.loadTestsFromTestCase(gates))
    return suite


if __name__ == "__main__":
    unittest.main()
