"""Tries every mistake of tests/NN_name/mistakes on the reference: the test that it names must catch it.

Also checks that each graded test is needed: without it, a mistake would go uncaught; and that every body of
tests/NN_name/alternatives, right in another way, gets full points. With --systematic it tries mistakes that are made by rule
instead (docs/mutants.md): how many do the graded tests let through?
"""

import argparse
from pathlib import Path

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.terminal import Step, count, say, table
from exercises import student
from exercises.catalog import read_catalog
from exercises.mistakes import MutantTree, complaints, mistakes_folder, read_alternatives, read_mistakes
from exercises.trees import files_to_build, lay_out, work_folder
from mutation.systematic import run_systematic

HELP = "every listed mistake must be caught by its test"


def add_arguments(parser):
    add_chapters_argument(parser, "all that have mistakes")
    parser.add_argument("--systematic", action="store_true", help="mistakes made by rule instead of the listed ones")
    rule = parser.add_argument_group("with --systematic")
    rule.add_argument("--all", action="store_true", help="try all (the default); what earlier runs found out is kept")
    rule.add_argument("--sample", type=at_least_one, metavar="N", help="try N of each chapter")
    rule.add_argument("--seed", type=int, default=None, metavar="S", help="which ones, and in which order (default 1)")
    rule.add_argument("--minutes", type=positive, metavar="M", help="begin nothing more after M minutes")
    rule.add_argument("--only", metavar="EX", help="of one exercise: ex-02.3")
    rule.add_argument("--at-least", type=float, default=95, metavar="P", help="per cent that must be caught (default 95)")
    rule.add_argument("-j", "--jobs", type=at_least_one, metavar="N", help="programs at a time (default: a processor each)")
    rule.add_argument("--json", type=Path, metavar="FILE", help="write what became of each mutant")
    rule.add_argument("--csv", type=Path, metavar="FILE", help="write the counts by chapter and operator")


def at_least_one(word):
    number = int(word)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{word} is not at least 1")
    return number


def positive(word):
    number = float(word)
    if not number > 0:
        raise argparse.ArgumentTypeError(f"{word} is not above 0")
    return number


def run(args):
    if student.is_student_tree():
        raise CourseError("this is a student's tree, and mistakes belong to the course's own; run it there")
    if args.systematic:
        return run_systematic(args)
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
    alternatives = read_alternatives(catalog)
    with work_folder("mutants", keep=True) as folder:
        lay_out(folder / "tree", files_to_build(), {})
        tree = MutantTree(folder / "tree", catalog, folder / "scratch")
        tree.try_reference()
        results = []
        with Step(f"try {count(len(mistakes), 'mistake')} of {catalog.chapter}") as step:
            for mistake in mistakes:
                results.append(tree.try_mistake(mistake))
                step.progress(len(results), len(mistakes))
        others = []
        with Step(f"try {count(len(alternatives), 'alternative')} of {catalog.chapter}") as step:
            for alternative in alternatives:
                others.append(tree.try_alternative(alternative))
                step.progress(len(others), len(alternatives))
    wrong = complaints(catalog, results) + [f"{o.alternative.slug}: {o.complaint}" for o in others if o.complaint]
    show(catalog, results, others, wrong)
    return wrong


def show(catalog, results, others, wrong):
    rows = [[r.mistake.slug, r.mistake.exercise, r.mistake.caught_by, outcome(r), len(r.caught)] for r in results]
    say()
    say(table(rows, ["mistake", "exercise", "named test", "outcome", "caught by"], right=(4,)))
    say()
    if others:
        say(table([[o.alternative.slug, o.alternative.exercise, "REFUSED" if o.complaint else "full points"] for o in others],
                  ["alternative", "exercise", "outcome"]))
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
