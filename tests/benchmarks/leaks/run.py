"""Rays aimed at the edges and vertices of random closed meshes, from inside: how many each triangle test lets out.

10^8 rays for each test at edges and as many at vertices, on new meshes every 10,000 rays; --rays N takes another
number. Fails when the watertight test lets one out. What is counted is kept in build/bench/ after each million, so that
a run that was stopped goes on where it was.
"""

from course_lib import cmake
from course_lib.benchmarks import count_in_batches, end_with, multiple_of, option_parser, save_quantities, save_table
from course_lib.paths import FIGURES
from course_lib.terminal import say

CHAPTER = "02_intersections"
TABLE = FIGURES / CHAPTER / "leaks.csv"
CASES = ("closed mesh: rays at edges", "closed mesh: rays at vertices")
NEEDS = ()
RAYS = 100_000_000
BATCH = 1_000_000  # rays of a call: for each test and aim
ROBUST = "watertight"


def options():
    parser = option_parser("leaks", __doc__, TABLE)
    parser.add_argument("--rays", type=int, default=RAYS, metavar="N",
                        help=f"for each test at edges and as many at vertices; millions ({RAYS} by default)")
    chosen = parser.parse_args()
    chosen.rays = multiple_of(BATCH, chosen.rays)
    return chosen


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
    rays = chosen.rays
    cmake.build(targets=[CHAPTER])
    sums = totals(count_in_batches(CHAPTER, "--leaks", BATCH, rays, f"aim {rays:,} rays at edges, and at vertices"))

    lines = [["method", "case", "failures", "trials"]]
    lines += [[method, f"closed mesh: rays at {aim}", *total] for (method, aim), total in sums.items()]
    for (method, aim), (leaks, rays) in sums.items():
        say(f"  {method:<32} {aim:<9} {leaks:>11,} of {rays:,} leak")
    save_table(chosen.table, lines)
    save_quantities(chosen.csv, [(method, case, leaks, f"leaks of {rays} rays", "a closed mesh lets none out")
                                 for method, case, leaks, rays in lines[1:]])
    return 1 if any(leaks for (method, _), (leaks, _) in sums.items() if method == ROBUST) else 0


if __name__ == "__main__":
    end_with(main, "leaks")
