"""The code that lessons show: the lines between two markers `//! [ex-01.1]`, an exercise, or `//! [walk]`, any other name."""

import re
import textwrap
from dataclasses import dataclass

from course_lib.errors import CourseError
from strip import MARKER, NEARLY_A_MARKER, SOURCES, body, exercises_of_tree, lines_of, read_source

SHOWN = re.compile(r"^[ \t]*//! \[([a-z][a-z0-9_-]*)\]\s*$")


@dataclass(frozen=True)
class Snippet:
    """A marked piece of code."""

    marker: str
    path: str  # below the tree's top
    line: int  # of its first line, counted from 1
    code: str  # without the markers, indented as little as possible
    chapter: str = ""  # "01" of ex-01.2; empty for code that is no exercise


def all_snippets(root):
    """Marker -> Snippet of the whole tree: exercises, and what lessons show beside them.

    @throws CourseError for broken markers
    """
    found = {marker: snippet_of(exercise, root) for marker, exercise in exercises_of_tree(root).items()}
    for path in sorted(path for top in ("common", "chapters") for path in (root / top).rglob("*")):
        if path.suffix not in SOURCES or not path.is_file():
            continue
        for snippet in shown_code(read_source(path), path.relative_to(root).as_posix()):
            if snippet.marker in found:
                other = found[snippet.marker]
                raise CourseError(f"{snippet.path}:{snippet.line}: {snippet.marker} is marked at {other.path}:{other.line} too")
            found[snippet.marker] = snippet
    return found


def snippet_of(exercise, root):
    code = body(read_source(root / exercise.path), exercise)
    return Snippet(exercise.id, exercise.path, exercise.first + 1, dedented(code), exercise.chapter)


def shown_code(text, path):
    """The marked pieces of a file that are no exercises; exercises may stand within them.

    @throws CourseError for a marker without its partner, or inside another pair
    """
    found = []
    opened = None
    lines = lines_of(text)
    for number, line in enumerate(lines, start=1):
        matched = SHOWN.match(line)
        if not matched or NEARLY_A_MARKER.search(line):
            continue
        if opened is None:
            opened = (matched[1], number)
        elif matched[1] != opened[0]:
            raise CourseError(f"{path}:{number}: {matched[1]} is nested in {opened[0]}; end that one first")
        else:
            code = "".join(one for one in lines[opened[1]:number - 1] if not MARKER.match(one))
            found.append(Snippet(opened[0], path, opened[1] + 1, dedented(code)))
            opened = None
    if opened is not None:
        raise CourseError(f"{path}:{opened[1]}: {opened[0]} has no closing marker; put the same line behind the code")
    return found


def dedented(code):
    return textwrap.dedent(code).rstrip("\n")
