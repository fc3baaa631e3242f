"""What the commands of the student's loop share: grading in place, what is red, which exercise is meant."""

import re
import time

from course_lib.chapters import all_chapters, choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, ROOT
from course_lib.terminal import count, format_duration
from exercises import student
from exercises.building import build_tree, program
from exercises.catalog import catalog_path, read_catalog
from exercises.grading import ChapterGrade, Conditions, at_most, grade_spliced, run_tests
from exercises.splicing import Spliced
from exercises.trees import work_folder
from exercises.verdicts import NOT_IMPLEMENTED, PASSED
from strip import body, exercises_of_tree, read_source, stub

MOST_WARNINGS = 5  # that a check shows
NAMED_STUB = re.compile(r"exercise (ex-\d\d\.\d+) is not implemented")
EXERCISE_WORD = re.compile(r"(?:ex-)?0*(\d+)\.0*(\d+)")


def catalogs(root=ROOT):
    """The catalogs of the chapters that the student has to write and that have graded tests."""
    first = student.first_chapter(root)
    return [read_catalog(chapter, root) for chapter in all_chapters(root)
            if chapter[:2] >= first and catalog_path(chapter, root).exists()]


def chosen_catalogs(words, root=ROOT):
    """The catalogs of the chapters named; when none is, of those to check now: see catalogs_to_check."""
    if words:
        return [read_catalog(chapter, root) for chapter in choose_chapters(words, root)]
    return catalogs_to_check(root)


def catalogs_to_check(root=ROOT):
    """The first chapter that is not all green by what was last seen of it, and before it the finished ones whose files have
    changed since; the last chapter when there is nothing else."""
    known = catalogs(root)
    if not known:
        raise CourseError("no chapter has a grading.json, so there is nothing to check")
    due = []
    for catalog in known:
        results = student.recall(catalog, root)
        if not is_finished(catalog, results):
            return [*due, catalog]
        if not results.fresh:
            due.append(catalog)
    return due or known[-1:]


def is_finished(catalog, results):
    """Whether all was green when the chapter was last checked, whatever has changed since."""
    return results is not None and all(results.passed(test) for test in catalog.tests)


def find_exercise(word, root=ROOT):
    """(catalog, id) of an exercise that is named as 1.3, 01.3 or ex-01.3."""
    matched = EXERCISE_WORD.fullmatch(word)
    id = f"ex-{int(matched[1]):02}.{matched[2]}" if matched else word
    for catalog in catalogs(root):
        if id in catalog.exercises:
            return catalog, id
    known = [id for catalog in catalogs(root) for id in catalog.exercises]
    there_are = ", ".join(known) if len(known) <= 8 else f"{known[0]} to {known[-1]}; ./course status lists them"
    raise CourseError(f"there is no exercise '{word}' to write; there are {there_are}")


def paths_upto(number, root=ROOT):
    """The files with exercises that the student has to write, of a chapter and those before."""
    exercises = student.starter_exercises(root).values()
    return sorted({exercise.path for exercise in exercises if exercise.chapter <= number})


def own_bodies(number, root=ROOT):
    """What counts of a student's files up to a chapter, by the same rule as in the grader."""
    spliced = Spliced()
    for path in paths_upto(number, root):
        place = root / path
        spliced.add(path, student.starter_text(path, root), place.read_bytes() if place.is_file() else None)
    return spliced


def grade_here(catalog, time_limit=None, root=ROOT):
    """Grades a chapter of this tree as a grader would; remembers what came out.

    Builds in this tree when all of its files counts, else beside it, with what counts.
    """
    student.require_whole(root)
    ensure_packages("build")
    spliced = own_bodies(catalog.number, root) if student.is_student_tree(root) else Spliced()
    grade = None
    if all((root / path).is_file() and (root / path).read_bytes() == content for path, content in spliced.overlay.items()):
        grade = grade_in_place(catalog, time_limit, root)
    if grade is None:
        with work_folder("check_tree", keep=True) as folder:
            grade = grade_spliced(catalog, spliced, folder, Conditions(time_limit, test_time=None, build_time=None), root)
    student.remember(grade, root)
    return grade


def grade_in_place(catalog, time_limit, root):
    """None when it does not build."""
    built = build_tree(root, [catalog.target], catalog.chapter)
    if built.error:
        return None
    outcomes = run_tests(catalog, program(root, catalog.target), BUILD / "scratch", at_most(time_limit), f"test {catalog.chapter}")
    return ChapterGrade(catalog, outcomes, notes=warnings_of(built))


def warnings_of(built):
    """What the compiler warned of just now. No points are lost by it, but often the mistake is found."""
    found = list(dict.fromkeys(built.warnings))
    more = [f"and {count(len(found) - MOST_WARNINGS, 'further warning')}"] if len(found) > MOST_WARNINGS else []
    return found[:MOST_WARNINGS] + more


def up_to_date_results(catalog, root=ROOT):
    """What is known of this very state of the sources; found out now when it is not known, and there is something to try."""
    results = student.recall(catalog, root)
    if results is None and is_untouched(catalog, root):
        return student.Results({}, "", time.time(), True)
    if results is None or not results.fresh:
        grade_here(catalog, root=root)
        results = student.recall(catalog, root)
    return results


def is_untouched(catalog, root=ROOT):
    """Whether the chapter's files with exercises are as the student got them."""
    if not student.is_student_tree(root):
        return False
    paths = {exercise.path for exercise in student.starter_exercises(root).values() if exercise.chapter == catalog.number}
    return all((root / path).is_file() and (root / path).read_bytes() == (root / student.STARTER / path).read_bytes() for path in paths)


def place_of(id, root=ROOT):
    """"common/curve/bezier_curve.cpp:34"; where it was at the start when its markers are gone."""
    exercise = exercises_of_tree(root).get(id)
    if exercise is None and student.is_student_tree(root):
        exercise = student.starter_exercises(root).get(id)
    return exercise.place if exercise else "nowhere: its markers are gone"


def first_red(catalog, outcome_of, root=ROOT):
    """(exercise, test) to do next; None when all tests pass. An exercise that is written and waits for a later one can
    be told nothing yet, so the next one comes first.

    @param outcome_of  test -> (state, reason)
    """
    waiting = None
    for id in catalog.exercises:
        red = next((test for test in catalog.tests_of(id) if outcome_of(test)[0] != PASSED), None)
        if red is None:
            continue
        if not waits_for(id, *outcome_of(red), root):
            return catalog.exercises[id], red
        waiting = waiting or (catalog.exercises[id], red)
    return waiting


def waits_for(id, state, reason, root=ROOT):
    """The exercise that a written one's test has to wait for; empty when it waits for none."""
    named = NAMED_STUB.search(reason)
    return named[1] if state == NOT_IMPLEMENTED and named and named[1] != id and is_written(id, root) else ""


def is_written(id, root=ROOT):
    """Whether something else than its stub stands between an exercise's markers."""
    exercise = exercises_of_tree(root).get(id)
    return exercise is not None and body(read_source(root / exercise.path), exercise).strip() != stub(exercise).strip()


def outcome_in(results):
    """What gives (state, reason) of a test, by what a check found."""
    def outcome_of(test):
        known = results.tests.get(test.name, {})
        return known.get("state", "not run"), known.get("reason", "")
    return outcome_of


def count_done(catalog, passed):
    return sum(all(passed(test) for test in catalog.tests_of(id)) for id in catalog.exercises)


def points_of(catalog, passed):
    return sum(test.points for test in catalog.tests if passed(test))


def ago(seconds):
    return "just now" if seconds < 5 else f"{format_duration(seconds)} ago"
