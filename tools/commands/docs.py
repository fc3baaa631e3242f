"""Builds the course's site: lessons, figures, glossary, and the API from the headers, all without a network.

The build fails when a lesson shows code that does not exist or leaves an exercise out, when Doxygen warns (an undocumented
public member, say), and when a link or a picture is dead.
"""

import webbrowser

from course_lib import cmake
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, ROOT, build_dir, declarations, shown
from course_lib.terminal import Step, count, say
from docs.builder import Builder

HELP = "build the site into build/docs/html"


def add_arguments(parser):
    parser.add_argument("--open", action="store_true", help="show it in your browser")


def run(args):
    ensure_packages("docs")
    index = build_site()
    say(f"The site is in {shown(index)}")
    if args.open:
        webbrowser.open(index.as_uri())
    return 0


def build_site():
    """Builds the site of this tree and returns the path of its front page."""
    cmake.build(targets=["build.ninja"], title="read the declarations")
    builder = Builder(ROOT, BUILD / "docs", build_dir() / "declarations.json", declarations())
    with Step("check lessons"):
        complain(builder.lesson_problems())
    with Step("build the site"):
        complain(builder.build())
    return builder.html / "index.html"


def complain(problems):
    if not problems:
        return
    for problem in problems:
        say(problem)
    raise CourseError(f"the site has {count(len(problems), 'problem')}; first {problems[0]}")
