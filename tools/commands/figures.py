"""Builds, runs the chapters and regenerates their figures.

At report quality (the default) they go to figures/, as drafts to build/figures/. A figure is drawn again only when its
inputs changed: sources, assets, seed, quality. Both the provenance.json beside the figures says.

A chapter is drawn as soon as it is built, while others still wait to be. Where its committed figures are up to date, that is a
draft: what this machine makes of it. build/figures/index.html shows all figures. --report makes one page of the committed
ones, with their data and what made them, and prints it as PDF where Chromium is installed.
"""

import re
import shutil
import webbrowser

from course_lib import cmake, figure_report, provenance
from course_lib.chapters import add_chapters_argument, all_chapters, choose_chapters
from course_lib.compare import Tolerances, compare_pictures, compare_tables
from course_lib.errors import CourseError
from course_lib.gallery import write_page
from course_lib.packages import ensure_packages
from course_lib.paths import BUILD, DRAFT_FIGURES, FIGURES, ROOT, declarations, program, shown
from course_lib.process import output_of, run_visibly
from course_lib.provenance import CurrentInputs, Wanted
from course_lib.terminal import count, say

HELP = "regenerate the figures"
CHECK_FOLDER = BUILD / "check"


def add_arguments(parser):
    add_chapters_argument(parser)
    parser.add_argument("--quality", choices=("draft", "report"), default="report",
                        help="draft (minutes, to build/figures/) or report (the default, to figures/)")
    parser.add_argument("--only", action="append", default=[], metavar="FIG", help="this figure only; may be given again")
    parser.add_argument("--force", action="store_true", help="draw what is up to date as well")
    parser.add_argument("--open", action="store_true", help="show the page of all figures in your browser")
    parser.add_argument("--threads", type=int, metavar="N", help="threads; pictures don't depend on it")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="seed of all random numbers (default: 1)")
    parser.add_argument("--check", action="store_true",
                        help="draw nothing; name stale figures, then compare the numbers of a draft with the committed ones")
    parser.add_argument("--report", action="store_true",
                        help="draw nothing; write all committed figures with their data and provenance to build/report/")
    parser.add_argument("--full", action="store_true", help="with --check: draw again at report quality, compare pictures")


def run(args):
    if args.full and not args.check:
        raise CourseError("--full belongs to --check; run ./course figures --check --full")
    chapters = choose_chapters(args.chapters)
    if args.report:
        return figure_report.write(chapters, args)
    if args.only:
        require_known(args.only, {chapter: spelled_figures(chapter) for chapter in chapters})
    ensure_packages("build")
    if args.check:
        cmake.build(targets=[*chapters, "preview"], title="build the chapters")
        return check({chapter: table_of_contents(chapter) for chapter in chapters}, args)
    for chapter in chapters:
        cmake.build(targets=[chapter], title=f"build {chapter}")
        draw_chapter(chapter, table_of_contents(chapter), args)
        page = write_page(all_chapters(), is_current)
        if chapter == chapters[0] and len(chapters) > 1:
            say(f"The first figures are on {shown(page)}; it grows")
    cmake.build(targets=["preview"], title="build the viewer of --preview")
    say(f"All figures: {shown(page)}")
    if args.open:
        webbrowser.open(page.as_uri())
    return 0


def spelled_figures(chapter):
    """The names of a chapter's figures as its main.cpp has them, a row each: known before anything is built."""
    return re.findall(r'^ *\{"(\w+)",', (ROOT / "chapters" / chapter / "main.cpp").read_text(), re.MULTILINE)


def is_current(chapter):
    """Whether all committed figures of a chapter are what its sources make."""
    current, folder = CurrentInputs.of(chapter, declarations()), FIGURES / chapter
    entries = provenance.read(folder)
    return bool(entries) and not any(provenance.stale_reasons(entry, current, folder) for entry in entries.values())


def table_of_contents(chapter):
    """The figures of a chapter, in order: name -> whether it shows measured times."""
    lines = output_of([program(chapter), "--list"]).splitlines()
    return {line.split()[0]: line.endswith("(timed)") for line in lines if line}


def require_known(only, tables):
    known = [name for table in tables.values() for name in table]
    for name in only:
        if name not in known:
            raise CourseError(f"--only {name}: there is no such figure; there are {', '.join(known)}")


def chosen(table, only):
    return [name for name in table if not only or name in only]


