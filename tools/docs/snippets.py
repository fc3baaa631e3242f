"""The exercises' code, as the lessons show it: the lines between two markers `//! [ex-01.1]`."""

import textwrap
from dataclasses import dataclass

from strip import body, exercises_of_tree, read_source


@dataclass(frozen=True)
class Snippet:
    """A marked piece of code."""

    marker: str
    path: str  # below the tree's top
    line: int  # of its first line, counted from 1
    code: str  # without the markers, indented as little as possible

    @property
    def chapter(self):
        """"01" of ex-01.2."""
        return self.marker[3:5]


def all_snippets(root):
    """Marker -> Snippet of the whole tree.

    @throws CourseError for broken markers
    """
    return {marker: snippet_of(exercise, root) for marker, exercise in exercises_of_tree(root).items()}


def snippet_of(exercise, root):
    code = body(read_source(root / exercise.path), exercise)
    return Snippet(exercise.id, exercise.path, exercise.first + 1, textwrap.dedent(code).rstrip("\n"))
