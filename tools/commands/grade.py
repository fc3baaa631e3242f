"""Grades chapters: of this tree, or of a submission.

A submission is a student's tree or the ZIP file of ./course submit. Only its exercise files are taken; build files, tests
and points are this tree's. Every graded test runs in a process of its own, under a time and a memory limit.
docs/grading.md says what a grade can be trusted with, and how to grade on Gradescope or in a container.
"""

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import ROOT
from course_lib.terminal import say
from exercises import reports, student
from exercises.catalog import catalog_path, read_catalog
from exercises.grading import grade_overlay
from exercises.submission import read_submission

HELP = "score a tree or a submission"


def add_arguments(parser):
    add_chapters_argument(parser, "all that have graded tests")
    parser.add_argument("--submission", metavar="DIR|ZIP", help="grade this instead of this tree")
    parser.add_argument("--on-reference", action="store_true",
                        help="grade a chapter on the reference's earlier chapters, not on the submission's own")
    parser.add_argument("--json", metavar="FILE", help="write the grades as JSON")
    parser.add_argument("--gradescope", metavar="FILE", help="write Gradescope's results.json")
    parser.add_argument("--junit", metavar="FILE", help="write JUnit XML")
    parser.add_argument("--time-limit", type=float, metavar="S", help="give no test more than S seconds")


def run(args):
    for path in (args.json, args.gradescope, args.junit):
        reports.remove_file(path)  # whoever reads it must not take an earlier run's for this one's
    if args.time_limit is not None and not args.time_limit > 0:
        raise CourseError("--time-limit must be more than 0 seconds")
    check_on_reference(args)
    chapters = graded_chapters(args.chapters)
    catalogs = [read_catalog(chapter) for chapter in chapters]
    ensure_packages("build")
    grades = []
    for catalog in catalogs:
        overlay, notes = overlay_of(args, catalog)
        grades.append(grade_overlay(catalog, overlay, notes, args.time_limit))
    for grade in grades:
        show(grade)
    write_reports(args, grades)
    return 0


def check_on_reference(args):
    if not args.on_reference:
        return
    if not args.submission:
        raise CourseError("--on-reference needs --submission: this tree's own earlier chapters are all there is")
    if student.is_student_tree():
        raise CourseError("--on-reference needs the reference, and this is a student's tree; grade in the course's own tree")


def graded_chapters(words):
    if words:
        return choose_chapters(words)
    chapters = [chapter for chapter in choose_chapters([]) if catalog_path(chapter).exists()]
    if not chapters:
        raise CourseError("no chapter has a grading.json, so there is nothing to grade")
    return chapters


def overlay_of(args, catalog, root=ROOT):
    """What is put over this tree for a chapter: nothing, or the submission's files of it and of the chapters before."""
    if not args.submission:
        return {}, []
    numbers = [f"{n:02}" for n in range(1, int(catalog.number) + 1)]
    submission = read_submission(args.submission, [catalog.number] if args.on_reference else numbers, root)
    return submission.overlay, submission.notes


def show(grade):
    say()
    say(reports.grade_table(grade))
    if grade.error:
        say(f"did not build: {grade.error}")
        say(grade.excerpt)
    for note in grade.notes:
        say(f"note: {note}")
    say(reports.summary(grade))


def write_reports(args, grades):
    if args.json:
        reports.write_file(args.json, reports.to_json(grades, args.submission or "", args.on_reference))
    if args.gradescope:
        reports.write_file(args.gradescope, reports.to_gradescope(grades))
    if args.junit:
        reports.write_file(args.junit, reports.to_junit(grades))
