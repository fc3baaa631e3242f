"""Rays aimed at the edges and vertices of random closed meshes, from inside: how many each triangle test lets out.

10^8 rays for each test at edges and as many at vertices, on new meshes every 10,000 rays; --rays N takes another
number. Writes figures/02_intersections/leaks.csv; fails when the watertight test lets one out. What is counted is kept in
build/bench/ after each million, so that a run that was stopped goes on where it was.
"""

import argparse
import hashlib
import json
import os
import sys

from course_lib import cmake
from course_lib.errors import CourseError
from course_lib.paths import BUILD, FIGURES, cores, program, shown
from course_lib.process import output_of
from course_lib.terminal import Step, say

CHAPTER = "02_intersections"
RAYS = 100_000_000
BATCH = 1_000_000  # rays of a call: for each test and aim
ROBUST = "watertight"


def options():
    parser = argparse.ArgumentParser(prog="course bench leaks", description=__doc__.partition("\n")[0])
    parser.add_argument("--rays", type=int, default=RAYS, metavar="N",
                        help=f"for each test at edges and as many at vertices; millions ({RAYS} by default)")
    chosen = parser.parse_args()
    if chosen.rays < BATCH or chosen.rays % BATCH != 0:
        raise CourseError(f"--rays {chosen.rays}: must be a multiple of {BATCH}")
    return chosen


def replace(path, text):
    """Writes a file as a whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    temporary.write_text(text, newline="")
    temporary.replace(path)


def counted_before(notes, executable):
    """The batches that this very executable has counted already."""
    try:
        kept = json.loads(notes.read_text())
    except (FileNotFoundError, json.JSONDecodeError):
        return []
    return kept["batches"] if kept["executable"] == executable else []


def counts(batches_wanted):
    """For each batch, whose number is its seed, what --leaks prints."""
    executable = hashlib.sha256(program(CHAPTER).read_bytes()).hexdigest()
    notes = BUILD / "bench" / "leaks.json"
    batches = counted_before(notes, executable)[:batches_wanted]
    before = len(batches)
    if before:
        say(f"  {before * BATCH:,} rays were counted before, in {shown(notes)}")
    with Step(f"aim {batches_wanted * BATCH:,} rays at edges, and at vertices") as step:
        while len(batches) < batches_wanted:
            command = [program(CHAPTER), "--leaks", BATCH, "--seed", len(batches) + 1, "--threads", cores()]
            batches.append(json.loads(output_of(command)))
            replace(notes, json.dumps({"executable": executable, "batches": batches}))
            step.progress(len(batches) - before, batches_wanted - before)
    return batches


def totals(batches):
    """(method, aim) -> [leaks, rays], in the order in which the methods come."""
    sums = {}
    for batch in batches:
        for entry in batch:
            total = sums.setdefault((entry["method"], entry["aim"]), [0, 0])
            total[0] += entry["leaks"]
            total[1] += entry["rays"]
    return sums


def main():
    chosen = options()
    cmake.build(targets=[CHAPTER])
    sums = totals(counts(chosen.rays // BATCH))

    file = FIGURES / CHAPTER / "leaks.csv"
    lines = [["method", "case", "failures", "trials"]]
    lines += [[method, f"closed mesh: rays at {aim}", *total] for (method, aim), total in sums.items()]
    rows = "".join(",".join(map(str, line)) + "\n" for line in lines)
    replace(file, rows)
    for (method, aim), (leaks, rays) in sums.items():
        say(f"  {method:<32} {aim:<9} {leaks:>11,} of {rays:,} leak")
    say(f"  the table is {shown(file)}")
    return 1 if any(leaks for (method, _), (leaks, _) in sums.items() if method == ROBUST) else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CourseError as error:
        sys.exit(f"leaks: {error}")
