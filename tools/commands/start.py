"""Makes a student's tree in an empty folder: the whole course, with stubs in place of the exercises' bodies.

Chapters before N are solved; from N on, each exercise waits to be written. The tree stands on its own and has its own ./course.
"""

from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import count, say
from exercises import student
from strip import exercises_of_tree

HELP = "make a student's tree"


def add_arguments(parser):
    parser.add_argument("folder", metavar="DIR", type=Path, help="where to make it; missing or empty")
    parser.add_argument("--chapter", metavar="N", type=int, default=1,
                        help="the first chapter to be written; those before it are solved (default: 1)")


def run(args):
    if student.is_student_tree():
        raise CourseError("this is a student's tree already; ./course start works in the course's own tree")
    chapters = sorted({int(exercise.chapter) for exercise in exercises_of_tree().values()})
    if args.chapter not in chapters:
        raise CourseError(f"no exercises in a chapter {args.chapter}; --chapter can be {', '.join(map(str, chapters))}")
    folder = args.folder.absolute()
    check_free(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        exercises = student.make(folder, args.chapter)
    except OSError as error:
        raise CourseError(f"{folder} cannot be written: {error.strerror}; name a folder that you may write to") from None
    tracked = student.make_repository(folder)
    say(f"{args.folder}: {count(exercises, 'exercise')} to write" + (", under git" if tracked else ""))
    say("Go there, then:")
    say("  ./course next     says what to do next")
    say("  ./course check    builds, tests and explains")
    return 0


def check_free(folder):
    if folder.exists() and not folder.is_dir():
        raise CourseError(f"{folder} is a file; name a folder that is missing or empty")
    if folder.is_dir() and any(folder.iterdir()):
        raise CourseError(f"{folder} is not empty; name a folder that is missing or empty")
    build = (ROOT / "build").resolve()
    inside = ROOT.resolve() in folder.resolve().parents
    if inside and build not in folder.resolve().parents:
        raise CourseError(f"{folder} lies in the course's own tree; name a folder outside, such as ../student")
