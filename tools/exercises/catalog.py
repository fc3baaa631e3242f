"""A chapter's exercises and graded tests, as tests/NN_name/grading.json lists them."""

import json
import re
from dataclasses import dataclass, field

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from strip import order_key

DEFAULT_TIME_LIMIT = 10  # seconds
DEFAULT_MEMORY_LIMIT = 4096  # MiB of address space
TOTAL_POINTS = 100
TEST_NAME = re.compile(r"[A-Za-z]\w*(/\w+)?\.[A-Za-z]\w*(/\w+)?")


@dataclass(frozen=True)
class ExerciseText:
    """What a student is told of an exercise."""

    id: str
    title: str
    minutes: int
    hints: tuple


@dataclass(frozen=True)
class GradedTest:
    name: str  # "Suite.Test"
    exercise: str  # "ex-01.1"
    points: int
    look_at: str
    time_limit: float = DEFAULT_TIME_LIMIT  # seconds
    memory_limit: int = DEFAULT_MEMORY_LIMIT  # MiB
    hidden: bool = False  # an instructor's own, which no student sees


@dataclass(frozen=True)
class Catalog:
    chapter: str  # "01_bezier_curves"
    exercises: dict  # id -> ExerciseText, in the course's order
    tests: tuple  # of GradedTest, in the order in which a student meets them
    files: dict = field(default_factory=dict)  # path -> bytes: sources of hidden tests, beside the tree's own

    @property
    def number(self):
        return self.chapter[:2]

    @property
    def target(self):
        """The test program."""
        return f"graded_{self.number}"

    @property
    def points(self):
        return sum(test.points for test in self.tests)

    def tests_of(self, exercise):
        return [test for test in self.tests if test.exercise == exercise]


def catalog_path(chapter, root=ROOT):
    return root / "tests" / chapter / "grading.json"


def read_catalog(chapter, root=ROOT):
    """@throws CourseError when the file is missing, is no JSON, or does not say what it must"""
    path = catalog_path(chapter, root)
    place = path.relative_to(root).as_posix()
    if not path.exists():
        raise CourseError(f"{place} is missing: chapter {chapter} has no graded tests yet")
    try:
        return parse_catalog(json.loads(path.read_text(encoding="utf-8")), chapter)
    except ValueError as error:
        raise CourseError(f"{place}: {error}; docs/grading.md says what it must hold") from None


def parse_catalog(data, chapter):
    """@throws ValueError saying what is wrong with the data"""
    expect(isinstance(data, dict), "it must be an object")
    expect(data.get("chapter") == chapter, f"'chapter' must be '{chapter}'")
    expect(isinstance(data.get("exercises"), dict), "'exercises' must be an object")
    expect(isinstance(data.get("tests"), list), "'tests' must be a list")
    exercises = {id: parse_exercise(id, data["exercises"][id], chapter) for id in data["exercises"]}
    tests = tuple(parse_test(test, exercises) for test in data["tests"])
    check_unique(tests)
    for id in exercises:
        expect(any(test.exercise == id for test in tests), f"exercise {id} has no test")
    total = sum(test.points for test in tests)
    expect(total == TOTAL_POINTS, f"the points of all tests sum to {total}, not to {TOTAL_POINTS}")
    return Catalog(chapter, {id: exercises[id] for id in sorted(exercises, key=order_key)}, tests)


def check_unique(tests):
    """@throws ValueError when two have one name"""
    names = [test.name for test in tests]
    for name in names:
        expect(names.count(name) == 1, f"test {name} is listed twice")


def parse_exercise(id, data, chapter):
    expect(re.fullmatch(rf"ex-{chapter[:2]}\.[1-9]\d*", id), f"exercise '{id}' must be called ex-{chapter[:2]}.1 and so on")
    expect(isinstance(data, dict), f"exercise {id} must be an object")
    title, minutes, hints = data.get("title"), data.get("minutes"), data.get("hints")
    expect(is_text(title), f"'title' of {id} must be text")
    expect(is_count(minutes), f"'minutes' of {id} must be a whole number from 1 on")
    expect(isinstance(hints, list) and hints and all(map(is_text, hints)), f"'hints' of {id} must be a list of texts")
    return ExerciseText(id, title, minutes, tuple(hints))


def parse_test(data, exercises):
    expect(isinstance(data, dict), "a test must be an object")
    name = data.get("name")
    expect(isinstance(name, str) and TEST_NAME.fullmatch(name), f"'name' of a test must read Suite.Test, not '{name}'")
    expect(data.get("exercise") in exercises, f"'exercise' of {name} must be one of those above")
    expect(is_count(data.get("points")), f"'points' of {name} must be a whole number from 1 on")
    expect(is_text(data.get("lookAt")), f"'lookAt' of {name} must be text")
    time_limit = data.get("timeLimit", DEFAULT_TIME_LIMIT)
    memory_limit = data.get("memoryLimit", DEFAULT_MEMORY_LIMIT)
    expect(isinstance(time_limit, (int, float)) and time_limit > 0, f"'timeLimit' of {name} must be a number above 0")
    expect(is_count(memory_limit), f"'memoryLimit' of {name} must be a whole number from 1 on")
    return GradedTest(name, data["exercise"], data["points"], data["lookAt"], time_limit, memory_limit)


def is_text(value):
    return isinstance(value, str) and bool(value.strip())


def is_count(value):
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


def expect(holds, complaint):
    if not holds:
        raise ValueError(complaint)