def draw_chapter(chapter, table, args):
    """Draws what is stale of a chapter's figures; where nothing is at report quality, a draft of them."""
    names = chosen(table, args.only)
    if draw_stale(chapter, table, names, args.quality, args) or args.quality == "draft":
        return
    draw_stale(chapter, table, names, "draft", args)


def draw_stale(chapter, table, names, quality, args):
    """Draws what is stale of these figures and returns its names."""
    out = FIGURES if quality == "report" else DRAFT_FIGURES
    folder = out / chapter
    for file in provenance.prune(folder, table):
        say(f"{chapter}: {file} belongs to no figure any more and is removed")
    current = CurrentInputs.of(chapter, declarations())
    entries = provenance.read(folder)
    wanted = Wanted(quality, args.seed)
    stale = [name for name in names
             if args.force or provenance.stale_reasons(entries.get(name), current, folder, wanted)]
    if stale:
        say(f"{chapter}: drawing {len(stale)} of {count(len(names), 'figure')} to {shown(folder)}/")
        run_chapter(chapter, out, stale, quality, args.seed, args.threads)
    else:
        say(f"{chapter}: {count(len(names), 'figure')} up to date in {shown(folder)}/ (--force draws them again)")
    return stale


def run_chapter(chapter, out, names, quality, seed, threads=None):
    command = [program(chapter), "--out", out, "--quality", quality, "--seed", seed]
    command += ["--threads", threads] if threads else []
    command += [word for name in names for word in ("--only", name)]
    code = run_visibly(command)
    if code != 0:
        raise CourseError(f"chapter {chapter} stopped with exit code {code}; its own message stands above")


def check(tables, args):
    """Whether the committed figures are what the sources make: by hash, then by the numbers, then by the pictures."""
    stale = [line for chapter, table in tables.items() for line in stale_figures(chapter, table, args.only)]
    for line in stale:
        say(f"stale: {line}")
    if stale:
        raise CourseError(f"{count(len(stale), 'figure')} stale ({stale[0].split(':')[0]}); run ./course figures")
    differences = []
    for chapter, table in tables.items():
        differences += compare_chapter(chapter, table, args)
    for line in differences:
        say(f"differs: {line}")
    if differences:
        raise CourseError(f"{count(len(differences), 'value')} differ from the committed figures, first {differences[0]}; "
                          "run ./course figures and look at what changed")
    return 0


def stale_figures(chapter, table, only):
    """`chapter figure: reasons` for each committed figure that its inputs don't make any more."""
    folder = FIGURES / chapter
    current = CurrentInputs.of(chapter, declarations())
    entries = provenance.read(folder)
    lines = []
    for name in chosen(table, only):
        entry = entries.get(name)
        reasons = provenance.stale_reasons(entry, current, folder)
        if entry and entry.get("quality") != "report":
            reasons.append("it is no report but a " + str(entry.get("quality")))
        if reasons:
            lines.append(f"{chapter} {name}: {'; '.join(reasons)}")
    if not only:
        lines += [f"{chapter} {name}: the chapter draws no such figure" for name in entries if name not in table]
    return lines


def compare_chapter(chapter, table, args):
    """Draws a chapter into a folder of its own and compares; --full does so at report quality, pictures too."""
    quality = "report" if args.full else "draft"
    names = chosen(table, args.only)
    entries = provenance.read(FIGURES / chapter)
    seeds = sorted({entries[name]["seed"] for name in names})
    shutil.rmtree(CHECK_FOLDER / chapter, ignore_errors=True)
    say(f"{chapter}: drawing a {quality} to compare {count(len(names), 'figure')} with")
    for seed in seeds:
        run_chapter(chapter, CHECK_FOLDER, [name for name in names if entries[name]["seed"] == seed], quality, seed,
                    args.threads)
    tolerances = Tolerances.of(chapter)
    differences, compared = [], 0
    for name in names:
        for file in entries[name]["files"]:
            committed, fresh = FIGURES / chapter / file, CHECK_FOLDER / chapter / file
            if file.endswith(".csv"):
                compare = compare_tables
            elif file.endswith(".png") and args.full and not table[name]:
                compare = compare_pictures
            else:
                continue
            compared += 1
            differences += [f"{chapter} {name}: {line}" for line in compare_file(compare, committed, fresh, tolerances)]
    say(f"{chapter}: {count(compared, 'file')} compared, {count(len(differences), 'difference')}")
    return differences


def compare_file(compare, committed, fresh, tolerances):
    if not fresh.exists():
        return [f"{committed.name}: a draft does not make it"]
    return compare(committed, fresh, tolerances)
