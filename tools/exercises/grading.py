"""Grades a chapter: lays out a tree, builds the graded tests, runs each, sums the points."""

import concurrent.futures
import contextlib
import hashlib
from dataclasses import dataclass, field

from course_lib.paths import ROOT, cores
from course_lib.terminal import Step
from exercises.building import build_tree, excerpt, foreign_files, program
from exercises.catalog import GradedTest
from exercises.trees import files_to_build, lay_out, work_folder
from exercises.verdicts import NO_VERDICT, NOT_BUILT, Outcome, run_test


@dataclass
class GradedOutcome:
    test: GradedTest
    outcome: Outcome

    @property
    def points(self):
        return self.test.points if self.outcome.passed else 0


@dataclass
class ChapterGrade:
    """What a chapter is worth."""

    catalog: object
    outcomes: list  # of GradedOutcome, in the catalog's order
    error: str = ""  # the compiler's first error when it did not build
    excerpt: str = ""  # more of what the compiler said
    notes: list = field(default_factory=list)  # what an instructor or student should know besides

    @property
    def chapter(self):
        return self.catalog.chapter

    @property
    def points(self):
        return sum(outcome.points for outcome in self.outcomes)

    @property
    def done(self):
        """Ids of the exercises whose tests all pass."""
        return [id for id in self.catalog.exercises if all(o.outcome.passed for o in self.of_exercise(id))]

    def of_exercise(self, id):
        return [outcome for outcome in self.outcomes if outcome.test.exercise == id]


def not_built(catalog, error, output, notes=()):
    outcomes = [GradedOutcome(test, Outcome(NOT_BUILT, error)) for test in catalog.tests]
    return ChapterGrade(catalog, outcomes, error, excerpt(output), list(notes))


def grade_overlay(catalog, overlay, notes=(), time_limit=None, root=ROOT):
    """Grades a chapter on this tree with `overlay` (path -> bytes) put over it, in a fresh tree of its own."""
    with work_folder("grade") as folder:
        tree = folder / "tree"
        lay_out(tree, files_to_build(root), overlay, root)
        built = build_tree(tree, [catalog.target], catalog.chapter)
        if built.error:
            return not_built(catalog, built.error, built.output, notes)
        foreign = foreign_files(tree)
        if foreign:
            error = f"{foreign[0][0]}: includes {foreign[0][1]}, which is no file of the course"
            return not_built(catalog, error, "", notes)
        outcomes = run_tests(catalog, program(tree, catalog.target), folder / "scratch", at_most(time_limit),
                             f"test {catalog.chapter}")
        return ChapterGrade(catalog, outcomes, notes=list(notes))


def run_tests(catalog, test_program, scratch, limit_of=lambda test: test.time_limit, title=""):
    """Runs all graded tests of a chapter, a few at a time.

    @param limit_of  gives a test's time limit in seconds
    @param title  what the progress line says; none is shown when it is empty
    """
    digest = file_digest(test_program)

    def run_one(test):
        if file_digest(test_program) != digest:
            return Outcome(NO_VERDICT, "a test before it has changed the test program")
        return run_test(test_program, test.name, limit_of(test), test.memory_limit, scratch)

    with contextlib.ExitStack() as stack:
        step = stack.enter_context(Step(title)) if title else None
        pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(cores()))
        waiting = {pool.submit(run_one, test): test for test in catalog.tests}
        outcomes = {}
        for finished in concurrent.futures.as_completed(waiting):
            outcomes[waiting[finished].name] = finished.result()
            if step:
                step.progress(len(outcomes), len(waiting))
    return [GradedOutcome(test, outcomes[test.name]) for test in catalog.tests]


def at_most(seconds):
    """Time limits as grading.json gives them, none above `seconds` (when there is such a bound)."""
    return lambda test: min(test.time_limit, seconds) if seconds else test.time_limit


def file_digest(path):
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""
