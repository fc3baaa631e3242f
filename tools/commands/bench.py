"""Runs a side-by-side benchmark, tests/benchmarks/NAME/run.py; without a name it lists them."""

import argparse
import ast
import os
import sys

from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import ROOT
from course_lib.process import run_visibly
from course_lib.terminal import say, table

HELP = "side-by-side benchmarks"


def add_arguments(parser):
    parser.add_argument("name", nargs="?", help="which; without it, the list")
    parser.add_argument("options", nargs=argparse.REMAINDER, help="what the benchmark itself takes; --help tells")


def benchmarks(root=ROOT):
    """All benchmarks: name -> the first line of their docstring."""
    found = {}
    for script in sorted((root / "tests" / "benchmarks").glob("*/run.py")):
        text = ast.get_docstring(ast.parse(script.read_text())) or ""
        found[script.parent.name] = text.partition("\n")[0]
    return found


def run(args):
    known = benchmarks()
    if args.name is None:
        say(table(known.items()))
        return 0
    if args.name not in known:
        raise CourseError(f"there is no benchmark '{args.name}'; there are {', '.join(known)}")
    ensure_packages("bench")
    script = ROOT / "tests" / "benchmarks" / args.name / "run.py"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "tools")}
    code = run_visibly([sys.executable, script, *args.options], env=environment)
    if code != 0:
        raise CourseError(f"benchmark {args.name} stopped with exit code {code}; its own message stands above")
    return 0
