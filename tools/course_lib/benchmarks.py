"""What the benchmarks in tests/benchmarks/ share: whole tables, counts that go on where they stopped, errors of one line.

A run.py says of itself, beside its docstring: CASES, what it measures on, and NEEDS, Debian packages besides those of the build.
"""

import argparse
import csv
import hashlib
import io
import json
import os
import sys
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import BUILD, cores, program, shown
from course_lib.process import output_of
from course_lib.terminal import Step, say

QUANTITY = ("method", "case", "value", "unit", "reference")  # the columns of quantity.csv


def replace(path, text):
    """Writes a file as a whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    temporary.write_text(text, newline="")
    temporary.replace(path)


def save_table(path, rows):
    """Writes rows, the names of the columns first, as a CSV file, and says where it is."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    replace(path, text.getvalue())
    say(f"  the table is {shown(path)}")


def option_parser(name, text, kept=None):
    """The options that every benchmark takes; text: its docstring.

    @param kept  the table that the repository keeps, if there is one: chosen.table is a file in build/bench/ unless --record
                 says that the run shall take its place, so that a trial, a short run above all, changes nothing kept
    """
    parser = argparse.ArgumentParser(prog=f"course bench {name}", description=text.partition("\n")[0])
    parser.add_argument("--csv", type=Path, metavar="FILE", help=f"what was measured, as rows of {', '.join(QUANTITY)}")
    if kept is not None:
        trial = BUILD / "bench" / kept.name
        parser.add_argument("--record", dest="table", action="store_const", const=kept, default=trial,
                            help=f"write {shown(kept)}, which the repository keeps, instead of {shown(trial)}")
    return parser


def save_quantities(path, rows):
    """Writes rows of method, case, value, unit, reference to the file of --csv, if there is one."""
    if path is not None:
        save_table(path, [QUANTITY, *rows])


def multiple_of(batch, rays):
    if rays < batch or rays % batch != 0:
        raise CourseError(f"--rays {rays}: must be a multiple of {batch}")
    return rays


def counted_before(notes, executable):
    """The batches that this very executable has counted already."""
    try:
        kept = json.loads(notes.read_text())
    except (FileNotFoundError, json.JSONDecodeError):
        return []
    return kept["batches"] if kept["executable"] == executable else []


def count_in_batches(chapter, option, batch, rays, doing):
    """For each batch, whose number is its seed, what the chapter's command `option` prints as JSON.

    Kept in build/bench/ after each batch, so that a run that was stopped goes on where it was.
    """
    executable = hashlib.sha256(program(chapter).read_bytes()).hexdigest()
    notes = BUILD / "bench" / f"{option.strip('-')}.json"
    wanted = rays // batch
    batches = counted_before(notes, executable)[:wanted]
    before = len(batches)
    if before:
        say(f"  {before * batch:,} rays were counted before, in {shown(notes)}")
    with Step(doing) as step:
        while len(batches) < wanted:
            command = [program(chapter), option, batch, "--seed", len(batches) + 1, "--threads", cores()]
            batches.append(json.loads(output_of(command)))
            replace(notes, json.dumps({"executable": executable, "batches": batches}))
            step.progress(len(batches) - before, wanted - before)
    return batches


def end_with(main, name):
    """Ends the process with what main() returns, or with the line of its error."""
    try:
        sys.exit(main())
    except CourseError as error:
        sys.exit(f"{name}: {error}")
