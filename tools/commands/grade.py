"""Grades chapters: of this tree, of a submission, or of each submission in a folder.

A submission is a student's tree or the ZIP file of ./course submit. Only the bodies of its exercises are taken; all else is
this tree's. It is built and run in a sandbox, every graded test in a process of its own, under limits. docs/grading.md says
what a grade can be trusted with, and how to grade on Gradescope or in a container.
"""

import argparse
import dataclasses
from pathlib import Path

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, ROOT, shown
from course_lib.terminal import count, printable, say
from exercises import hand_ins, overview, reports, sandbox, student
from exercises.catalog import catalog_path, read_catalog
from exercises.grading import MOST_BUILD_TIME, MOST_TEST_TIME, Conditions, grade_spliced, worthless
from exercises.hidden import with_hidden
from exercises.splicing import Spliced
from exercises.submission import Refused, read_submission
from exercises.trees import work_folder
from exercises.verdicts import REFUSED

HELP = "score a tree, a submission or a folder of submissions"
UNSANDBOXED = "none: graded with --unsandboxed"
OWN = "none: nobody else's code"


class Once(argparse.Action):
    """An option that can be given once only: of two values, one would be left out in silence."""

    def __call__(self, parser, namespace, values, option=None):
        if getattr(namespace, self.dest) is not None:
            parser.error(f"{option} is given twice")
        setattr(namespace, self.dest, values)


def add_arguments(parser):
    add_chapters_argument(parser, "all that have graded tests")
    parser.add_argument("--submission", metavar="DIR|ZIP", action=Once, help="grade this instead of this tree")
    parser.add_argument("--all", metavar="DIR", action=Once, help="grade each student's tree and each ZIP file in a folder")
    parser.add_argument("--on-reference", action="store_true",
                        help="grade a chapter on the reference's earlier chapters, not on the submission's own")
    parser.add_argument("--hidden", metavar="DIR", action=Once,
                        help="grade by the tests in DIR/NN_name/ as well, which students don't know")
    parser.add_argument("--json", metavar="FILE", action=Once, help="write the grades as JSON")
    parser.add_argument("--gradescope", metavar="FILE", action=Once, help="write Gradescope's results.json")
    parser.add_argument("--junit", metavar="FILE", action=Once, help="write JUnit XML")
    parser.add_argument("--csv", metavar="FILE", action=Once, help="with --all: write this (default: build/grades.csv)")
    parser.add_argument("--html", metavar="FILE", action=Once, help="with --all: write this page (default: build/grades.html)")
    parser.add_argument("--time-limit", type=float, metavar="S", action=Once, help="give no test more than S seconds")
    parser.add_argument("--test-time", type=float, metavar="S", action=Once,
                        help=f"begin no test of a chapter after S seconds (default: {MOST_TEST_TIME})")
    parser.add_argument("--build-time", type=float, metavar="S", action=Once,
                        help=f"give up the build of a chapter after S seconds (default: {MOST_BUILD_TIME})")
    parser.add_argument("--unsandboxed", action="store_true",
                        help="grade without a sandbox: in a container or on a machine that is thrown away")


def run(args):
    if args.all:
        args.csv, args.html = args.csv or BUILD / "grades.csv", args.html or BUILD / "grades.html"
    for path in (args.json, args.gradescope, args.junit, args.csv, args.html):
        reports.remove_file(path)  # whoever reads it must not take an earlier run's for this one's
    check_arguments(args)
    chapters = graded_chapters(args.chapters)
    catalogs = [read_catalog(chapter) for chapter in chapters]
    if args.hidden:
        catalogs = [with_hidden(catalog, args.hidden) for catalog in catalogs]
        require_hidden(catalogs, args.hidden)
    ensure_packages("grade" if is_of_others(args) and not args.unsandboxed else "build")
    conditions = conditions_of(args)
    return grade_folder(args, catalogs, conditions) if args.all else grade_one(args, catalogs, conditions)


def grade_one(args, catalogs, conditions):
    """@throws Refused when a hand-in is, once the reports say so"""
    grades, refusals = [], []
    for catalog in catalogs:
        try:
            spliced = hand_in(args.submission, catalog, args.on_reference)
        except Refused as refusal:
            refusals.append(refusal)
            grades.append(worthless(catalog, REFUSED, printable(str(refusal))))
            continue
        with work_folder("grade") as folder:
            grades.append(grade_spliced(catalog, spliced, folder, conditions))
    for grade in grades:
        show(grade)
    say(f"sandbox: {sandbox_of(args)}")
    write_reports(args, grades)
    if refusals:
        raise refusals[0]
    return 0


