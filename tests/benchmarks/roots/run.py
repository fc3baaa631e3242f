"""Rays at difficult surfaces of revolution and patches, held against brute-force subdivision: what the robust method misses.

10^7 random rays at each kind of surface and a tenth as many of each adversarial set; --rays N takes another number.
Writes figures/03_bezier_surfaces/roots.csv; fails when the robust method loses a meeting, invents one, or is off by
more than 1e-12 of the size. What is counted is kept in build/bench/ after each batch, so that a run that was stopped
goes on where it was.
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

CHAPTER = "03_bezier_surfaces"
RAYS = 10_000_000
BATCH = 10_000  # random rays of a call
SUMMED = ("rays", "meetings", "misses", "falseHits", "raysInBand")
MOST_DISTANCE = 1e-12


def options():
    parser = argparse.ArgumentParser(prog="course bench roots", description=__doc__.partition("\n")[0])
    parser.add_argument("--rays", type=int, default=RAYS, metavar="N",
                        help=f"random rays at each kind of surface; a multiple of {BATCH} ({RAYS} by default)")
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
    """For each batch, whose number is its seed, what --roots prints."""
    executable = hashlib.sha256(program(CHAPTER).read_bytes()).hexdigest()
    notes = BUILD / "bench" / "roots.json"
    batches = counted_before(notes, executable)[:batches_wanted]
    before = len(batches)
    if before:
        say(f"  {before * BATCH} rays were counted before, in {shown(notes)}")
    with Step(f"hold {batches_wanted * BATCH} random rays at each kind of surface against subdivision") as step:
        while len(batches) < batches_wanted:
            command = [program(CHAPTER), "--roots", BATCH, "--seed", len(batches) + 1, "--threads", cores()]
            batches.append(json.loads(output_of(command)))
            replace(notes, json.dumps({"executable": executable, "batches": batches}))
            step.progress(len(batches) - before, batches_wanted - before)
    return batches


def totals(batches):
    """The sum of all batches, entry by entry."""
    sums = batches[0]
    for batch in batches[1:]:
        for total, entry in zip(sums, batch):
            for key in SUMMED:
                total[key] += entry[key]
            total["worstDistance"] = max(total["worstDistance"], entry["worstDistance"])
            for method, found in entry["nearest"].items():
                total["nearest"][method]["failures"] += found["failures"]
                total["nearest"][method]["trials"] += found["trials"]
    return sums


def main():
    chosen = options()
    cmake.build(targets=[CHAPTER])
    sums = totals(counts(chosen.rays // BATCH))

    methods = list(dict.fromkeys(method for entry in sums for method in entry["nearest"]))
    lines = [["surface", "set", "rays", "meetings", "misses", "false_hits", "rays_in_band", "worst_distance"]
             + [f"wrong nearest: {method}" for method in methods]]
    for entry in sums:
        wrong = [entry["nearest"].get(method, {}).get("failures", "") for method in methods]
        lines.append([entry["surface"], entry["set"], *(entry[key] for key in SUMMED), entry["worstDistance"], *wrong])
    file = FIGURES / CHAPTER / "roots.csv"
    replace(file, "".join(",".join(map(str, line)) + "\n" for line in lines))

    bad = 0
    for entry in sums:
        say(f"  {entry['surface']:<11} {entry['set']:<32} {entry['rays']:>10} rays, {entry['misses']} missed, "
            f"{entry['falseHits']} false, {entry['raysInBand']} in the band, off by {entry['worstDistance']:.1e}")
        bad += entry["misses"] + entry["falseHits"] + (entry["worstDistance"] > MOST_DISTANCE)
    say(f"  the table is {shown(file)}; a meeting counts as tangent when the cosine is below 1e-5")
    return 1 if bad else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CourseError as error:
        sys.exit(f"roots: {error}")
