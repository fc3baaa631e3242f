"""Grades a chapter: lays out a tree, builds the graded tests, runs each, sums the points."""

import concurrent.futures
import contextlib
import hashlib
import os
import time
from dataclasses import dataclass, field

from course_lib.errors import CourseError
from course_lib.paths import ROOT, cores
from course_lib.terminal import Step
from exercises.building import build_tree, excerpt, failures, first_error, mentions, program
from exercises.catalog import GradedTest
from exercises.hidden import is_hidden
from exercises.splicing import encoded, without_exercise
from exercises.trees import files_to_build, lay_out
from exercises.verdicts import NO_VERDICT, NOT_BUILT, NOT_IMPLEMENTED, REFUSED, TIMED_OUT, Outcome, run_test
from strip import find_exercises

MOST_BUILD_TIME = 900  # seconds to build a hand-in's chapter, its library included
MOST_TEST_TIME = 90  # seconds for all tests of a hand-in's chapter


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
    error: str = ""  # the compiler's first error when something did not build, or why the hand-in was refused
    excerpt: str = ""  # more of what the compiler said
    notes: list = field(default_factory=list)  # what an instructor or student should know besides
    looks: list = field(default_factory=list)  # what a person should look at

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


@dataclass(frozen=True)
class Conditions:
    """Under which a hand-in is graded."""

    time_limit: float = None  # seconds that no test gets more than
    test_time: float = MOST_TEST_TIME  # seconds for all tests of a chapter; None for no such limit
    build_time: float = MOST_BUILD_TIME  # seconds to build a chapter; None for no such limit
    sandboxed: bool = False
    quiet: bool = False  # whether no progress lines are shown
    jobs: int = None  # compilers and tests at a time; None for one a processor


@dataclass
class Building:
    """How the bodies of a hand-in were built."""

    broken: dict  # exercise -> the compiler's first error
    error: str = ""  # the first error of all
    excerpt: str = ""
    built: bool = True  # whether there is a test program


def worthless(catalog, state, reason, said="", notes=(), looks=()):
    """A chapter all of whose tests are lost for one reason."""
    outcomes = [GradedOutcome(test, Outcome(state, reason)) for test in catalog.tests]
    return ChapterGrade(catalog, outcomes, reason, said, list(notes), list(looks))


def not_built(catalog, error, output, notes=()):
    return worthless(catalog, NOT_BUILT, error, excerpt(output), notes)


def grade_spliced(catalog, spliced, folder, conditions=Conditions(), root=ROOT):
    """Grades a chapter on this tree with a hand-in's bodies in it, in a tree of its own below `folder`.

    A body that does not compile costs its own exercise's points: a stub takes its place.
    """
    tree = folder / "tree"
    names = files_to_build(root)
    building = build_bodies(catalog, dict(spliced.texts), tree,
                            lambda overlay: lay_out(tree, names, {**overlay, **catalog.files}, root), conditions)
    if not building.built and is_hidden(building.error):
        raise CourseError(f"a hidden test does not build: {building.error}")
    if not building.built:
        return worthless(catalog, NOT_BUILT, building.error, building.excerpt, spliced.notes, spliced.looks)
    known = {id: Outcome(REFUSED, reason) for id, reason in spliced.refused.items()}
    known.update({id: Outcome(NOT_BUILT, reason) for id, reason in building.broken.items()})
    outcomes = run_tests(catalog, program(tree, catalog.target), folder / "scratch", at_most(conditions.time_limit),
                         "" if conditions.quiet else f"test {catalog.chapter}", known, conditions.test_time,
                         conditions.sandboxed, conditions.jobs)
    refused = [f"{id} is refused: {reason}" for id, reason in spliced.refused.items()]
    return ChapterGrade(catalog, outcomes, building.error, building.excerpt, [*refused, *spliced.notes], spliced.looks)


