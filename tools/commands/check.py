"""Builds a chapter, runs its graded tests, and explains the first that is red.

Without NN: the first chapter that is not all green, and before it those that were, when their files have changed since.
When points were won or lost, or --pictures asks for it, each picture that the chapter can draw is put beside the reference's
and their difference, in build/check/NN/. The build is as strict as that of ./course test in this tree: warnings are shown, and
are no errors.
"""

from course_lib.errors import CourseError
from course_lib.paths import BUILD, shown
from course_lib.terminal import count, say, table
from exercises import loop, reports, student
from exercises.pictures import compare_figures
from exercises.verdicts import TRIED

HELP = "build and test your exercises; see what is red and why"


def add_arguments(parser):
    parser.add_argument("chapters", nargs="*", metavar="NN", help="chapters (default: the first unfinished one)")
    pictures = parser.add_mutually_exclusive_group()
    pictures.add_argument("--pictures", action="store_true", help="draw the pictures also when the points are as before, and in full those that take long")
    pictures.add_argument("--no-pictures", action="store_true", help="draw nothing")
    parser.add_argument("--time-limit", type=float, metavar="S", help="give no test more than S seconds")


def run(args):
    if args.time_limit is not None and not args.time_limit > 0:
        raise CourseError("--time-limit must be more than 0 seconds")
    green = True
    for catalog in loop.chosen_catalogs(args.chapters):
        if not args.chapters and loop.is_finished(catalog, results := student.recall(catalog)) and not results.fresh:
            say(f"{catalog.chapter} was finished, but its files have changed since: it is checked again.")
        grade = loop.grade_here(catalog, args.time_limit)
        show(grade)
        show_pictures(grade, args)
        if grade.points == catalog.points:
            show_end(catalog)
        green = green and grade.points == catalog.points
        if not green and not args.chapters:
            break
    return 0 if green else 1


def show(grade):
    say()
    if grade.error:
        say(f"{grade.chapter} does not build: {grade.error}")
        if reports.excerpt_after(grade):
            say(reports.excerpt_after(grade))
        say()
    say(reports.grade_table(grade))
    say()
    for note in grade.notes:
        say(f"note: {note}")
    if grade.error:
        say(f"{reports.summary(grade)}. Make it compile, then run ./course check again.")
        return
    say(f"{reports.summary(grade)}.")
    for id, other in waiting(grade):
        say(f"note: {id} is written, and its tests wait for {other}")
    states = {o.test.name: (o.outcome.state, o.outcome.reason) for o in grade.outcomes}
    red = loop.first_red(grade.catalog, lambda test: states[test.name])
    if red:
        explain(grade, *red)


def waiting(grade):
    """(exercise, the one that it waits for) of those that are written."""
    found = {}
    for o in grade.outcomes:
        other = loop.waits_for(o.test.exercise, o.outcome.state, o.outcome.reason)
        if other:
            found.setdefault(o.test.exercise, other)
    return found.items()


def explain(grade, exercise, test):
    """The first red: where to go, what the test says, what to look at once it was tried."""
    total = len(grade.catalog.exercises)
    to_do = total - len(grade.done)
    say(f"{to_do} of {count(total, 'exercise')} to do; start with {exercise.id} in {loop.place_of(exercise.id)}: {exercise.title}")
    graded = next(o for o in grade.outcomes if o.test is test)
    if graded.outcome.state not in TRIED:
        say(f"The lesson: chapters/{grade.chapter}/README.md")
    say()
    say(f"{test.name}")
    for line in reports.details(graded).splitlines():
        say(f"  {line}".rstrip())


def show_pictures(grade, args):
    """Draws them when that is asked for, or when they were never drawn at these points."""
    if grade.error or args.no_pictures or not (grade.done or args.pictures):
        return
    last = student.recall_pictures(grade.catalog)
    is_there = (BUILD / "check" / grade.catalog.number).exists()
    say()
    if not args.pictures and is_there and last and last["points"] == grade.points:
        say(f"Pictures: as many points as when they were drawn last; ./course check {grade.catalog.number} --pictures draws them again.")
        return
    comparisons = compare_figures(grade.chapter, in_full=args.pictures)
    student.remember_pictures(grade.catalog, grade.points, [c.name for c in comparisons if c.wrong])
    if comparisons:
        say()
        say(table([[c.name, c.result, shown(c.path) if c.path else ""] for c in comparisons], ["figure", "result", "see"]))


def show_end(catalog):
    """All is green; a picture that is not as it should be is a mistake all the same."""
    say()
    wrong = (student.recall_pictures(catalog) or {}).get("wrong", [])
    if wrong:
        say(f"All tests pass, but when the pictures were drawn last, {' and '.join(wrong)} differed from the reference. "
            "Find out why before you hand in.")
    say(f"All {count(len(catalog.exercises), 'exercise')} done. ./course submit {catalog.number} packs them.")
