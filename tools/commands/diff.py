"""Shows what you have changed in a chapter's exercise files since the start."""

import difflib

from course_lib.chapters import choose_chapters
from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import say
from exercises import student
from strip import lines_of, read_source

HELP = "what you have changed in a chapter"


def add_arguments(parser):
    parser.add_argument("chapter", metavar="NN", help="chapter, by number or name")


def run(args):
    chapter = choose_chapters([args.chapter])[0]
    paths = sorted({e.path for e in student.starter_exercises().values() if e.chapter == chapter[:2]})
    if not paths:
        raise CourseError(f"chapter {chapter} was solved when this tree was made, so there is nothing of yours in it")
    changes = [line for path in paths for line in changes_of(path)]
    for line in changes:
        say(line)
    if not changes:
        say(f"{chapter}: nothing is changed yet")
    return 0


def changes_of(path):
    if not (ROOT / path).exists():
        return [f"{path} is gone; bring it back: cp {student.STARTER}/{path} {path}"]
    before, after = lines_of(student.starter_text(path)), lines_of(read_source(ROOT / path))
    shown = difflib.unified_diff(before, after, f"starter/{path}", f"yours/{path}")
    return [printable(line.rstrip("\r\n")) for line in shown]


def printable(line):
    return line.encode("utf-8", "replace").decode("utf-8")
