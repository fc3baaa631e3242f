"""Builds a chapter, runs its graded tests, and explains the first that is red.

Without NN: the first chapter that is not all green. When the chapter can draw figures, each picture is put beside the
reference's and their difference, in build/check/NN/.
"""

from course_lib.errors import CourseError
from course_lib.paths import shown
from course_lib.terminal import count, say, table
from exercises import loop, reports
from exercises.pictures import compare_figures

HELP = "build and test your exercises; see what is red and why"


def add_arguments(parser):
    parser.add_argument("chapters", nargs="*", metavar="NN", help="chapters (default: the first unfinished one)")
    parser.add_argument("--no-pictures", action="store_true", help="draw nothing")
    parser.add_argument("--time-limit", type=float, metavar="S", help="give no test more than S seconds")


def run(args):
    if args.time_limit is not None and not args.time_limit > 0:
        raise CourseError("--time-limit must be more than 0 seconds")
    green = True
    for catalog in loop.chosen_catalogs(args.chapters):
        grade = loop.grade_here(catalog, args.time_limit)
        show(grade)
        if grade.done and not args.no_pictures:
            show_pictures(compare_figures(catalog.chapter))
        green = green and grade.points == catalog.points
    return 0 if green else 1


def show(grade):
    say()
    if grade.error:
        say(f"{grade.chapter} does not build: {grade.error}")
        say(grade.excerpt)
        say()
    say(reports.grade_table(grade))
    say()
    for note in grade.notes:
        say(f"note: {note}")
    if grade.error:
        say(f"{reports.summary(grade)}. Make it compile, then run ./course check again.")
        return
    say(f"{reports.summary(grade)}.")
    states = {o.test.name: o.outcome for o in grade.outcomes}
    red = loop.first_red(grade.catalog, lambda test: states[test.name].passed)
    if red:
        explain(grade, *red)
    else:
        say(f"All {count(len(grade.catalog.exercises), 'exercise')} done. ./course submit {grade.catalog.number} packs them.")


def explain(grade, exercise, test):
    """The first red: where to go, what the test says, what to look at."""
    total = len(grade.catalog.exercises)
    to_do = total - len(grade.done)
    say(f"{to_do} of {count(total, 'exercise')} to do; start with {exercise.id} in {loop.place_of(exercise.id)}: {exercise.title}")
    graded = next(o for o in grade.outcomes if o.test is test)
    say()
    say(f"{test.name}")
    for line in reports.details(graded).splitlines():
        say(f"  {line}".rstrip())


def show_pictures(comparisons):
    if not comparisons:
        return
    say()
    say(table([[c.name, c.result, shown(c.path) if c.path else ""] for c in comparisons], ["figure", "result", "see"]))
