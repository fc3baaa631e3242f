"""libFuzzer on the SVG, OBJ, PLY, STL and glTF readers, under the address and undefined-behaviour sanitizers: nothing may be found.

Ten minutes each; --seconds N takes another time, --reader NAME one of them. What is new to a reader joins its corpus, which is committed: the fewest files
that reach all edges of its code. A find is left in build/fuzz/ and its file is named.
"""

import re
import shutil
import subprocess
from collections import namedtuple
from pathlib import Path

from course_lib.benchmarks import end_with, option_parser, save_quantities
from course_lib.errors import CourseError
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, ROOT, shown
from course_lib.terminal import Step, say

HERE = Path(__file__).resolve().parent
FOLDER = BUILD / "fuzz"
CASES = ("each reader of files",)
NEEDS = ("clang", "libclang-rt-dev", "libomp-dev")
Target = namedtuple("Target", "name sources libraries")
MESH = ["mesh/mesh_data.cpp", "mesh/polygon.cpp", "mesh/scalar_type.cpp"]
TARGETS = (
    Target("svg", ["curve/svg_document.cpp", "curve/svg_namespaces.cpp", "curve/svg_path_finder.cpp",
                   "curve/svg_path_data.cpp", "curve/svg_scanner.cpp", "curve/svg_style.cpp", "curve/svg_transform.cpp",
                   "curve/svg_arc.cpp", "curve/bezier_spline.cpp", "curve/bezier_curve.cpp", "curve/bernstein.cpp",
                   "curve/curve_bounds.cpp", "curve/arc_length.cpp", "curve/gauss_legendre.cpp",
                   "curve/profile_limits.cpp"], ["-lpugixml"]),
    Target("obj", ["mesh/obj_file.cpp", *MESH], []),
    Target("ply", ["mesh/ply_file.cpp", "mesh/ply_data.cpp", "mesh/ply_header.cpp", *MESH], []),
    Target("stl", ["mesh/stl_file.cpp", *MESH], []),
    Target("gltf", ["mesh/gltf_file.cpp", "mesh/gltf_accessor.cpp", "mesh/gltf_model.cpp", *MESH],
           [HERE / "tinygltf.cpp", "-DTINYGLTF_NO_STB_IMAGE", "-DTINYGLTF_NO_STB_IMAGE_WRITE"]),
)
CORE = ["core/error.cpp", "core/text.cpp"]
FLAGS = ["-std=c++20", "-O1", "-g", "-ffp-contract=off", "-fsanitize=fuzzer,address,undefined",
         "-fno-sanitize-recover=all", "-isystem", "/usr/include/eigen3"]


def options():
    parser = option_parser("fuzz", __doc__)
    parser.add_argument("--reader", choices=[target.name for target in TARGETS], help="this one alone")
    parser.add_argument("--seconds", type=int, default=600, metavar="N", help="for each reader (600 by default)")
    return parser.parse_args()


def compiled(target):
    executable = FOLDER / f"fuzz_{target.name}"
    sources = [HERE / f"fuzz_{target.name}.cpp", *(ROOT / "common" / name for name in target.sources + CORE)]
    command = ["clang++", *FLAGS, f"-I{ROOT / 'common'}", *sources, *target.libraries, "-o", executable]
    finished = subprocess.run(command, capture_output=True, text=True)
    if finished.returncode != 0:
        raise CourseError(f"fuzz_{target.name}.cpp does not compile: {finished.stderr.strip().splitlines()[0]}")
    return executable


def fuzz(target, seconds):
    """Whether nothing was found."""
    with Step(f"compile the {target.name} reader for libFuzzer"):
        executable = compiled(target)
    corpus = HERE / f"corpus_{target.name}"
    grown = FOLDER / f"corpus_{target.name}"
    grown.mkdir(exist_ok=True)
    log = FOLDER / f"fuzz_{target.name}.log"
    command = [executable, f"-max_total_time={seconds}", "-max_len=16384", "-timeout=20", "-rss_limit_mb=2048",
               f"-artifact_prefix={FOLDER}/", grown, corpus]
    with Step(f"fuzz the {target.name} reader for {seconds} s"), log.open("w") as file:
        code = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT).returncode
    lines = log.read_text(errors="replace").splitlines()
    runs = next((line for line in reversed(lines) if line.startswith("Done ")), "")
    say(f"{target.name}: {runs or 'stopped early'}; the whole log is {shown(log)}")
    if code != 0:
        finds = [line for line in lines if "ERROR" in line or "runtime error" in line or "Test unit written" in line]
        say("\n".join(finds[:5]))
        return False
    keep_fewest(executable, corpus, grown)
    say(f"{target.name}: {len(list(corpus.iterdir()))} files in {shown(corpus)}")
    return True


def keep_fewest(executable, corpus, grown):
    """Puts the files that reach all edges in place of those that earlier runs made; files with a name stay."""
    fewest = FOLDER / f"fewest_{corpus.name}"
    shutil.rmtree(fewest, ignore_errors=True)
    fewest.mkdir()
    merge = [executable, "-set_cover_merge=1", "-use_counters=0", "-max_len=2048", fewest, corpus, grown]
    if subprocess.run(merge, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0:
        raise CourseError(f"{executable.name} can't merge; {shown(corpus)} is as it was")
    for file in corpus.iterdir():
        if re.fullmatch("[0-9a-f]{40}", file.name):
            file.unlink()
    for file in fewest.iterdir():
        shutil.copy(file, corpus)


def main():
    chosen = options()
    if chosen.seconds < 1:
        raise CourseError(f"--seconds {chosen.seconds}: must be at least 1")
    ensure_packages("bench")
    FOLDER.mkdir(parents=True, exist_ok=True)
    targets = [target for target in TARGETS if chosen.reader in (None, target.name)]
    results = [fuzz(target, chosen.seconds) for target in targets]
    save_quantities(chosen.csv, [(f"{target.name} reader", f"libFuzzer, {chosen.seconds} s: ended without a find", int(good), "1", "1")
                                 for target, good in zip(targets, results)])
    return 0 if all(results) else 1


if __name__ == "__main__":
    end_with(main, "fuzz")
