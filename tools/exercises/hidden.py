"""Hidden tests: an instructor's own, in a folder that students don't get, graded beside the public ones.

The folder has a folder a chapter, named like it, with grading.json (its `chapter`, and `tests` as in the public one) and the
sources that hold these tests. They are built into the chapter's test program.
"""

import dataclasses
import json
import re
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from exercises.catalog import check_unique, parse_test

PREFIX = "graded_hidden_"  # CMake builds graded_*.cpp
TEST = re.compile(r"^\s*TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.MULTILINE)
DATA = "grading.json"


def with_hidden(catalog, folder, root=ROOT):
    """A chapter's catalog with its hidden tests and their files; the chapter's own where the folder has none for it.

    @throws CourseError when what the folder holds is not as it must be
    """
    top = Path(folder)
    if not top.is_dir():
        raise CourseError(f"there is no folder {folder}; --hidden names one that holds NN_name/{DATA} and tests")
    place = top / catalog.chapter
    if not place.is_dir():
        return catalog
    tests = read_tests(catalog, place / DATA)
    files = read_files(catalog, place, root)
    written = {f"{suite}.{name}" for text in files.values() for suite, name in TEST.findall(text.decode("utf-8", "replace"))}
    for test in tests:
        if "/" not in test.name and test.name not in written:
            raise CourseError(f"{place / DATA}: no source beside it has a test {test.name}")
    for name in sorted(written - {test.name for test in tests}):
        raise CourseError(f"{place / DATA}: it does not list {name}, which a source beside it has")
    return dataclasses.replace(catalog, tests=(*catalog.tests, *tests), files=files)


def read_tests(catalog, path):
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(data, dict) or data.get("chapter") != catalog.chapter or not data.get("tests"):
            raise ValueError(f"it must be an object with 'chapter': '{catalog.chapter}' and a list 'tests'")
        tests = tuple(dataclasses.replace(parse_test(test, catalog.exercises), hidden=True) for test in data["tests"])
        check_unique([*catalog.tests, *tests])
        return tests
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}; it lists the hidden tests of the chapter") from None
    except (ValueError, TypeError) as error:
        raise CourseError(f"{path}: {error}; docs/grading.md says what it must hold") from None


def read_files(catalog, place, root):
    """Path in the tree -> bytes: the sources under names that CMake takes for graded tests, all else under its own."""
    files = {}
    for path in sorted(place.iterdir()):
        if path.name == DATA or path.name.startswith(".") or not path.is_file():
            continue
        name = f"tests/{catalog.chapter}/{PREFIX if path.suffix == '.cpp' else ''}{path.name}"
        if (root / name).exists():
            raise CourseError(f"{path}: the course has a {name} itself; call it something else")
        files[name] = path.read_bytes()
    return files


def is_hidden(said):
    """Whether the compiler speaks of a hidden test first."""
    return f"/{PREFIX}" in said
