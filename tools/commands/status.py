"""Shows the points of each chapter and exercise, as the last check found them. Builds and runs nothing."""

import time

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.terminal import say, table
from exercises import loop, student

HELP = "what is done, by chapter and exercise"


def add_arguments(parser):
    add_chapters_argument(parser)


def run(args):
    wanted = choose_chapters(args.chapters)
    catalogs = [catalog for catalog in loop.catalogs() if catalog.chapter in wanted]
    if not catalogs:
        raise CourseError("these chapters have nothing to write; leave out NN to see all that have")
    rows = [row for catalog in catalogs for row in chapter_rows(catalog)]
    say(table(rows, ["exercise", "title", "points", "", "where"], right=(2,)))
    return 0


def chapter_rows(catalog):
    results = student.recall(catalog)
    if results is None:
        return [[catalog.chapter, "", f"-/{catalog.points}", f"not checked yet: ./course check {catalog.number}", ""]]
    rows = [[catalog.chapter, "", f"{loop.points_of(catalog, results.passed)}/{catalog.points}", when(catalog, results), ""]]
    for id, exercise in catalog.exercises.items():
        tests = catalog.tests_of(id)
        points = sum(test.points for test in tests if results.passed(test))
        rows.append([f"  {id}", exercise.title, f"{points}/{sum(test.points for test in tests)}",
                     state_of(results, id, tests), loop.place_of(id)])
    return rows


def when(catalog, results):
    checked = f"{loop.count_done(catalog, results.passed)} of {len(catalog.exercises)} done, checked {loop.ago(time.time() - results.time)}"
    if results.error:
        checked = f"did not build, checked {loop.ago(time.time() - results.time)}"
    return checked if results.fresh else f"{checked}, changed since"


def state_of(results, id, tests):
    """A few words for an exercise: done, or what its first red test is."""
    for test in tests:
        if not results.passed(test):
            state, reason = loop.outcome_in(results)(test)
            other = loop.waits_for(id, state, reason)
            return f"waits for {other}" if other else "not checked yet" if state == "not run" else state
    return "done"
