"""The gates of every chapter: its data agree with its tests; the starter compiles and fails by its stubs alone; the
reference passes; the chapter builds from what is tagged up to it.

All chapters share one tree in build/gates/, which grows: for each chapter in turn it gets the files that were there when
the chapter ended, at first with the chapter's exercises as stubs, then with the reference's bodies. So each file is compiled
once. A tree whose last build said anything, or came to no end, is built anew: whatever a compiler warns of is seen.

One chapter alone: cd tests/course && PYTHONPATH=../../tools CAUSTIC_BUILD_DIR=../../build/release python3 -m unittest -k Gates_06 test_gates
"""

import json
import os
import subprocess
import unittest
from dataclasses import dataclass
from pathlib import Path

import strip
from course_lib.chapters import all_chapters
from course_lib.checks import known_files
from course_lib.paths import ROOT
from exercises.building import Built, build_tree, program
from exercises.catalog import catalog_path, read_catalog
from exercises.grading import run_tests
from exercises.trees import lay_out, remove_tree, starter_overlay, work_folder
from schema_check import json_errors

FEWEST_EXERCISES, MOST_EXERCISES = 4, 8
UNFINISHED = "unfinished"
TAGS = json.loads((Path(os.environ["CAUSTIC_BUILD_DIR"]) / "declarations.json").read_text())["files"]


@dataclass
class Stage:
    """A chapter's graded tests, built and run on one state of the tree."""

    built: Built
    listed: list  # names of the tests in the program
    outcomes: dict  # name -> what became of the test


def setUpModule():
    global work
    context = work_folder("gates", keep=True)
    work = context.__enter__()
    unittest.addModuleCleanup(context.__exit__, None, None, None)
    if (work / UNFINISHED).exists():
        remove_tree(work / "tree")


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
    said_nothing = True  # the compiler, in all builds so far

    @classmethod
    def setUpClass(cls):
        cls.number = int(cls.chapter[:2])
        cls.catalog = read_catalog(cls.chapter)
        cls.exercises = {id: e for id, e in strip.exercises_of_tree().items() if int(e.chapter) == cls.number}
        cls.starter = cls.stage("starter", starter_overlay(ROOT, lambda exercise: int(exercise.chapter) == cls.number))
        cls.reference = cls.stage("reference", {})

    @classmethod
    def stage(cls, name, overlay):
        """Brings the tree to the chapter, builds its graded tests and its own program, and runs the tests."""
        tree = work / "tree"
        (work / UNFINISHED).touch()
        lay_out(tree, known_files(cls.number), overlay)
        built = build_tree(tree, [cls.catalog.target, cls.chapter], f"{cls.chapter}, {name}",
                           [f"CAUSTIC_LAST_CHAPTER={cls.number}", "CAUSTIC_ASSERTIONS=OFF"])
        cls.said_nothing = cls.said_nothing and not built.error and not built.warnings
        if cls.said_nothing:
            (work / UNFINISHED).unlink()
        if built.error:
            return Stage(built, [], {})
        test_program = program(tree, cls.catalog.target)
        ran = run_tests(cls.catalog, test_program, work / "scratch")
        return Stage(built, listed_tests(test_program), {o.test.name: o.outcome for o in ran})

    def test_the_starter_compiles_without_warnings(self):
        self.assertEqual(self.starter.built.error, "")
        self.assertEqual(self.starter.built.warnings, [])

    def test_every_graded_test_fails_on_the_starter_by_a_stub(self):
        self.assertTrue(self.starter.outcomes, self.starter.built.error)
        for name, outcome in self.starter.outcomes.items():
            self.assertEqual(outcome.state, "not implemented", f"{name}: {outcome.reason}")

    def test_the_reference_builds_from_what_is_tagged_up_to_the_chapter_and_passes(self):
        self.assertEqual(self.reference.built.error, "")
        self.assertEqual(self.reference.built.warnings, [])
        for name, outcome in self.reference.outcomes.items():
            self.assertTrue(outcome.passed, f"{name}: {outcome.state}: {outcome.reason}")

    def test_every_graded_test_is_listed(self):
        self.assertEqual(sorted(self.reference.listed), sorted(test.name for test in self.catalog.tests))

    def test_exercises_lie_in_files_of_their_chapter(self):
        for exercise in self.exercises.values():
            self.assertEqual(TAGS[exercise.path]["chapter"], self.number, exercise.place)

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
