"""The peers' box, ten seconds of one thread for each method of chapters 07 and 09: errors and paths a second.

Error is the root mean square over linear RGB against a long converged picture, pixels within 2 of the lamp left out; time is
the thread's own. Fails when path tracing with MIS, bidirectional path tracing or SPPM by rule ① is further off than it
should be.
"""

import csv

from course_lib import cmake
from course_lib.benchmarks import end_with, option_parser, save_quantities, save_table
from course_lib.errors import CourseError
from course_lib.paths import BUILD, FIGURES, program
from course_lib.process import run_visibly
from course_lib.terminal import say

TABLE = FIGURES / "07_path_tracing" / "transport.csv"
# How each chapter is asked, and what it calls its passes.
CHAPTERS = {"07_path_tracing": (["--scene", "peers_box"], "samples"), "09_sppm": (["--errors", "peers_box"], "passes")}
CASES = ("the peers' box",)
NEEDS = ()
SECONDS = 10.0
PIXELS = 256 * 256
# What it should be after ten seconds, and what others had: SmallVCM's path tracing, bidirectional path tracing and vertex
# connection and merging; pbrt-v3's SPPM had the same.
TARGETS = {"path tracing with MIS": (0.09, 0.103), "bidirectional path tracing": (0.05, 0.059),
           "SPPM by pass ①": (0.0125, 0.047)}


def options():
    parser = option_parser("transport", __doc__, TABLE)
    parser.add_argument("--seconds", type=float, default=SECONDS, metavar="S",
                        help=f"for each method ({SECONDS:g} by default; targets hold for that)")
    chosen = parser.parse_args()
    if not chosen.seconds > 0:
        raise CourseError(f"--seconds {chosen.seconds}: must be greater than 0")
    return chosen


def last_rows(path):
    """The last row of each method: what it had when its time was over."""
    with path.open(newline="") as file:
        return {row["method"]: row for row in csv.DictReader(file)}


def main():
    chosen = options()
    cmake.build(targets=list(CHAPTERS))
    out = BUILD / "bench"
    lines = [["method", "seconds", "samples_per_pixel", "samples_per_second", "error", "error_unit", "target", "peer"]]
    missed = []
    for chapter, (arguments, passes) in CHAPTERS.items():
        code = run_visibly([program(chapter), "--out", out, "--time", chosen.seconds, *arguments])
        if code != 0:
            raise CourseError(f"{chapter} stopped with exit code {code}; its own message stands above")
        for method, row in last_rows(out / chapter / "timed_peers_box.csv").items():
            seconds, samples, error = float(row["time"]), int(row[passes]), float(row["error"])
            target, peer = TARGETS.get(method, ("", ""))
            lines.append([method, seconds, samples, f"{samples * PIXELS / seconds:.0f}", error, row["error_unit"], target,
                          peer])
            if target and chosen.seconds == SECONDS:
                say(f"  {method}: {error:.4f}, to be at most {target}; others elsewhere {peer}")
                missed += [method] if error > target else []
    save_table(chosen.table, lines)
    case = f"the peers' box, {chosen.seconds:g} s of one thread"
    save_quantities(chosen.csv, [
        row for method, seconds, _, rate, error, unit, _, _ in lines[1:]
        for row in ((method, f"{case}: error", error, unit, "a long converged picture"),
                    (method, f"{case}: rate", rate, "paths per second", ""))])
    return 1 if missed else 0


if __name__ == "__main__":
    end_with(main, "transport")
