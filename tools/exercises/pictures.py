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
STUB = "is not implemented yet"


@dataclass
class Comparison:
    """What became of one picture or figure."""

    name: str
    result: str  # in words
    path: Path = None  # yours, reference and difference side by side


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
    share, worst = (float(word) for word in compared.stdout.split())
    return Comparison(file, describe(share, worst, quality), out)


def describe(share, worst, quality):
    if worst == 0:
        return "the same as the reference"
    as_draft = " (yours is a draft, the reference is not)" if quality == "draft" else ""
    return f"{share:.2g} % of the pixels differ, by up to {worst:.0f} of 255{as_draft}"
