"""Rays at difficult surfaces of revolution and patches, held against brute-force subdivision: what the robust method misses.

10^7 random rays at each kind of surface and a tenth as many of each adversarial set; --rays N takes another number.
Fails when the robust method loses a meeting, invents one, or is off by more than 1e-12 of the size. What is counted is
kept in build/bench/ after each batch, so that a run that was stopped goes on where it was.
"""

from course_lib import cmake
from course_lib.benchmarks import count_in_batches, end_with, multiple_of, option_parser, save_quantities, save_table
from course_lib.paths import FIGURES
from course_lib.terminal import say

CHAPTER = "03_bezier_surfaces"
TABLE = FIGURES / CHAPTER / "roots.csv"
CASES = ("random and adversarial rays at surfaces of revolution and patches",)
NEEDS = ()
RAYS = 10_000_000
BATCH = 10_000  # random rays of a call
SUMMED = ("rays", "meetings", "misses", "falseHits", "raysInBand")
MOST_DISTANCE = 1e-12


def options():
    parser = option_parser("roots", __doc__, TABLE)
    parser.add_argument("--rays", type=int, default=RAYS, metavar="N",
                        help=f"random rays at each kind of surface; a multiple of {BATCH} ({RAYS} by default)")
    chosen = parser.parse_args()
    chosen.rays = multiple_of(BATCH, chosen.rays)
    return chosen


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
    rays = chosen.rays
    cmake.build(targets=[CHAPTER])
    sums = totals(count_in_batches(CHAPTER, "--roots", BATCH, rays,
                                   f"hold {rays:,} random rays at each kind of surface against subdivision"))

    methods = list(dict.fromkeys(method for entry in sums for method in entry["nearest"]))
    lines = [["surface", "set", "rays", "meetings", "misses", "false_hits", "rays_in_band", "worst_distance"]
             + [f"wrong nearest: {method}" for method in methods]]
    for entry in sums:
        wrong = [entry["nearest"].get(method, {}).get("failures", "") for method in methods]
        lines.append([entry["surface"], entry["set"], *(entry[key] for key in SUMMED), entry["worstDistance"], *wrong])
    save_table(chosen.table, lines)
    save_quantities(chosen.csv, [
        ("robust", f"{entry['surface']}, {entry['set']}: {what}", entry[key], unit, "brute-force subdivision")
        for entry in sums for what, key, unit in (("missed", "misses", f"of {entry['meetings']} meetings"),
                                                  ("invented", "falseHits", f"of {entry['meetings']} meetings"),
                                                  ("off by at most", "worstDistance", "of the size"))])

    bad = 0
    for entry in sums:
        say(f"  {entry['surface']:<11} {entry['set']:<32} {entry['rays']:>10} rays, {entry['misses']} missed, "
            f"{entry['falseHits']} false, {entry['raysInBand']} in the band, off by {entry['worstDistance']:.1e}")
        bad += entry["misses"] + entry["falseHits"] + (entry["worstDistance"] > MOST_DISTANCE)
    say("  a meeting counts as tangent when the cosine is below 1e-5")
    return 1 if bad else 0


if __name__ == "__main__":
    end_with(main, "roots")
