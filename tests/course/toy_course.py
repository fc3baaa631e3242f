"""The toy course of tests/course/toy: two tiny chapters with the real script, build files and test support."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import strip
from exercises import sandbox

HERE = Path(__file__).resolve().parent
REAL = HERE.parent.parent
SHARED = ("course", "tools", "cmake", "CMakePresets.json", "packages.txt", ".gitignore", "common/core", "common/figure",
          *(f"tests/support/{name}" for name in ("test_main.cpp", "verdict.h", "verdict.cpp", "compare_pictures.cpp")))


def make_toy(folder):
    """Writes the toy course into a folder that is not there yet."""
    shutil.copytree(HERE / "toy", folder)
    for name in SHARED:
        source, target = REAL / name, folder / name
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy2(source, target)
    return folder


class ToyCase(unittest.TestCase):
    """Tests of one toy course: cls.toy, in a folder cls.top that goes with them."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.top = Path(folder.name)
        cls.toy = make_toy(cls.top / "toy")


def course(tree, *words):
    """Runs ./course in a tree, with the Python that runs the tests."""
    command = [sys.executable, "-B", str(tree / "tools" / "course.py"), *map(str, words)]
    return subprocess.run(command, cwd=tree, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=900)


def write_body(tree, exercise, body):
    """Puts lines of code between an exercise's markers."""
    found = strip.exercises_of_tree(tree)[exercise]
    path = tree / found.path
    text = "".join(f"{found.indent}{line}\n" for line in body.splitlines())
    strip.write_source(path, strip.with_body(strip.read_source(path), found, text))


def reference_body(reference, exercise):
    found = strip.exercises_of_tree(reference)[exercise]
    lines = strip.lines_of(strip.body(strip.read_source(reference / found.path), found))
    return "".join(line[len(found.indent):] for line in lines)


def solve(tree, reference, *exercises):
    for exercise in exercises:
        write_body(tree, exercise, reference_body(reference, exercise))


def where():
    """The words that grade a submission in the sandbox, or without one where trying shows that there is none."""
    return ("--unsandboxed",) if sandbox.why_not() else ()


def grade(tree, chapter, submission, *words):
    """Grades a submission and returns what --json writes of the chapter."""
    report = tree / "build" / "report.json"
    report.parent.mkdir(exist_ok=True)
    report.unlink(missing_ok=True)
    ended = course(tree, "grade", chapter, "--submission", submission, "--json", report, *where(), *words)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return json.loads(report.read_text())["chapters"][0]


def outcomes(graded):
    """Test name -> what became of it."""
    return {test["name"]: test["outcome"] for test in graded["tests"]}
