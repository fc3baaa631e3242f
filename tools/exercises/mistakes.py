"""Patches against the reference: mistakes that students make, each of which must be caught by the test that it names, and
alternatives, right bodies that work another way, each of which must get full points.
"""

import os
import re
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from exercises.building import build_tree, program
from exercises.grading import run_tests
from strip import exercises_of_tree, read_source, strip

HEADER = re.compile(r"^(exercise|caught-by|mistake|alternative):\s*(\S.*?)\s*$", re.MULTILINE)
TARGETS = re.compile(r"^\+\+\+ b/(\S+)", re.MULTILINE)
FEWEST_MISTAKES = 6
FEWEST_EXERCISES = 4
SHORTEST_LIMIT = 2  # seconds; a mutant's test gets this, or five times what the reference takes
SLOWER = 5


@dataclass(frozen=True)
class Mistake:
    slug: str
    exercise: str
    caught_by: str
    sentence: str
    overlay: dict  # path -> bytes: the reference's files with the mistake in them


@dataclass(frozen=True)
class Alternative:
    slug: str
    exercise: str
    sentence: str
    overlay: dict  # path -> bytes: the reference's files with the other body in them


@dataclass
class AlternativeResult:
    alternative: Alternative
    failed: list  # names of the graded tests that don't pass
    error: str = ""  # why it could not be tried

    @property
    def complaint(self):
        if self.error:
            return self.error
        return f"is right, and {self.failed[0]} fails" if self.failed else ""


@dataclass
class MistakeResult:
    mistake: Mistake
    caught: list  # names of the graded tests that don't pass
    error: str = ""  # why it could not be tried: it does not compile, or with warnings

    @property
    def complaint(self):
        """What is wrong with the mistake, or with the tests; empty when all is well."""
        if self.error:
            return self.error
        if self.mistake.caught_by not in self.caught:
            others = f"; {', '.join(self.caught)} would" if self.caught else ""
            return f"{self.mistake.caught_by} does not catch it{others}"
        return ""


def mistakes_folder(chapter, root=ROOT):
    return root / "tests" / chapter / "mistakes"


def read_mistakes(catalog, root=ROOT):
    """@throws CourseError for a patch that is not as docs/grading.md says"""
    exercises = exercises_of_tree(root)
    return [read_mistake(path, catalog, exercises, root)
            for path in sorted(mistakes_folder(catalog.chapter, root).glob("*.patch"))]


def read_mistake(path, catalog, exercises, root):
    header, overlay = read_patch(path, ("exercise", "caught-by", "mistake"), catalog, exercises, root)
    if header["caught-by"] not in [test.name for test in catalog.tests]:
        raise CourseError(f"{path.relative_to(root).as_posix()}: grading.json lists no test {header['caught-by']}")
    return Mistake(path.stem, header["exercise"], header["caught-by"], header["mistake"], overlay)


def read_alternatives(catalog, root=ROOT):
    """@throws CourseError for a patch that is not as docs/grading.md says"""
    exercises = exercises_of_tree(root)
    found = []
    for path in sorted((root / "tests" / catalog.chapter / "alternatives").glob("*.patch")):
        header, overlay = read_patch(path, ("exercise", "alternative"), catalog, exercises, root)
        found.append(Alternative(path.stem, header["exercise"], header["alternative"], overlay))
    return found


def read_patch(path, keys, catalog, exercises, root):
    """(header, files with the patch in them): a patch of one exercise's body, with a line for each key above the diff."""
    place = path.relative_to(root).as_posix()
    text = path.read_text(encoding="utf-8")
    header = patch_head(text)
    for key in keys:
        if key not in header:
            raise CourseError(f"{place}: there is no line '{key}: ...' above the diff; docs/grading.md shows one")
    if header["exercise"] not in catalog.exercises or header["exercise"] not in exercises:
        raise CourseError(f"{place}: {header['exercise']} is no exercise of {catalog.chapter}")
    exercise = exercises[header["exercise"]]
    if TARGETS.findall(text) != [exercise.path]:
        raise CourseError(f"{place}: a patch of {exercise.id} changes {exercise.path} and nothing else")
    reference = read_source(root / exercise.path)
    mutant = patched(path, exercise.path, reference, place)
    if mutant == reference:
        raise CourseError(f"{place}: changes nothing")
    if strip(mutant, exercise.path, lambda e: e.id == exercise.id) != strip(reference, exercise.path,
                                                                           lambda e: e.id == exercise.id):
        raise CourseError(f"{place}: changes more than the body of {exercise.id}")
    return header, {exercise.path: mutant.encode("utf-8", "surrogateescape")}


