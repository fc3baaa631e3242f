"""What an update of the course changes in a student's tree, found out before anything is changed.

Bodies between markers are the student's, all else is the course's. A file is compared three ways: as the student got it, as it
is, and as it is in the course now. Where both sides changed something that is no body, or a body lost its place, the
student's goes aside under a name that is told.
"""

import re
from dataclasses import dataclass, field
from pathlib import PurePosixPath

from course_lib.errors import CourseError
from exercises import student
from exercises.bodies import Unreadable, tokens
from exercises.splicing import decoded, encoded
from strip import body, find_exercises, lines_of, order_key, strip, stub, with_body

# Where a function's head ends, looked at from below: what stands before it is none of it.
BEFORE_A_HEAD = re.compile(r"^\s*$|^\s*(#|//)|[;}:]\s*$|^\s*[}]")


@dataclass
class Written:
    """A body that a student wrote."""

    text: str
    head: str  # the words of its function's head
    head_text: str  # that head as it stands above the body
    path: str
    line: int


@dataclass
class Given:
    """A file as the student got it."""

    text: str  # None when it had no exercises to write
    hash: str  # None when there was no such file


@dataclass
class Plan:
    """What an update does. All of it is known before it begins."""

    write: dict = field(default_factory=dict)  # path -> bytes; None for the file as it is in the course
    remove: list = field(default_factory=list)
    aside: dict = field(default_factory=dict)  # name -> (bytes, why)
    added: list = field(default_factory=list)  # paths of `write` that the student did not have
    kept: list = field(default_factory=list)  # exercises whose bodies stay in files that change
    new: list = field(default_factory=list)  # exercises that the student did not have
    is_remembered_otherwise: bool = False  # whether .course/ is to hold something else

    @property
    def is_something(self):
        return bool(self.write or self.remove or self.aside)


def planned(root, new):
    """The update of a student's tree.

    @param new  a student's tree of the course as it is now, of the same first chapter
    """
    plan = Plan()
    before, after = student.given_files(root), student.given_files(new)
    old_starter, new_starter = starter_texts(root), starter_texts(new)
    written = written_bodies(root, old_starter)
    taken = set()
    for path in sorted({*before, *after}):
        if path in old_starter or path in new_starter:
            given = Given(old_starter.get(path), before.get(path))
            taken |= plan_exercises(plan, root, path, given, new_starter.get(path), path in after, written)
        else:
            plan_file(plan, root, path, before.get(path), after.get(path))
    put_aside(plan, written, taken, new_starter)
    had = exercises_of(old_starter)
    plan.is_remembered_otherwise = (before, old_starter) != (after, new_starter)
    plan.new = [id for id in exercises_of(new_starter) if id not in had]
    return plan


def plan_file(plan, root, path, before, after):
    """A file without exercises."""
    mine = student.file_hash(root / path) if (root / path).is_file() else None
    if mine == after or before == after:
        return  # it is as new as that, or changed by the student alone
    if mine is not None and mine != before:
        plan.aside[path] = ((root / path).read_bytes(), "changed by you and by the course" if after else
                            "changed by you, and the course has it no more")
    if after is None:
        plan.remove += [path] if mine is not None else []
        return
    plan.write[path] = None
    plan.added += [path] if mine is None else []


def plan_exercises(plan, root, path, given, new, is_there, written):
    """A file with exercises, before or now; returns the exercises whose bodies stay.

    @param new  its text as it is given out now, None when it has no exercises any more
    @param is_there  whether the course has the file now
    """
    text = decoded((root / path).read_bytes()) if (root / path).is_file() else None
    outside = None if text is None else without_bodies(text, path)
    if text is not None and given.text == new and outside != new:
        return {id for id in written if written[id].path == path}  # changed outside of bodies, by the student alone
    staying = {e.id for e in find_exercises(new or "", path) if e.id in written and written[e.id].head == head(new, e)}
    if text is not None and outside not in (given.text, new) and student.file_hash(root / path) != given.hash:
        plan.aside[path] = ((root / path).read_bytes(), "changed by you and by the course outside of bodies")
    if new is None:
        if is_there:
            plan.write[path] = None
        elif text is not None:
            plan.remove.append(path)
        return staying
    result = with_bodies(new, path, written, staying)
    if text != result:
        plan.write[path] = encoded(result)
        plan.added += [path] if text is None else []
        plan.kept += sorted(staying, key=order_key)
    return staying


def put_aside(plan, written, taken, new_starter):
    """The bodies that have no place any more."""
    known = exercises_of(new_starter)
    for id, mine in written.items():
        if id in taken:
            continue
        why = "its function has changed" if id in known else "it is no exercise any more"
        text = f"// {id}, as you had it at {mine.path}:{mine.line}: {why}.\n{mine.head_text}{mine.text}"
        plan.aside[id + PurePosixPath(mine.path).suffix] = (encoded(text), why)


def starter_texts(root):
    top = root / student.STARTER
    paths = sorted(path.relative_to(top).as_posix() for path in top.rglob("*") if path.is_file())
    return {path: student.starter_text(path, root) for path in paths}


def exercises_of(texts):
    """Ids of all exercises in files."""
    return [exercise.id for path, text in texts.items() for exercise in find_exercises(text, path)]


def written_bodies(root, starter):
    """id -> what the student wrote, stubs aside. Of a file with broken markers nothing is known."""
    found = {}
    for path in starter:
        if not (root / path).is_file():
            continue
        text = decoded((root / path).read_bytes())
        try:
            exercises = find_exercises(text, path)
        except CourseError:
            continue
        for exercise in exercises:
            mine = body(text, exercise)
            if mine.strip() not in ("", stub(exercise).strip()):
                above = "".join(head_lines(text, exercise))
                found[exercise.id] = Written(mine, head(text, exercise), above, path, exercise.first)
    return found


def without_bodies(text, path):
    """The text with stubs for all bodies; empty when its markers are broken."""
    try:
        return strip(text, path)
    except CourseError:
        return ""


def with_bodies(text, path, written, staying):
    for exercise in reversed(find_exercises(text, path)):
        if exercise.id in staying:
            mine = written[exercise.id].text
            text = with_body(text, exercise, mine if mine.endswith("\n") else mine + "\n")
    return text


def head_lines(text, exercise):
    """The lines of the function's head above an exercise, from its return type to its brace."""
    lines = lines_of(text)
    start = exercise.first - 2
    while start > 0 and (not lines[start].strip() or indent_of(lines[start]) >= len(exercise.indent)):
        start -= 1
    while start > 0 and not BEFORE_A_HEAD.search(lines[start - 1]):
        start -= 1
    end = start
    while end < exercise.first - 2 and not lines[end].rstrip().endswith("{"):
        end += 1
    return lines[start:end + 1]


def indent_of(line):
    return len(line) - len(line.lstrip())


def head(text, exercise):
    """What the body can count on: the words of its function's head, comments and white space aside."""
    lines = "".join(head_lines(text, exercise))
    try:
        return " ".join(token.text for token in tokens(lines))
    except Unreadable:
        return " ".join(lines.split())
