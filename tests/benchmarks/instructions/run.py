"""Instructions a path of chapter 07's methods, in five scenes each of which needs something more than the one before.

Counted by valgrind's cachegrind, as the difference of two runs with more and with fewer paths, so that what a program takes to
start isn't in it.
"""

import re
import shutil
import subprocess

from course_lib import cmake
from course_lib.benchmarks import QUANTITY, end_with, option_parser, save_quantities, save_table
from course_lib.errors import CourseError
from course_lib.paths import FIGURES, program
from course_lib.terminal import Step, say, table

CHAPTER = "07_path_tracing"
TABLE = FIGURES / CHAPTER / "instructions.csv"
SCENES = ("point lamp", "area lamp", "mirror", "glass", "absorption and textures")
CASES = ("path tracing, light tracing and bidirectional path tracing in five scenes",)
NEEDS = ("valgrind",)
METHODS = {2: "path tracing with MIS", 3: "light tracing", 4: "bidirectional path tracing"}
FEW, MANY = 1, 9  # paths a pixel
PIXELS = 32 * 32


def instructions(scene, method, samples):
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null", program(CHAPTER),
               "--trace", scene, "--method", method, "--samples", samples]
    finished = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    found = re.search(r"I\s+refs:\s+([\d,]+)", finished.stderr)
    if finished.returncode != 0 or not found:
        raise CourseError(f"valgrind can't count: {finished.stderr.strip().splitlines()[-1]}")
    return int(found[1].replace(",", ""))


def main():
    chosen = option_parser("instructions", __doc__, TABLE).parse_args()
    if shutil.which("valgrind") is None:
        raise CourseError("valgrind is missing, which counts the instructions; install Debian's package valgrind")
    cmake.build(targets=[CHAPTER])
    rows = []
    with Step("count instructions") as step:
        for scene, needs in enumerate(SCENES):
            for method, name in METHODS.items():
                more = instructions(scene, method, MANY) - instructions(scene, method, FEW)
                rows.append((name, f"up to {needs}", round(more / ((MANY - FEW) * PIXELS))))
                step.progress(len(rows), len(SCENES) * len(METHODS))
    say(table((f"{name}, {case}", str(value)) for name, case, value in rows))
    rows = [(*row, "instructions per path", "counted by cachegrind") for row in rows]
    save_table(chosen.table, [QUANTITY, *rows])
    save_quantities(chosen.csv, rows)
    return 0


if __name__ == "__main__":
    end_with(main, "instructions")
