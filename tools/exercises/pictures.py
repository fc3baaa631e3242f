"""Draws what a student's chapter can draw already, beside the reference's pictures."""

import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from course_lib import provenance
from course_lib.paths import BUILD, FIGURES, ROOT
from course_lib.terminal import Step
from exercises.building import build_tree, program

COMPARE = "compare_pictures"
MOST_REPORT_TIME = 20  # seconds; a figure that took longer at report quality is drawn as a draft
MOST_TIME = 120  # seconds for one figure
# How far the mean of 16 x 16 pixels may be from the reference's, of 255.
MOST_BLOCK = {"report": 2, "draft": 12}
STUB = "is not implemented yet"


@dataclass
class Comparison:
    """What became of one picture or figure."""

    name: str
    result: str  # in words
    path: Path = None  # yours, reference and difference side by side
    wrong: bool = False  # whether it differs from the reference by more than noise


def compare_figures(chapter, root=ROOT):
    """Draws the untimed figures of a chapter and puts each picture beside the reference's, into build/check/NN/.

    Whatever cannot be drawn is said, and stops nothing.
    """
    built = build_tree(root, [chapter, COMPARE], f"the figures of {chapter}")
    if built.error:
        return [Comparison(chapter, f"its program does not build: {built.error}")]
    folder = BUILD / "check" / chapter[:2]
    shutil.rmtree(folder, ignore_errors=True)
    drawn = folder / "drawn"
    drawn.mkdir(parents=True)
    names = untimed_figures(chapter, root)
    references = provenance.read(FIGURES / chapter)
    comparisons = []
    with Step(f"draw {chapter}") as step:
        for position, name in enumerate(names, start=1):
            comparisons += compare_figure(chapter, name, references.get(name, {}), drawn, root)
            step.progress(position, len(names))
    return comparisons


def untimed_figures(chapter, root):
    listed = subprocess.run([str(program(root, chapter)), "--list"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                            text=True, errors="replace")
    return [line.split()[0] for line in listed.stdout.splitlines() if line.strip() and not line.endswith("(timed)")]


def compare_figure(chapter, name, reference, drawn, root):
    quality = "report" if reference.get("seconds", MOST_REPORT_TIME) < MOST_REPORT_TIME else "draft"
    command = [str(program(root, chapter)), "--out", str(drawn), "--only", name, "--quality", quality,
               "--seed", str(reference.get("seed", 1))]
    try:
        finished = subprocess.run(command, cwd=drawn, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace", timeout=MOST_TIME)
    except subprocess.TimeoutExpired:
        return [Comparison(name, f"was still drawing after {MOST_TIME} s")]
    if finished.returncode != 0:
        return [Comparison(name, why_not_drawn(finished))]
    files = provenance.read(drawn / chapter).get(name, {}).get("files", [])
    return [put_side_by_side(chapter, file, quality, drawn, root) for file in files if file.endswith(".png")]


def why_not_drawn(finished):
    lines = [line.strip() for line in finished.stdout.splitlines() if line.strip()]
    last = lines[-1] if lines else ""
    if STUB in last:
        return "waits for " + last[last.find("ex-"):last.find(STUB)].strip()
    if finished.returncode < 0:
        return f"its program crashed (signal {-finished.returncode})"
    return f"cannot be drawn: {last or f'exit code {finished.returncode}'}"


def put_side_by_side(chapter, file, quality, drawn, root):
    yours, reference = drawn / chapter / file, FIGURES / chapter / file
    if not reference.exists():
        return Comparison(file, "drawn; there is no reference picture", yours)
    out = drawn.parent / file
    out.parent.mkdir(parents=True, exist_ok=True)
    compared = subprocess.run([str(program(root, COMPARE)), str(yours), str(reference), str(out)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if compared.returncode != 0:
        return Comparison(file, compared.stdout.strip() or "cannot be compared", yours)
    words, wrong = describe(Difference(*map(float, compared.stdout.split())), quality)
    return Comparison(file, words, out, wrong)


@dataclass(frozen=True)
class Difference:
    """What compare_pictures prints."""

    share: float  # of pixels that differ visibly, in percent
    worst: float  # of a pixel's channel, of 255
    block: float  # of a block's mean, of 255
    x: float  # that block's left upper pixel
    y: float


def describe(difference, quality):
    """(in words, whether the picture is wrong). Noise has no place of its own: it goes when a block's mean is taken."""
    if difference.worst == 0:
        return "the same as the reference", False
    pixels = f"{percent(difference.share)} of the pixels differ"
    if difference.block <= MOST_BLOCK[quality]:
        return f"right: {pixels}, by {'the noise of a draft' if quality == 'draft' else 'noise'} alone", False
    return (f"not right: {pixels}, around {difference.x:.0f},{difference.y:.0f} "
            f"by {difference.block:.0f} of 255 on average", True)


def percent(share):
    """"0.03 %", "7.1 %", "42 %": two digits, and never 1e+02."""
    if share < 0.005:
        return "less than 0.01 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %"
