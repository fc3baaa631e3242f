"""Asks ctest which tests there are, and runs some of them. A selection is a regular expression for a test's label."""

import json
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from course_lib.errors import CourseError
from course_lib.paths import build_dir, cores
from course_lib.process import run

UNITTEST_COUNT = re.compile(r"^Ran (\d+) tests? in", re.MULTILINE)


def of_kind(*kinds):
    """Selects the C++ tests of these kinds, of all chapters: their labels are NN.kind."""
    return rf"^[0-9]+\.({'|'.join(kinds)})$"


def of_chapters(numbers, *kinds):
    """Selects the C++ tests of these kinds of some chapters ("01", "02")."""
    return rf"^({'|'.join(numbers)})\.({'|'.join(kinds)})$"


def of_label(label):
    return f"^{label}$"


@dataclass(frozen=True)
class Entry:
    """A test as ctest lists it. A check is what is remembered as one: all tests of a program, or a file of Python tests."""

    name: str
    labels: tuple
    command: tuple

    @property
    def check(self):
        return self.name if "course" in self.labels else self.labels[0] if self.labels else self.name


@dataclass
class Outcome:
    """What running a selection gave."""

    passed: int = 0
    failed: list = field(default_factory=list)  # (name, output)
    seconds: float = 0
    counts: dict = field(default_factory=dict)  # name -> how many tests an entry that passed ran


def all_test_names(preset):
    """The names of all tests, labelled or not; test programs are asked for theirs, so they must be built."""
    return [entry.name for entry in entries(preset)]


def test_names(preset, selection):
    return [entry.name for entry in entries(preset, selection)]


def entries(preset, selection=None):
    """What ctest has of a selection, or all of it."""
    command = ["ctest", "--test-dir", str(build_dir(preset)), "--show-only=json-v1"]
    command += ["-L", selection] if selection else []
    finished = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if finished.returncode != 0:
        raise CourseError(f"ctest cannot list the tests of preset {preset}: {finished.stderr.strip()}")
    return [entry_of(test) for test in json.loads(finished.stdout)["tests"]]


def entry_of(test):
    properties = {each["name"]: each["value"] for each in test.get("properties", [])}
    return Entry(test["name"], tuple(properties.get("LABELS", [])), tuple(test.get("command", [])))


def by_check(preset, selection):
    """What ctest has of a selection, by check: name -> entries."""
    checks = {}
    for entry in entries(preset, selection):
        checks.setdefault(entry.check, []).append(entry)
    return checks


def run_tests(preset, selection, title, checks=None):
    """Runs a selection, or only these checks of it, on all cores. Selecting nothing is an error."""
    report = build_dir(preset) / "junit.xml"
    report.unlink(missing_ok=True)
    command = ["ctest", "--test-dir", build_dir(preset), "-j", cores(), "--no-tests=error", "--output-junit", report,
               "--test-output-size-failed", "1000000", "-L", selection]
    if checks is not None:
        by_name = all(len(entries) == 1 and entries[0].name == check for check, entries in checks.items())
        command += ["-R" if by_name else "-L", f"^({'|'.join(map(re.escape, checks))})$"]
    finished = run(command, title)
    if not report.exists():
        raise CourseError(f"{title}: ctest ran nothing: {finished.output.strip().splitlines()[-1]}")
    outcome = read_report(report)
    outcome.seconds = finished.seconds
    if finished.code != 0 and not outcome.failed:
        raise CourseError(f"{title}: ctest failed: {finished.output.strip().splitlines()[-1]}")
    return outcome


def read_report(path):
    """Counts a JUnit report of ctest. A file of Python tests counts as many as it ran."""
    outcome = Outcome()
    for case in ElementTree.parse(path).getroot().iter("testcase"):
        output = case.findtext("system-out") or ""
        if case.get("status") == "run":
            outcome.counts[case.get("name")] = tests_within(output)
            outcome.passed += tests_within(output)
        else:
            outcome.failed.append((case.get("name"), output))
    return outcome


def tests_within(output):
    counted = UNITTEST_COUNT.search(output)
    return int(counted[1]) if counted else 1
