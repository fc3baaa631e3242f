"""Builds and runs the tests: all, or the C++ tests of some chapters.

Parts: the build, each header by itself, who includes whom, the C++ tests by kind, the tests of the course's tools.
What passed is not run again until one of its inputs changes (build/green.json; --again runs it all the same).
--full adds a queue of heavy checks: the sanitizers, a debug build, clang-tidy, all mutants, the tests labelled large, a build
without precompiled headers, line coverage by the chapters, a student's way through all of them. One that was stopped is gone
on with by the next --full.
"""

import sys
import time

from changed_chapters import changed_chapters
from course_lib import cmake
from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.checks import inputs_of
from course_lib.coverage import chapter_coverage
from course_lib.ctest import Outcome, all_test_names, by_check, of_chapters, of_kind, of_label, run_tests, test_names
from course_lib.errors import CourseError
from course_lib.green import Memory
from course_lib.packages import ensure_packages
from course_lib.paths import ROOT, build_dir, declarations
from course_lib.process import run as run_program, run_visibly
from course_lib.queue import Queue, full_checks
from course_lib.terminal import count, format_duration, say, table

HELP = "build and run the tests"
KINDS = ("graded", "property", "stability")  # of C++ tests
LARGE = "large"  # the kind of those that take minutes: --full only
FULL_PRESETS = ("sanitize", "thread", "debug")


def add_arguments(parser):
    add_chapters_argument(parser)
    parser.add_argument("--full", action="store_true", help="the queue of heavy checks as well")
    parser.add_argument("--changed", action="store_true",
                        help="with --full: chapters whose files changed lately come first (tools/changed_chapters.py)")
    parser.add_argument("--patience", type=float, metavar="S", help="with --full: begin no heavy check after S seconds")
    parser.add_argument("--limit", type=float, metavar="S", help="with --full: stop a heavy check that still runs after S seconds")
    parser.add_argument("--large", action="store_true", help="the large tests, and nothing else")
    parser.add_argument("--coverage", action="store_true", help="line coverage by the chapters, and nothing else")
    parser.add_argument("--walk", action="store_true",
                        help="a student's way through all chapters, and nothing else: minutes, more if little is compiled yet")
    parser.add_argument("--again", action="store_true", help="run also what passed and has not changed since")
    parser.add_argument("--preset", choices=("release", *FULL_PRESETS), default="release",
                        help="run the C++ tests as another preset builds them, and nothing else")


def run(args):
    for option in ("changed", "patience", "limit"):
        if getattr(args, option) and not args.full:
            raise CourseError(f"--{option} belongs to --full; run ./course test --full --{option}")
    chapters = choose_chapters(args.chapters)
    parts = Parts(args.again)
    ensure_packages("full" if args.full or args.coverage else "test")
    if args.walk:
        return walk(args.chapters)
    if args.preset != "release":
        run_preset(parts, args.preset, chapters)
    elif args.large:
        parts.step("build the large tests", lambda: cmake.build(targets=test_programs(chapters, (LARGE,))) and None)
        parts.tests("large tests", "release", of_chapters(numbers(chapters), LARGE))
    elif args.coverage:
        parts.step("coverage by the chapters", chapter_coverage)
    else:
        run_release(parts, chapters, everything=not args.chapters)
        if args.full:
            run_full(parts, chapters, args)
    return parts.report()


def walk(chapters):
    """tests/course/walk.py counts for itself: it is no test of a part, but one way from the first exercise to the last."""
    script = ROOT / "tests" / "course" / "walk.py"
    if chapters:
        raise CourseError("--walk goes through all chapters, one after the other; name none")
    if not script.exists():
        raise CourseError("--walk tests the course's own tree, and this is a student's")
    return run_visibly([sys.executable, "-B", script])


