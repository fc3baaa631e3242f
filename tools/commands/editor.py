"""Opens the Bézier editor, on a profile or on an empty sheet. docs/editor.md tells its mouse and keys."""

from pathlib import Path

from course_lib import cmake
from course_lib.packages import ensure_packages
from course_lib.paths import program
from course_lib.process import run_visibly

HELP = "the Bézier editor"
PROGRAM = "bezier_editor"


def add_arguments(parser):
    parser.add_argument("file", nargs="?", metavar="FILE", help="a profile: control points (.txt) or SVG (.svg)")


def run(args):
    ensure_packages("build")
    cmake.build(targets=[PROGRAM], title="build the editor")
    files = [Path(args.file).absolute()] if args.file else []
    return run_visibly([program(PROGRAM), *files])
