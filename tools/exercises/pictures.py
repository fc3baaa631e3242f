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
MOST_REPORT_TIME = 20  # seconds; a figure that took longer at report quality is drawn as a draft, unless it is asked for
MOST_TIME = 120  # seconds for one figure; MOST_SLOWER times the reference's when that is longer
MOST_SLOWER = 6
# A picture is right when the means of its blocks of 16 x 16 pixels are no further from the reference's than from those of
# the same drawn with other random numbers: root mean squares, of 255, over all blocks.
MOST_NOISE = 1.5  # both are noise of one size then; a few blotches of photons make it rough
MOST_ROUNDING = 0.3
STUB = "is not implemented yet"


@dataclass
class Comparison:
    """What became of one picture or figure."""

    name: str
    result: str  # in words
    path: Path = None  # yours, reference and difference side by side
    wrong: bool = False  # whether it differs from the reference by more than noise


def compare_figures(chapter, in_full=False, root=ROOT):
    """Draws the untimed figures of a chapter and puts each picture beside the reference's, into build/check/NN/.

    Whatever cannot be drawn is said, and stops nothing.
    @param in_full  whether to draw those as well that take long, as the reference's were drawn
    """
    built = build_tree(root, [chapter, COMPARE], f"the figures of {chapter}")
    if built.error:
        return [Comparison(chapter, f"its program does not build: {built.error}")]
    folder = BUILD / "check" / chapter[:2]
    shutil.rmtree(folder, ignore_errors=True)
    names = untimed_figures(chapter, root)
    references = provenance.read(FIGURES / chapter)
    comparisons = []
    with Step(f"draw {chapter}") as step:
        for position, name in enumerate(names, start=1):
            comparisons += Figure(chapter, name, references.get(name, {}), folder, in_full, root).compare()
            step.progress(position, len(names))
    return comparisons


def untimed_figures(chapter, root):
    listed = subprocess.run([str(program(root, chapter)), "--list"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                            text=True, errors="replace")
    return [line.split()[0] for line in listed.stdout.splitlines() if line.strip() and not line.endswith("(timed)")]


class Figure:
    """One figure as the student's chapter draws it."""

    def __init__(self, chapter, name, reference, folder, in_full, root):
        seconds = reference.get("seconds", 0)
        self.chapter, self.name, self.folder, self.root = chapter, name, folder, root
        self.quality = "report" if in_full or seconds < MOST_REPORT_TIME else "draft"
        self.seed = reference.get("seed", 1)
        self.most_time = max(MOST_TIME, MOST_SLOWER * seconds)

    def compare(self):
        why_not = self.draw("drawn", self.seed)
        if why_not:
            return [Comparison(self.name, why_not)]
        files = provenance.read(self.folder / "drawn" / self.chapter).get(self.name, {}).get("files", [])
        return [self.put_side_by_side(file) for file in files if file.endswith(".png")]

    def draw(self, kind, seed):
        """Draws the figure into a folder of this kind; returns why it cannot be drawn."""
        out = self.folder / kind
        out.mkdir(parents=True, exist_ok=True)
        command = [str(program(self.root, self.chapter)), "--out", str(out), "--only", self.name, "--quality", self.quality,
                   "--seed", str(seed)]
        try:
            finished = subprocess.run(command, cwd=out, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, errors="replace", timeout=self.most_time)
        except subprocess.TimeoutExpired:
            return f"was still drawing after {self.most_time:.0f} s"
        return why_not_drawn(finished) if finished.returncode != 0 else ""

    def put_side_by_side(self, file):
        yours, reference = self.folder / "drawn" / self.chapter / file, FIGURES / self.chapter / file
        if not reference.exists():
            return Comparison(file, "drawn; there is no reference picture", yours)
        out = self.folder / file
        out.parent.mkdir(parents=True, exist_ok=True)
        try:
            difference = self.measured(yours, reference, out)
            again = self.folder / "again" / self.chapter / file
            if difference.worst > 0 and self.quality == "report" and (again.exists() or not self.draw("again", self.seed + 1)):
                difference = self.measured(yours, reference, out, again)
        except ValueError as error:
            return Comparison(file, str(error), yours)
        words, wrong = describe(difference, self.quality, self.chapter[:2])
        return Comparison(file, words, out, wrong)

    def measured(self, *paths):
        """@throws ValueError when the pictures cannot be compared"""
        compared = subprocess.run([str(program(self.root, COMPARE)), *map(str, paths)], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace")
        if compared.returncode != 0:
            raise ValueError(compared.stdout.strip() or "cannot be compared")
        return Difference(*map(float, compared.stdout.split()))


def why_not_drawn(finished):
    lines = [line.strip() for line in finished.stdout.splitlines() if line.strip()]
    last = lines[-1] if lines else ""
    if STUB in last:
        return "waits for " + last[last.find("ex-"):last.find(STUB)].strip()
    if finished.returncode < 0:
        return f"its program crashed (signal {-finished.returncode})"
    return f"cannot be drawn: {last or f'exit code {finished.returncode}'}"


@dataclass(frozen=True)
class Difference:
    """What compare_pictures prints."""

    share: float  # of pixels that differ visibly, in percent
    worst: float  # of a pixel's channel, of 255
    blocks: float  # of blocks' means, root mean square, of 255
    noise: float  # the same between two drawings with different random numbers
    block: float  # the largest of a block's mean, of 255
    x: float  # that block's left upper pixel
    y: float


def describe(difference, quality, number):
    """(in words, whether the picture is wrong)."""
    if difference.worst == 0:
        return "the same as the reference", False
    pixels = f"{percent(difference.share)} of the pixels differ"
    if quality == "draft":
        return f"a draft: {pixels}; ./course check {number} --pictures takes longer, and says whether it is right", False
    if difference.blocks <= MOST_NOISE * difference.noise + MOST_ROUNDING:
        return f"right: {pixels}, by {'noise' if difference.noise > 0 else 'rounding'} alone", False
    place = f"around {difference.x:.0f},{difference.y:.0f} by {difference.block:.0f} of 255 on average"
    return f"not right: {pixels}, {place}", True


def percent(share):
    """"0.03 %", "7.1 %", "42 %": two digits, and never 1e+02."""
    if share < 0.005:
        return "less than 0.01 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %"
