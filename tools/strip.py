"""Finds the exercises in the sources and turns the reference into the starter.

An exercise is the body of a function between two identical marker lines, `//! [ex-01.1]`. Stripping replaces what is
between them by `throw NotImplemented("ex-01.1");` and keeps the markers. By hand:

    python3 tools/strip.py --list            every exercise with its file and line
    python3 tools/strip.py FILE              that file as the starter has it, on standard output
"""

import argparse
import re
import sys
from dataclasses import dataclass
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT

MARKER = re.compile(r"^([ \t]*)//! \[(ex-(\d\d)\.([1-9]\d*))\]\s*$")
NEARLY_A_MARKER = re.compile(r"//!\s*\[?\s*ex\b", re.IGNORECASE)
SOURCES = (".h", ".cpp")


def order_key(exercise):
    """Sorts "ex-01.9" before "ex-01.10"."""
    chapter, number = exercise[len("ex-"):].split(".")
    return int(chapter), int(number)


@dataclass(frozen=True)
class Exercise:
    """Where an exercise stands."""

    id: str  # "ex-01.1"
    path: str  # below the top of the tree
    first: int  # line of the opening marker, counted from 1
    last: int  # line of the closing marker
    indent: str  # white space before the opening marker

    @property
    def chapter(self):
        """Two digits, as in the chapter's name."""
        return self.id[3:5]

    @property
    def place(self):
        return f"{self.path}:{self.first}"


def find_exercises(text, path):
    """The exercises of one file, in the order in which they stand.

    @throws CourseError for a marker without its partner, inside another pair, met before, or not written as it must be
    """
    found = []
    opened = None
    for number, line in enumerate(lines_of(text), start=1):
        matched = MARKER.match(line)
        if not matched:
            if NEARLY_A_MARKER.search(line):
                raise CourseError(f"{path}:{number}: a marker is a line of its own that reads '//! [ex-01.1]'")
            continue
        indent, exercise = matched[1], matched[2]
        if opened is None:
            if any(other.id == exercise for other in found):
                raise CourseError(f"{path}:{number}: {exercise} is marked twice; an exercise has one pair of markers")
            opened = Exercise(exercise, path, number, 0, indent)
        elif exercise != opened.id:
            raise CourseError(f"{path}:{number}: {exercise} is nested in {opened.id}; end that one first")
        else:
            found.append(Exercise(exercise, path, opened.first, number, opened.indent))
            opened = None
    if opened is not None:
        raise CourseError(f"{path}:{opened.first}: {opened.id} has no closing marker; put the same line behind the body")
    return found


def exercises_of_tree(root=ROOT):
    """All exercises of a tree by id, in the course's order.

    @throws CourseError for broken markers, and for an exercise that is marked in two files
    """
    found = {}
    for path in sorted((root / "common").rglob("*")):
        if path.suffix not in SOURCES or not path.is_file():
            continue
        name = path.relative_to(root).as_posix()
        for exercise in find_exercises(read_source(path), name):
            if exercise.id in found:
                raise CourseError(f"{exercise.place}: {exercise.id} is marked at {found[exercise.id].place} too; "
                                  "an exercise has one pair of markers")
            found[exercise.id] = exercise
    return {id: found[id] for id in sorted(found, key=order_key)}


def lines_of(text):
    """Lines with their ends; unlike splitlines, only a newline ends one, as for the compiler."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)


def read_source(path):
    # Line ends stay as they are; a byte that is no UTF-8 comes back as it was.
    return path.read_bytes().decode("utf-8", "surrogateescape")


def write_source(path, text):
    path.write_bytes(text.encode("utf-8", "surrogateescape"))


def body(text, exercise):
    """What stands between the markers."""
    return "".join(lines_of(text)[exercise.first:exercise.last - 1])


def with_body(text, exercise, new_body):
    """The text with something else between the exercise's markers."""
    lines = lines_of(text)
    return "".join(lines[:exercise.first]) + new_body + "".join(lines[exercise.last - 1:])


def stub(exercise):
    return f'{exercise.indent}throw NotImplemented("{exercise.id}");\n'


def strip(text, path, chosen=lambda exercise: True):
    """The text with the bodies of the chosen exercises replaced by stubs."""
    for exercise in reversed(find_exercises(text, path)):
        if chosen(exercise):
            text = with_body(text, exercise, stub(exercise))
    return text


def main(arguments):
    parser = argparse.ArgumentParser(prog="tools/strip.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true", help="list all exercises with file and line")
    parser.add_argument("files", nargs="*", metavar="FILE", type=Path, help="print this file as the starter has it")
    args = parser.parse_args(arguments)
    if not args.list and not args.files:
        parser.error("name a file, or ask for --list")
    try:
        if args.list:
            for exercise in exercises_of_tree().values():
                print(f"{exercise.id:<9} {exercise.place}")
        for path in args.files:
            if not path.is_file():
                raise CourseError(f"there is no file {path}")
            sys.stdout.write(strip(read_source(path), str(path)))
    except CourseError as error:
        sys.exit(f"strip.py: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