def patch_head(text):
    """What stands above a patch's diff: "exercise", "caught-by" and so on."""
    return dict(HEADER.findall(text.split("\n--- ")[0]))


def patched(patch, path, text, place):
    """The text of the file at `path` after the patch."""
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / path
        target.parent.mkdir(parents=True)
        target.write_bytes(text.encode("utf-8", "surrogateescape"))
        # In no repository, whatever the temporary folder lies in: inside one, git would take the paths from its top.
        outside = {**os.environ, "GIT_CEILING_DIRECTORIES": str(Path(folder).resolve().parent)}
        try:
            applied = subprocess.run(["git", "apply", "-p1", str(patch.resolve())], cwd=folder, env=outside,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        except FileNotFoundError:
            raise CourseError("mistakes are applied with git, and there is no git; install it") from None
        if applied.returncode != 0:
            reason = applied.stdout.strip().splitlines()[0] if applied.stdout.strip() else "git says no more"
            raise CourseError(f"{place}: does not apply to the reference ({reason}); make it anew with git diff")
        return read_source(target)


class MutantTree:
    """One tree with one build, into which one mistake after the other is put."""

    def __init__(self, tree, catalog, scratch):
        self._tree = tree
        self._catalog = catalog
        self._scratch = scratch
        self._limits = {}

    def try_reference(self):
        """Builds the reference and runs its tests: all must pass, and they tell how long a test takes."""
        built = build_tree(self._tree, [self._catalog.target], self._catalog.chapter)
        if built.error:
            raise CourseError(f"the reference of {self._catalog.chapter} does not build: {built.error}")
        outcomes = run_tests(self._catalog, program(self._tree, self._catalog.target), self._scratch)
        for o in outcomes:
            if not o.outcome.passed:
                raise CourseError(f"{o.test.name} does not pass on the reference: {o.outcome.state}, {o.outcome.reason}")
            self._limits[o.test.name] = min(o.test.time_limit, max(SHORTEST_LIMIT, SLOWER * o.outcome.seconds))

    def try_mistake(self, mistake):
        return MistakeResult(mistake, *self._try(mistake.overlay, lambda test: self._limits[test.name]))

    def try_alternative(self, alternative):
        # Another algorithm may take longer, as long as a student's may.
        return AlternativeResult(alternative, *self._try(alternative.overlay, lambda test: test.time_limit))

    def _try(self, overlay, time_limit):
        """(names of the tests that don't pass, why it could not be tried)"""
        before = {path: (self._tree / path).read_bytes() for path in overlay}
        try:
            self._write(overlay)
            built = build_tree(self._tree, [self._catalog.target], "")
            if built.error:
                return [], f"does not compile: {built.error}"
            if built.warnings:
                return [], f"compiles with a warning: {built.warnings[0]}"
            outcomes = run_tests(self._catalog, program(self._tree, self._catalog.target), self._scratch, time_limit)
            return [o.test.name for o in outcomes if not o.outcome.passed], ""
        finally:
            self._write(before)

    def _write(self, contents):
        for path, content in contents.items():
            (self._tree / path).write_bytes(content)


def complaints(catalog, results):
    """Everything that is wrong with a chapter's mistakes and tests, one line each."""
    found = [f"{result.mistake.slug}: {result.complaint}" for result in results if result.complaint]
    if len(results) < FEWEST_MISTAKES:
        found.append(f"{catalog.chapter} has {len(results)} mistakes; write at least {FEWEST_MISTAKES}")
    exercises = {result.mistake.exercise for result in results}
    if len(exercises) < FEWEST_EXERCISES:
        found.append(f"the mistakes of {catalog.chapter} lie in {len(exercises)} exercises; spread them over at least "
                     f"{FEWEST_EXERCISES}")
    for name in dispensable_tests(catalog, results):
        found.append(f"{name} can be deleted and every mistake is still caught; write a mistake that only it catches, or merge it")
    return found


def dispensable_tests(catalog, results):
    """Graded tests without which all mistakes are caught as well."""
    alone = {result.caught[0] for result in results if len(result.caught) == 1}
    return [test.name for test in catalog.tests if test.name not in alone]
