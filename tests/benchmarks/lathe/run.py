"""The same vase by us and by POV-Ray's lathe: time a test, and where the two pictures differ.

Both cast one ray a pixel from the same eye, on one thread, taking turns; the best of several runs counts. Of POV-Ray's time what a
cylinder in the lathe's place takes is subtracted: rays, textures and output. The difference of the heights that were hit is build/bench/lathe.pgm.
"""

import json
import re
import subprocess
import tempfile
from pathlib import Path

from course_lib import cmake
from course_lib.benchmarks import end_with, option_parser, save_quantities, save_table
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, FIGURES, program, shown
from course_lib.process import output_of
from course_lib.terminal import Step, say

CHAPTER = "03_bezier_surfaces"
TABLE = FIGURES / CHAPTER / "lathe.csv"
CASES = ("a vase seen from outside",)
NEEDS = ("povray",)
WIDTH = 600
ROUNDS = 5
HEIGHT = 2  # of the vase: white in the picture
SAME = 1e-3  # a pixel differs when the heights hit are farther apart than that

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 1 }}
camera {{ perspective location <{eye}> direction <{forward}> right <{right}> up <{up}> }}
background {{ rgb <0, 0, 0> }}
{object} {{ {shape}
  pigment {{ gradient y color_map {{ [0 rgb <0, 0, 1>] [1 rgb <1, 0, 1>] }} scale {scale} }}
  finish {{ emission 1 ambient 0 diffuse 0 }} }}
"""


def options():
    parser = option_parser("lathe", __doc__, TABLE)
    parser.add_argument("--width", type=int, default=WIDTH, metavar="N", help=f"of the picture ({WIDTH} by default)")
    chosen = parser.parse_args()
    if not 16 <= chosen.width <= 2048:
        raise CourseError(f"--width {chosen.width}: must be 16 to 2048")
    return chosen


def vector(numbers):
    return ", ".join(repr(float(number)) for number in numbers)


def scene(ours, kind):
    points = ", ".join(f"<{vector(point)}>" for point in ours["profile"])
    shape = {"lathe": f"bezier_spline {len(ours['profile'])}, {points}", "cylinder": "<0, 0, 0>, <0, 2, 0>, 0.6"}[kind]
    # A gradient repeats from 1 on: twice the height keeps the rim below that.
    return SCENE.format(eye=vector(ours["eye"]), forward=vector(ours["forward"]), right=vector(ours["right"]),
                        up=vector(ours["up"]), object=kind, shape=shape, scale=2 * HEIGHT)


def povray(folder, kind, width, picture):
    """CPU seconds of tracing, and tests of the shape."""
    output = [f"+O{folder / picture}", "+FP16", "File_Gamma=1.0"] if picture else ["-F"]
    command = ["povray", f"+I{folder / (kind + '.pov')}", f"+W{width}", f"+H{width}", "-A", "-D", "+WT1", "-J", *output]
    finished = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    seconds = re.search(r"Trace Time:.*?with\s+([0-9.]+) CPU-seconds", finished.stdout, re.DOTALL)
    tests = re.search(rf"^{kind.capitalize()}(?:/Cylinder)?\s+(\d+)\s+\d+", finished.stdout, re.MULTILINE)
    if finished.returncode != 0 or not seconds:
        raise CourseError("povray says: " + finished.stdout.strip().splitlines()[-1])
    return float(seconds.group(1)), int(tests.group(1)) if tests else 0


def heights_of(file, width):
    """The heights in a 16-bit PPM picture; None where there is no blue: nothing was hit."""
    data = file.read_bytes()
    match = re.match(rb"P6\s+(\d+)\s+(\d+)\s+65535\s", re.sub(rb"#[^\n]*\n", b"", data[:200]))
    if not match or int(match.group(1)) != width:
        raise CourseError(f"{file}: not the picture that was asked for")
    pixels = data[-6 * width * width:]
    heights = []
    for at in range(0, len(pixels), 6):
        red = int.from_bytes(pixels[at:at + 2], "big")
        hit = int.from_bytes(pixels[at + 4:at + 6], "big") > 32767
        heights.append(red / 65535 * 2 * HEIGHT if hit else None)
    return heights


def difference(ours, theirs, width):
    """Pixels that only one of the two hits, pixels whose heights differ, and a picture of both."""
    only, apart, picture = 0, 0, bytearray()
    for a, b in zip(ours, theirs):
        if (a is None) != (b is None):
            only += 1
            picture.append(255)
        elif a is not None and abs(a - b) > SAME:
            apart += 1
            picture.append(160)
        else:
            picture.append(40 if a is not None else 0)
    file = BUILD / "bench" / "lathe.pgm"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(b"P5 %d %d 255\n" % (width, width) + picture)
    return only, apart, file


def main():
    chosen = options()
    ensure_packages("bench")
    cmake.build(targets=[CHAPTER])
    ours_best, lathe_best, cylinder_best = [], [], []
    with tempfile.TemporaryDirectory() as name, Step(f"intersect {chosen.width}^2 rays, {ROUNDS} times each") as step:
        folder = Path(name)
        for done in range(ROUNDS):
            ours = json.loads(output_of([program(CHAPTER), "--lathe", chosen.width]))
            for kind in ("lathe", "cylinder"):
                (folder / f"{kind}.pov").write_text(scene(ours, kind))
            ours_best.append((ours["nanosecondsPerTest"], ours["nanosecondsPerRay"]))
            lathe_best.append(povray(folder, "lathe", chosen.width, None))
            cylinder_best.append(povray(folder, "cylinder", chosen.width, None))
            step.progress(done + 1, ROUNDS)
        povray(folder, "lathe", chosen.width, "lathe.ppm")
        theirs = heights_of(folder / "lathe.ppm", chosen.width)

    only, apart, picture = difference(ours["heights"], theirs, chosen.width)
    rays = chosen.width * chosen.width
    seconds = min(lathe_best)[0] - min(cylinder_best)[0]
    tests = lathe_best[0][1] or ours["tests"]
    rows = [["method", "ns_per_test", "tests", "ns_per_ray", "rays"],
            ["robust", *(f"{value:.1f}" for value in (min(ours_best)[0],)), ours["tests"], f"{min(ours_best)[1]:.1f}", rays],
            ["POV-Ray lathe", f"{1e9 * seconds / tests:.1f}", tests, f"{1e9 * seconds / rays:.1f}", rays]]
    say(f"  ours {rows[1][1]} ns a test ({rows[1][3]} a ray), POV-Ray {rows[2][1]} ns a test ({rows[2][3]} a ray): "
        f"{float(rows[2][1]) / float(rows[1][1]):.2f} times as fast a test")
    say(f"  of {rays} pixels {only} are hit by one of the two alone, {apart} more than {SAME} apart in height: "
        f"{shown(picture)}")
    save_table(chosen.table, rows)
    save_quantities(chosen.csv, [
        *((row[0], "vase: a test of the shape", row[1], "ns", "POV-Ray") for row in rows[1:]),
        *((row[0], "vase: a ray", row[3], "ns", "POV-Ray") for row in rows[1:]),
        ("robust", "vase: hit by one of the two alone", only, f"of {rays} pixels", "POV-Ray"),
        ("robust", f"vase: heights more than {SAME} apart", apart, f"of {rays} pixels", "POV-Ray")])
    return 0


if __name__ == "__main__":
    end_with(main, "lathe")
