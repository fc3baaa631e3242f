"""Installs the Debian packages that the course needs (packages.txt says what each is for).

With sudo when you are not root; on other systems it prints the list. Other commands do this themselves.
"""

from course_lib.packages import GROUPS, ensure_packages, needed_packages
from course_lib.terminal import say

HELP = "install the Debian packages that are missing"


def add_arguments(parser):
    parser.add_argument("--group", choices=sorted(GROUPS), default="build",
                        help="what you want to do: build (default), test, docs, grade, bench, or full (test --full)")


def run(args):
    ensure_packages(args.group)
    say(f"Set-up for '{args.group}' is done ({len(needed_packages(args.group))} packages).")
    return 0