class Parts:
    """The parts of a test run: title, tests passed, failures, seconds."""

    def __init__(self, again=False, memory=None):
        self._again = again
        self._memory = memory or Memory()
        self._rows = []
        self._failures = []
        self.start = time.monotonic()

    def add(self, title, passed, failed, seconds, note=""):
        self._rows.append((title, passed, len(failed), seconds, note))
        self._failures += [(title, name, output) for name, output in failed]

    def tests(self, title, preset, selection):
        """A part that is a selection of ctest's; what was green for the same inputs is not run again."""
        checks = by_check(preset, selection)
        inputs = {check: inputs_of(entries, preset) for check, entries in checks.items()}
        known = {check: self._memory.passed(f"{preset} {check}", inputs[check]) for check in checks}
        due = {check: entries for check, entries in checks.items() if self._again or known[check] is None}
        before = sum(known[check] for check in checks if check not in due)
        outcome = run_tests(preset, selection, title, due) if due else Outcome()
        for check, entries in due.items():
            if all(entry.name in outcome.counts for entry in entries):
                self._memory.remember(f"{preset} {check}", inputs[check], sum(outcome.counts[e.name] for e in entries))
            else:
                self._memory.forget(f"{preset} {check}")
        note = f"{before} of them unchanged since they passed" if before else ""
        self.add(title, before + outcome.passed, outcome.failed, outcome.seconds, note)

    def step(self, title, work):
        """A part that holds or raises CourseError; `work` returns a note."""
        start = time.monotonic()
        failed, note = [], ""
        try:
            note = work() or ""
        except CourseError as error:
            failed = [(title, str(error))]
        self.add(title, 0 if failed else 1, failed, time.monotonic() - start, note)

    def report(self):
        """Prints the failures, the table and the total; returns the exit code."""
        for title, name, output in self._failures:
            say(f"\nFAILED {title}: {name}\n{output.rstrip()}")
        rows = [(title, passed, failed, format_duration(seconds), note)
                for title, passed, failed, seconds, note in self._rows]
        passed = sum(row[1] for row in self._rows)
        failed = sum(row[2] for row in self._rows)
        rows.append(("total", passed, failed, format_duration(time.monotonic() - self.start), ""))
        say("\n" + table(rows, head=["part", "passed", "failed", "time", ""], right=(1, 2, 3)))
        say(f"\n{passed} passed, {failed} failed")
        return 1 if failed or not passed else 0


def numbers(chapters):
    return tuple(chapter[:2] for chapter in chapters)


def run_release(parts, chapters, everything):
    targets = () if everything else (*chapters, *test_programs(chapters))
    parts.step("build", lambda: cmake.build(targets=targets) and None)
    parts.step("headers by themselves", lambda: check_headers(None if everything else numbers(chapters)))
    parts.step("who includes whom", check_order)
    selections = release_selections(chapters, everything)
    if everything:
        parts.step("every test in one part", lambda: check_partition(selections.values()))
    present = {title: selection for title, selection in selections.items() if test_names("release", selection)}
    for title, selection in present.items():
        parts.tests(title, "release", selection)
    if not present:
        raise CourseError(f"chapters {', '.join(chapters)} have no tests")


def release_selections(chapters, everything):
    """The parts that ctest runs, by title. With all chapters they hold every test once, the large ones aside."""
    if not everything:
        return {f"{kind} tests": of_chapters(numbers(chapters), kind) for kind in KINDS}
    selections = {f"{kind} tests": of_kind(kind) for kind in KINDS}
    return {**selections, "tests of the test kit": of_label("support"), "tests of the tools": of_label("course")}


def check_headers(chosen):
    """Checks the headers that these chapters add (None: all)."""
    chapter_of = {name: f"{file['chapter']:02d}" for name, file in declarations()["files"].items() if name.endswith(".h")}
    headers = [name for name, chapter in chapter_of.items() if chosen is None or chapter in chosen]
    targets = sorted({f"headers_{chapter_of[name]}" for name in headers})
    if targets:
        cmake.build(targets=targets, title="headers by themselves")
    return count(len(headers), "header")


def check_order():
    command = [sys.executable, ROOT / "tools" / "chapter_order.py", build_dir()]
    finished = run_program(command, "who includes whom")
    if finished.code != 0:
        raise CourseError(finished.output.strip())
    return finished.output.strip()


def check_partition(selections):
    """No test may be in two parts, none in no part; the large ones are a part of --full."""
    selected = [name for selection in (*selections, of_kind(LARGE)) for name in test_names("release", selection)]
    every = all_test_names("release")
    twice = sorted({name for name in selected if selected.count(name) > 1} |
                   {name for name in every if every.count(name) > 1})
    left_out = sorted(set(every) - set(selected))
    if twice:
        raise CourseError(f"selected twice: {', '.join(twice)}; give each test one label of a kind")
    if left_out:
        raise CourseError(f"selected by no part: {', '.join(left_out)}; give each test a label of a kind")
    return f"{len(every)} ctest entries"


def test_programs(chapters, kinds=KINDS):
    """The targets of the chapters' C++ tests: one a kind that has sources."""
    return [f"{kind}_{chapter[:2]}" for chapter in chapters for kind in kinds
            if any((ROOT / "tests" / chapter).glob(f"{kind}_*.cpp"))]


def run_preset(parts, preset, chapters):
    """The C++ tests of some chapters as another preset builds them; nothing else is built there."""
    parts.step(f"build {preset}", lambda: cmake.build(preset, test_programs(chapters)) and None)
    parts.tests(f"{preset}: C++ tests", preset, of_chapters(numbers(chapters), *KINDS))


def run_full(parts, chapters, args):
    order = numbers(chapters)
    if args.changed:
        changed = changed_chapters()
        say(f"chapters with changed files: {' '.join(changed) or 'none'}")
        order = [number for number in order if number in changed] + [number for number in order if number not in changed]
    large = {program[-2:] for program in test_programs(chapters, (LARGE,))}
    queue = Queue(parts, Memory(), args.again, args.patience, args.limit, parts.start)
    queue.run(full_checks(order, large, everything=not args.chapters))
