"""Puts somebody else's bodies into our own files: the one way by which check, submit and grade come to what counts.

Only bodies between markers are taken. Whatever else a file holds is ours; where theirs differs, that is said.
"""

import codecs
from dataclasses import dataclass, field

from course_lib.errors import CourseError
from exercises.bodies import Unreadable, complaint_about, tokens, worth_a_look
from strip import body, find_exercises, lines_of, stub, with_body


@dataclass
class Spliced:
    """Files of ours with the bodies that count."""

    texts: dict = field(default_factory=dict)  # path -> text
    refused: dict = field(default_factory=dict)  # exercise -> why its body is not taken
    notes: list = field(default_factory=list)  # what is missing, and what does not count
    looks: list = field(default_factory=list)  # what a person should look at

    @property
    def overlay(self):
        """path -> bytes"""
        return {path: encoded(text) for path, text in self.texts.items()}

    def add(self, path, starter, theirs):
        """Takes the bodies of one file.

        @param starter  our text of the file, with stubs
        @param theirs  the bytes that were handed in; None when there is no such file
        """
        self.texts[path] = starter
        if theirs is None:
            self.notes.append(f"{path} is missing; its exercises count as not done")
            return
        text = decoded(theirs)
        try:
            found = {exercise.id: exercise for exercise in find_exercises(text, path)}
        except CourseError as error:
            self.notes.append(f"{error}; its exercises count as not done")
            return
        ours = find_exercises(starter, path)
        for exercise in reversed(ours):
            if exercise.id in found:
                self._take(exercise, body(text, found[exercise.id]), found[exercise.id])
            else:
                self.notes.append(f"{path}: the markers of {exercise.id} are missing; it counts as not done")
        line = first_change_outside(starter, text, path)
        if line and len(found) == len(ours):
            self.notes.append(f"{path}:{line}: changed outside of an exercise's body, which does not count")

    def _take(self, exercise, new_body, place):
        if new_body and not new_body.endswith("\n"):
            new_body += "\n"
        complaint = complaint_about(new_body)
        if complaint:
            self.refused[exercise.id] = f"{place.path}:{place.first + complaint.line}: {complaint.reason}"
            return
        if words := worth_a_look(new_body):
            self.looks.append(f"{place.place}: {exercise.id} has {', '.join(words)}: a person should look at it")
        self.texts[exercise.path] = with_body(self.texts[exercise.path], exercise, new_body)


def decoded(content):
    """A source as text: as UTF-8, or as UTF-16 when it says so; lines end with a newline, whatever the editor wrote.

    A byte that is no UTF-8 comes back as it was.
    """
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        text = content.decode("utf-16", "replace")
    else:
        text = content.removeprefix(codecs.BOM_UTF8).decode("utf-8", "surrogateescape")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def encoded(text):
    return text.encode("utf-8", "surrogateescape")


def without_bodies(text, path):
    """The text with the lines of all bodies empty."""
    lines = lines_of(text)
    for exercise in find_exercises(text, path):
        lines[exercise.first:exercise.last - 1] = ["\n"] * (exercise.last - 1 - exercise.first)
    return "".join(lines)


def first_change_outside(starter, text, path):
    """The line of `text` where something but bodies, comments and white space differs from the starter; 0 without any."""
    try:
        ours, theirs = (tokens(without_bodies(source, path)) for source in (starter, text))
    except Unreadable as error:
        return error.complaint.line
    for before, after in zip(ours, theirs):
        if before.text != after.text:
            return after.line
    if len(ours) == len(theirs):
        return 0
    return theirs[len(ours)].line if len(theirs) > len(ours) else len(lines_of(text))


def without_exercise(text, path, exercise):
    """The text with an exercise's body as a stub, and all lines where they were."""
    found = next(e for e in find_exercises(text, path) if e.id == exercise)
    return with_body(text, found, stub(found) + "\n" * (found.last - found.first - 2))
