"""The photon tree of chapter 08 beside nanoflann: building, k nearest, fixed radius.

Photons of the peers' box, and as many points in a cube. The three take turns in one process and one thread, and medians
count. Fails when a k-th distance differs from nanoflann's.
"""

import csv
import subprocess

from course_lib import cmake
from course_lib.benchmarks import end_with, option_parser, save_quantities
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import FIGURES, build_dir, shown
from course_lib.terminal import say

TABLE = FIGURES / "08_photon_mapping" / "points.csv"
CASES = ("photons of the peers' box", "points in a cube")
NEEDS = ("libnanoflann-dev",)


def options():
    parser = option_parser("points", __doc__, TABLE)
    parser.add_argument("--photons", type=int, default=100_000, metavar="N",
                        help="photons that set out; about three times as many points (100,000 by default)")
    parser.add_argument("--rounds", type=int, default=15, metavar="N", help="the median of N counts (15 by default)")
    return parser.parse_args()


def main():
    chosen = options()
    if chosen.photons < 100 or chosen.rounds < 1:
        raise CourseError("--photons must be at least 100, --rounds at least 1")
    ensure_packages("bench")
    cmake.build("native", targets=["bench_points"])
    chosen.table.parent.mkdir(parents=True, exist_ok=True)
    finished = subprocess.run([build_dir("native") / "bin" / "bench_points", chosen.table, str(chosen.photons), str(chosen.rounds)])
    if finished.returncode != 0:
        raise CourseError("bench_points stopped; its own message stands above")
    with chosen.table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    save_quantities(chosen.csv, [
        ("photon tree", f"{row['points']}: {row['what']}", row["ratio_float"], "times as fast", "nanoflann in float")
        for row in rows])
    queries = [float(row["ratio_float"]) for row in rows if row["what"] != "build"]
    builds = [float(row["ratio_float"]) for row in rows if row["what"] == "build"]
    different = sum(int(row["differences"]) for row in rows)
    say(f"queries at least {min(queries):.2f} times as fast as nanoflann's, builds {min(builds):.2f}; {different} distances "
        f"differ; all ratios are in {shown(chosen.table)}")
    return 1 if different else 0


if __name__ == "__main__":
    end_with(main, "points")
