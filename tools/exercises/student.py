"""A student's tree: how it is made, and what it remembers.

.course/student.json says that a tree is a student's and which chapter it starts with; .course/starter/ holds the files
with exercises as they were, .course/files.json the hash of every file; .course/state.json (not tracked) remembers hints
and the results of checks.
"""

import hashlib
import json
import os
import shutil
import subprocess
import time
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from exercises.building import PRESET
from exercises.trees import source_files, starter_overlay
from strip import exercises_of_tree, read_source

FOLDER = ".course"
STUDENT = f"{FOLDER}/student.json"
STARTER = f"{FOLDER}/starter"
STATE = f"{FOLDER}/state.json"
UNDO = f"{FOLDER}/undo"
ASIDE = f"{FOLDER}/aside"
FILES = f"{FOLDER}/files.json"
UPDATE = f"{FOLDER}/update"  # an update on its way
# Neither is of use to a student: tests of the course's own machinery.
LEFT_OUT = ("tests/course/", ".ci/", ".pre-commit-config.yaml")
MOST_RESULTS = 20  # of a chapter, the newest


def is_student_tree(root=ROOT):
    return (root / STUDENT).exists()


def first_chapter(root=ROOT):
    """Two digits: the first chapter that the student has to write. In the reference, all are there to look at."""
    if not is_student_tree(root):
        return "01"
    try:
        return f"{int(json.loads((root / STUDENT).read_text())['firstChapter']):02}"
    except (ValueError, KeyError, TypeError):
        raise CourseError(f"{STUDENT} is damaged; restore it with git, or start anew with ./course start") from None


def require_student_tree(root=ROOT):
    if not is_student_tree(root):
        raise CourseError("this is the course's own tree, not a student's; make one: ./course start ../student")


def require_whole(root=ROOT):
    """@throws CourseError while a half of an update is done"""
    if (root / UPDATE / "plan.json").exists():
        raise CourseError("an update was interrupted, and a half of the tree is new; ./course update finishes it")


def starter_text(path, root=ROOT):
    """A file with exercises as the student got it."""
    place = root / STARTER / path
    if not place.exists():
        raise CourseError(f"{STARTER}/{path} is missing; restore it with git, or start anew with ./course start")
    return read_source(place)


def starter_exercises(root=ROOT):
    """The exercises that the student has to write, by id: where they stood at the start."""
    require_student_tree(root)
    return exercises_of_tree(root / STARTER)


# Making one.


def make(folder, first, root=ROOT):
    """Writes a student's tree in which chapters from `first` (a number) on are stubs; returns how many exercises wait.

    Mistakes are left out from there on: their context lines are the solution.
    """
    overlay = starter_overlay(root, lambda exercise: int(exercise.chapter) >= first)
    if not overlay:
        raise CourseError(f"chapters from {first:02} on have no exercises yet; choose an earlier one with --chapter")
    given = {}
    for name in source_files(root):
        if name.startswith((*LEFT_OUT, f"{FOLDER}/")) or shows_later_solution(name, first):
            continue
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if name in overlay:
            target.write_bytes(overlay[name])
            shutil.copymode(root / name, target)
        else:
            shutil.copy2(root / name, target)
        given[name] = file_hash(target)
    for name, content in overlay.items():
        place = folder / STARTER / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content)
    (folder / STUDENT).write_text(json.dumps({"firstChapter": first, "course": commit(root)}, indent=2) + "\n")
    (folder / FILES).write_text(json.dumps(given, indent=0, sort_keys=True) + "\n")
    (folder / FOLDER / ".gitignore").write_text("state.json\nundo/\nupdate/\n")
    return len(exercises_of_tree(folder / STARTER))


def given_files(root=ROOT):
    """path -> hash of every file, as the student got it."""
    try:
        return dict(json.loads((root / FILES).read_text()))
    except (OSError, ValueError, TypeError):
        raise CourseError(f"{FILES} is missing or damaged; restore it with git, or start anew with ./course start") from None


