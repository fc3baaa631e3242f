"""Puts an exercise back to its stub. What you had is kept in .course/undo/."""

import time

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import say
from exercises import loop, student
from strip import body, find_exercises, read_source, stub, with_body, write_source

HELP = "put an exercise back to its stub"


def add_arguments(parser):
    parser.add_argument("exercise", metavar="EX", help="such as ex-01.3 (or 1.3)")
    parser.add_argument("--whole-file", action="store_true",
                        help="put back the whole file with all its exercises, as when its markers are broken")


def run(args):
    student.require_student_tree()
    _, id = loop.find_exercise(args.exercise)
    path = student.starter_exercises()[id].path
    text = read_source(ROOT / path) if (ROOT / path).exists() else ""
    if args.whole_file:
        new_text, old = student.starter_text(path), text
    else:
        new_text, old = reset_one(text, path, id)
    if new_text == text:
        say(f"{id} is as it was at the start already")
        return 0
    kept = keep(old, id, path)
    write_source(ROOT / path, new_text)
    say(f"{path if args.whole_file else id} is as it was at the start; what you had is in {kept}")
    return 0


def reset_one(text, path, id):
    """The text with the exercise's stub, and the body that it replaces."""
    try:
        exercise = next((e for e in find_exercises(text, path) if e.id == id), None)
    except CourseError as error:
        raise CourseError(f"{error}, or put the file back: ./course reset {id} --whole-file") from None
    if exercise is None:
        raise CourseError(f"{path}: the markers of {id} are gone; put the file back: ./course reset {id} --whole-file")
    return with_body(text, exercise, stub(exercise)), body(text, exercise)


def keep(text, id, path):
    folder = ROOT / student.UNDO
    folder.mkdir(parents=True, exist_ok=True)
    name = f"{id}-{time.strftime('%Y%m%d-%H%M%S')}{path[path.rindex('.'):]}"
    write_source(folder / name, text)
    return f"{student.UNDO}/{name}"
