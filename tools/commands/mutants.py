"""Tries every mistake of tests/NN_name/mistakes on the reference: the test that it names must catch it.

Also checks that each graded test is needed: without it, a mistake would go uncaught.
"""

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.terminal import Step, count, say, table
from exercises import student
from exercises.catalog import read_catalog
from exercises.mistakes import MutantTree, complaints, mistakes_folder, read_mistakes
from exercises.trees import files_to_build, lay_out, work_folder

HELP = "every listed mistake must be caught by its test"


def add_arguments(parser):
    add_chapters_argument(parser, "all that have mistakes")


def run(args):
    if student.is_student_tree():
        raise CourseError("this is a student's tree, and mistakes belong to the course's own; run it there")
    chapters = chosen_chapters(args.chapters)
    ensure_packages("build")
    wrong = [complaint for chapter in chapters for complaint in try_chapter(read_catalog(chapter))]
    if wrong:
        raise CourseError(f"{count(len(wrong), 'complaint')}, the first: {wrong[0]}")
    return 0


def chosen_chapters(words):
    chapters = choose_chapters(words)
    with_mistakes = [chapter for chapter in chapters if any(mistakes_folder(chapter).glob("*.patch"))]
    if words and with_mistakes != chapters:
        missing = next(chapter for chapter in chapters if chapter not in with_mistakes)
        raise CourseError(f"tests/{missing}/mistakes/ holds no patch; docs/grading.md says how to write one")
    if not with_mistakes:
        raise CourseError("no chapter has mistakes in tests/NN_name/mistakes/, so there is nothing to try")
    return with_mistakes


def try_chapter(catalog):
    mistakes = read_mistakes(catalog)
    with work_folder("mutants", keep=True) as folder:
        lay_out(folder / "tree", files_to_build(), {})
        tree = MutantTree(folder / "tree", catalog, folder / "scratch")
        tree.try_reference()
        results = []
        with Step(f"try {count(len(mistakes), 'mistake')} of {catalog.chapter}") as step:
            for mistake in mistakes:
                results.append(tree.try_mistake(mistake))
                step.progress(len(results), len(mistakes))
    wrong = complaints(catalog, results)
    show(catalog, results, wrong)
    return wrong


def show(catalog, results, wrong):
    rows = [[r.mistake.slug, r.mistake.exercise, r.mistake.caught_by, outcome(r), len(r.caught)] for r in results]
    say()
    say(table(rows, ["mistake", "exercise", "named test", "outcome", "caught by"], right=(4,)))
    say()
    for complaint in wrong:
        say(f"wrong: {complaint}")
    if not wrong:
        exercises = len({r.mistake.exercise for r in results})
        say(f"{catalog.chapter}: {count(len(results), 'mistake')} in {count(exercises, 'exercise')}, all caught by the test "
            f"that they name; each of the {count(len(catalog.tests), 'graded test')} is the only one to catch some mistake")


def outcome(result):
    if result.error:
        return "not tried"
    return "ESCAPED" if result.complaint else "caught"
