"""Installs what is missing, configures and builds everything."""

from course_lib import cmake
from course_lib.packages import ensure_packages

HELP = "build everything"


def add_arguments(parser):
    parser.add_argument("--preset", default="release", choices=cmake.preset_names(),
                        help="which of CMakePresets.json (default: release)")
    parser.add_argument("--target", action="append", default=[], help="build this target only; may be given again")


def run(args):
    ensure_packages("build")
    cmake.build(args.preset, args.target)
    return 0
