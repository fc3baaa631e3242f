"""Packs the autograder of a chapter for Gradescope: build/autograder_NN.zip, to be uploaded as it is.

It holds setup.sh, run_autograder, a student's tree as the grader, which knows no solution, and your hidden tests. Students
hand in the archive of ./course submit. docs/grading.md says more.
"""

import shutil
import zipfile
from pathlib import Path

from course_lib.chapters import choose_chapters
from course_lib.errors import CourseError
from course_lib.paths import BUILD, ROOT, shown
from course_lib.terminal import count, say
from exercises import student
from exercises.catalog import read_catalog
from exercises.hidden import with_hidden
from exercises.reports import remove_file
from exercises.trees import files_to_build, work_folder

HELP = "pack a chapter's autograder for Gradescope"
TEMPLATE = ROOT / "tools" / "templates" / "gradescope"
SCRIPTS = ("setup.sh", "run_autograder")
GRADER, HIDDEN = "grader", "hidden"
MOST_BYTES = 100 << 20  # what Gradescope takes


def add_arguments(parser):
    parser.add_argument("chapter", metavar="NN", help="chapter, by number or name")
    parser.add_argument("--hidden", metavar="DIR", type=Path, help="grade by the tests in DIR/NN_name/ as well; students see none")
    parser.add_argument("--on-reference", action="store_true",
                        help="grade on the reference's earlier chapters; the archive then holds their solutions")
    parser.add_argument("--out", metavar="FILE", type=Path, help="write this (default: build/autograder_NN.zip)")


def run(args):
    catalog = read_catalog(choose_chapters([args.chapter])[0])
    if student.is_student_tree():
        raise CourseError("this is a student's tree; an autograder is made in the course's own")
    if args.hidden and not with_hidden(catalog, args.hidden).files:
        raise CourseError(f"{args.hidden} has no hidden tests of {catalog.chapter}; they lie in a folder of that name in it")
    archive = args.out or BUILD / f"autograder_{catalog.number}.zip"
    remove_file(archive)
    try:
        files = pack(archive, catalog, args)
    except OSError as error:
        raise CourseError(f"{archive} cannot be written: {error.strerror}; name another file with --out") from None
    if archive.stat().st_size > MOST_BYTES:
        raise CourseError(f"{archive} has {archive.stat().st_size >> 20} MiB, and Gradescope takes {MOST_BYTES >> 20}")
    say(f"{shown(archive)}: {count(files, 'file')}, {archive.stat().st_size / 1e6:.1f} MB. Upload it as the autograder of an "
        "assignment of the kind 'Programming'.")
    return 0


def pack(archive, catalog, args):
    """Writes the archive and returns how many files are in it."""
    archive.parent.mkdir(parents=True, exist_ok=True)
    temporary = archive.with_name(archive.name + ".tmp")
    try:
        with work_folder("gradescope") as top:
            lay_out(top, catalog, args)
            files = sorted(path for path in top.rglob("*") if path.is_file())
            with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as packed:
                for path in files:
                    packed.write(path, path.relative_to(top))
        temporary.replace(archive)
    finally:
        temporary.unlink(missing_ok=True)
    return len(files)


def lay_out(top, catalog, args):
    words = {"NN": catalog.number, "HIDDEN": ' --hidden "$root/source/hidden"' if args.hidden else "",
             "ON_REFERENCE": " --on-reference" if args.on_reference else ""}
    for name in SCRIPTS:
        text = (TEMPLATE / name).read_text()
        for word, value in words.items():
            text = text.replace(f"@{word}@", value)
        (top / name).write_text(text)
        (top / name).chmod(0o755)
    grader = top / GRADER
    grader.mkdir()
    student.make(grader, int(catalog.number) if args.on_reference else 1)
    needed = {*files_to_build(grader), "LICENSE"}
    for path in sorted(grader.rglob("*")):
        name = path.relative_to(grader).as_posix()
        if path.is_file() and name not in needed and not name.startswith(f"{student.FOLDER}/"):
            path.unlink()
    if args.hidden:
        shutil.copytree(args.hidden / catalog.chapter, top / HIDDEN / catalog.chapter)