def build_bodies(catalog, texts, tree, put, conditions):
    """Builds, and takes out the bodies that do not compile until the rest does.

    @param texts  path -> text, of the files with exercises
    @param put  lays out the tree with such files
    """
    building = Building({})
    title = "" if conditions.quiet else catalog.chapter
    begin = time.monotonic()
    while True:
        put({path: encoded(text) for path, text in texts.items()})
        left = None if conditions.build_time is None else begin + conditions.build_time - time.monotonic()
        built = build_tree(tree, [catalog.target], title, keep_going=True, sandboxed=conditions.sandboxed,
                           jobs=conditions.jobs, most_seconds=left)
        if not built.error:
            return building
        if not building.error:
            building.error, building.excerpt = built.error, excerpt(built.output)
        found = {id: error for id, error in guilty(built.output, texts).items() if id not in building.broken}
        if not found:
            building.built = False
            return building
        building.broken.update(found)
        for id in found:
            path = next(path for path in texts if any(e.id == id for e in find_exercises(texts[path], path)))
            texts[path] = without_exercise(texts[path], path, id)


def guilty(output, texts):
    """The exercises whose bodies do not compile: id -> the compiler's first error.

    Of each file that the compiler gave up on only the first error counts: one mistake may lead to many.
    """
    found = {}
    for said in failures(output):
        for id in guilty_of_one(said, texts):
            found.setdefault(id, first_error(said))
    return found


def guilty_of_one(said, texts):
    for path, line in mentions(said, texts):
        id = exercise_at(texts[path], path, line)
        if id:
            return [id]
    # The linker's errors, and a compiler that was ended, name an object file at most.
    return [e.id for path, text in texts.items() if f"{os.path.basename(path)}.o" in said for e in find_exercises(text, path)]


def exercise_at(text, path, line):
    """The exercise whose body is at a line, or ends before it: what a body lacks at its end, the compiler misses behind."""
    before = [e.id for e in find_exercises(text, path) if e.first <= line]
    return before[-1] if before else ""


def run_tests(catalog, test_program, scratch, limit_of=lambda test: test.time_limit, title="", known=None, test_time=None,
              sandboxed=False, jobs=None):
    """Runs all graded tests of a chapter, a few at a time.

    @param limit_of  gives a test's time limit in seconds
    @param title  what the progress line says; none is shown when it is empty
    @param known  exercise -> what became of its tests, which are not run
    @param test_time  seconds after which no further test is begun; None for no such limit
    @param sandboxed  whether each test runs in the sandbox
    @param jobs  how many tests run at a time; None for one a processor
    """
    known = known or {}
    digest = file_digest(test_program)
    begin = time.monotonic()

    def run_one(test):
        if test.exercise in known:
            return known[test.exercise]
        if test_time is not None and time.monotonic() - begin > test_time:
            return Outcome(TIMED_OUT, f"was not begun: the tests before it took {test_time:g} s, which is all that a hand-in gets")
        if file_digest(test_program) != digest:
            return Outcome(NO_VERDICT, "a test before it has changed the test program")
        return explained(run_test(test_program, test.name, limit_of(test), test.memory_limit, scratch, sandboxed), known)

    with contextlib.ExitStack() as stack:
        step = stack.enter_context(Step(title)) if title else None
        pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(jobs or cores()))
        waiting = {pool.submit(run_one, test): test for test in catalog.tests}
        outcomes = {}
        try:
            for finished in concurrent.futures.as_completed(waiting):
                outcomes[waiting[finished].name] = finished.result()
                if step:
                    step.progress(len(outcomes), len(waiting))
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)  # those that run end by their limit; no other one begins
            raise
    return [GradedOutcome(test, outcomes[test.name]) for test in catalog.tests]


def explained(outcome, known):
    """Says when a test met the stub in place of a body that was not taken or did not build."""
    if outcome.state == NOT_IMPLEMENTED:
        for id, why in known.items():
            if f"exercise {id} is not" in outcome.reason:
                outcome.reason = f"needs {id}, which {'was ' if why.state == REFUSED else ''}{why.state}"
    return outcome


def at_most(seconds):
    """Time limits as grading.json gives them, none above `seconds` (when there is such a bound)."""
    return lambda test: min(test.time_limit, seconds) if seconds else test.time_limit


def file_digest(path):
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""
