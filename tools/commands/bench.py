"""Runs a side-by-side benchmark, tests/benchmarks/NAME/run.py; without a name it lists them.

Each takes --csv FILE, which gets what was measured as rows of method, case, value, unit, reference, as quantity.csv has them.
Tables that the repository keeps are written by --record only; else a run's table is in build/bench/.
"""

import argparse
import ast
import os
import sys
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import ROOT
from course_lib.process import run_visibly
from course_lib.terminal import say

HELP = "side-by-side benchmarks"


@dataclass(frozen=True)
class Benchmark:
    """What a run.py says of itself: its docstring's first line, CASES, and NEEDS, Debian packages besides those of the build."""

    name: str
    what: str
    cases: tuple
    needs: tuple


def add_arguments(parser):
    parser.add_argument("name", nargs="?", help="which; without it, the list")
    parser.add_argument("options", nargs=argparse.REMAINDER, help="what the benchmark itself takes; NAME --help tells")
    parser.epilog = listing(benchmarks())


def benchmarks(root=ROOT):
    """All benchmarks by name."""
    scripts = sorted((root / "tests" / "benchmarks").glob("*/run.py"))
    return {script.parent.name: read_benchmark(script) for script in scripts}


def read_benchmark(script):
    module = ast.parse(script.read_text())
    constants = {node.targets[0].id: node.value for node in module.body
                 if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)}
    cases, needs = (ast.literal_eval(constants[name]) if name in constants else () for name in ("CASES", "NEEDS"))
    return Benchmark(script.parent.name, (ast.get_docstring(module) or "").partition("\n")[0], cases, needs)


def listing(known):
    """The benchmarks, their cases and what each needs."""
    return "benchmarks:\n" + "".join(
        f"  {each.name:<13} {each.what}\n{'':16}cases: {', '.join(each.cases)}\n"
        f"{'':16}needs: {', '.join(each.needs) or 'nothing but the build'}\n" for each in known.values())


def run(args):
    known = benchmarks()
    if args.name is None:
        say(listing(known).rstrip())
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