def file_hash(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def shows_later_solution(name, first):
    parts = name.split("/")
    return len(parts) > 3 and parts[0] == "tests" and parts[2] in ("mistakes", "alternatives") and int(parts[1][:2]) >= first


def commit(root):
    """The course's commit that the tree was made from; empty without git."""
    if not (root / ".git").exists() or not shutil.which("git"):
        return ""
    asked = subprocess.run(["git", "-C", str(root), "rev-parse", "HEAD"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True)
    return asked.stdout.strip() if asked.returncode == 0 else ""


def make_repository(folder):
    """Puts the tree under git with one commit, unless there is no git or the folder is in a repository already."""
    if not shutil.which("git"):
        return False
    git = ["git", "-C", str(folder)]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "stdin": subprocess.DEVNULL}
    if subprocess.run([*git, "rev-parse", "--is-inside-work-tree"], **quiet).returncode == 0:
        return False
    identity = ["-c", "user.name=Caustic", "-c", "user.email=caustic@localhost", "-c", "commit.gpgsign=false"]
    steps = [["init", "-b", "main"], ["add", "-A"], [*identity, "commit", "-m", "The starter"]]
    return all(subprocess.run([*git, *step], **quiet).returncode == 0 for step in steps)


# Remembering.


def read_state(root=ROOT):
    try:
        state = json.loads((root / STATE).read_text())
        return state if isinstance(state, dict) else {}
    except (OSError, ValueError):
        return {}  # nothing remembered, or damaged: only hints and old results are lost


def write_state(state, root=ROOT):
    path = root / STATE
    path.parent.mkdir(exist_ok=True)
    temporary = path.with_suffix(".tmp")
    temporary.write_text(json.dumps(state, indent=1) + "\n")
    os.replace(temporary, path)


@dataclass
class Results:
    """What a check found: test -> outcome state and reason."""

    tests: dict  # name -> {"state", "reason"}
    error: str  # the compiler's first error
    time: float
    fresh: bool  # whether nothing that matters has changed since

    def passed(self, test):
        return self.tests.get(test.name, {}).get("state") == "passed"


def inputs_key(catalog, root=ROOT):
    """Hash of all that decides a chapter's results: its library, the graded tests and what they are built with."""
    tags = file_tags(root)
    files = [name for name in source_files(root)
             if name.startswith(("common/", "cmake/", "tests/support/", f"tests/{catalog.chapter}/graded_"))
             and tags.get(name, {"chapter": 0})["chapter"] <= int(catalog.number)
             or name in ("CMakeLists.txt", "CMakePresets.json", f"tests/{catalog.chapter}/grading.json")]
    total = hashlib.sha256()
    for name in files:
        total.update(f"{name} {hashlib.sha256((root / name).read_bytes()).hexdigest()}\n".encode())
    return total.hexdigest()


def file_tags(root):
    """path -> the chapter that a file came with, as CMake wrote it at the last check; a later chapter's changes nothing."""
    try:
        return json.loads((root / "build" / PRESET / "declarations.json").read_text())["files"]
    except (OSError, ValueError, KeyError):
        return {}


def remember(grade, root=ROOT):
    state = read_state(root)
    results = state.setdefault("results", {}).setdefault(grade.chapter, {})
    results.pop(key := inputs_key(grade.catalog, root), None)
    results[key] = {
        "time": time.time(),
        "error": grade.error,
        "tests": {o.test.name: {"state": o.outcome.state, "reason": o.outcome.reason} for o in grade.outcomes},
    }
    for old in list(results)[:-MOST_RESULTS]:
        del results[old]
    write_state(state, root)


def remember_pictures(catalog, points, wrong, root=ROOT):
    """What the pictures of a chapter looked like: drawn at so many points, these (names) not as the reference's."""
    state = read_state(root)
    state.setdefault("pictures", {})[catalog.chapter] = {"points": points, "wrong": wrong}
    write_state(state, root)


def recall_pictures(catalog, root=ROOT):
    """{"points", "wrong"}; None when they were never drawn."""
    return read_state(root).get("pictures", {}).get(catalog.chapter)


def recall(catalog, root=ROOT):
    """The results of this very state of the sources; else the newest there are; None when the chapter was never checked."""
    results = read_state(root).get("results", {}).get(catalog.chapter, {})
    if not results:
        return None
    key = inputs_key(catalog, root)
    found = results.get(key) or list(results.values())[-1]
    return Results(found["tests"], found["error"], found["time"], key in results)