def grade_folder(args, catalogs, conditions):
    """--all. The exit code is 1 when a hand-in could not be graded by no fault of its author's."""
    paths, others = hand_ins.entries(args.all)
    conditions = dataclasses.replace(conditions, quiet=True, jobs=1)
    graded = hand_ins.grade_all(paths, catalogs, lambda path, catalog: hand_in(path, catalog, args.on_reference), conditions)
    say()
    say(overview.to_table(graded, catalogs))
    say()
    for name in others:
        say(printable(f"note: {name} is neither a folder nor a ZIP file, and is left out"))
    for one in graded:
        if overview.remark(one):
            say(f"{one.name}: {overview.remark(one)}")
    say(f"sandbox: {sandbox_of(args)}")
    reports.write_file(args.csv, overview.to_csv(graded, catalogs, sandbox_of(args)))
    reports.write_file(args.html, overview.to_html(graded, catalogs, sandbox_of(args)))
    failed = sum(bool(one.error) for one in graded)
    say(f"{count(len(graded) - failed, 'hand-in')} graded, {failed} not; see {shown(args.csv)} and {shown(args.html)}")
    return 1 if failed else 0


def require_hidden(catalogs, folder):
    """@throws CourseError when none of the chapters has a hidden test: the folder is another than was meant"""
    if not any(test.hidden for catalog in catalogs for test in catalog.tests):
        names = ", ".join(catalog.chapter for catalog in catalogs)
        raise CourseError(f"{folder} has no hidden tests of {names}; they lie in a folder of the chapter's name in it")


def is_of_others(args):
    return bool(args.submission or args.all)


def check_arguments(args):
    for option, value in (("--time-limit", args.time_limit), ("--test-time", args.test_time), ("--build-time", args.build_time)):
        if value is not None and not value > 0:
            raise CourseError(f"{option} must be more than 0 seconds")
    if args.all and (args.submission or args.json or args.gradescope or args.junit):
        raise CourseError("--all writes --csv and --html, and goes with no --submission, --json, --gradescope or --junit")
    if (args.csv or args.html) and not args.all:
        raise CourseError("--csv and --html are of --all; a single grading writes --json, --gradescope and --junit")
    if not args.on_reference:
        return
    if not is_of_others(args):
        raise CourseError("--on-reference needs --submission or --all: this tree's own earlier chapters are all there is")
    if student.is_student_tree() and any(chapter[:2] > student.first_chapter() for chapter in graded_chapters(args.chapters)):
        raise CourseError("--on-reference needs the reference, and this is a student's tree; grade in the course's own tree")


def conditions_of(args):
    """@throws NoSandbox when somebody else's code is graded, and there is neither a sandbox nor leave to do without"""
    sandboxed = is_of_others(args) and not args.unsandboxed
    if sandboxed:
        sandbox.require()
    return Conditions(args.time_limit, args.test_time or MOST_TEST_TIME, args.build_time or MOST_BUILD_TIME, sandboxed)


def sandbox_of(args):
    """What every report says of it."""
    if not is_of_others(args):
        return OWN
    return UNSANDBOXED if args.unsandboxed else "bubblewrap"


def graded_chapters(words):
    if words:
        return choose_chapters(words)
    chapters = [chapter for chapter in choose_chapters([]) if catalog_path(chapter).exists()]
    if not chapters:
        raise CourseError("no chapter has a grading.json, so there is nothing to grade")
    return chapters


def hand_in(submission, catalog, on_reference, root=ROOT):
    """What is put into this tree for a chapter: nothing, or the submission's bodies of it and of the chapters before."""
    if not submission:
        return Spliced()
    numbers = [f"{n:02}" for n in range(1, int(catalog.number) + 1)]
    return read_submission(hand_ins.unwrapped(Path(submission)), [catalog.number] if on_reference else numbers, root)


def show(grade):
    say()
    say(reports.grade_table(grade))
    for line in reports.errors_and_notes(grade):
        say(printable(line))
    for look in grade.looks:
        say(printable(f"look: {look}"))
    say(reports.summary(grade))


def write_reports(args, grades):
    where = sandbox_of(args)
    if args.json:
        reports.write_file(args.json, reports.to_json(grades, args.submission or "", args.on_reference, where))
    if args.gradescope:
        reports.write_file(args.gradescope, reports.to_gradescope(grades, where))
    if args.junit:
        reports.write_file(args.junit, reports.to_junit(grades, where))
