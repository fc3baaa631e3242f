"""Begins a folder of hidden tests: the graded tests that draw random numbers, from other seeds, to be changed further.

./course grade --hidden DIR grades by them beside the public ones. Points and parameters are then yours to set, in
DIR/NN_name/. Try them on the reference first: ./course grade NN --hidden DIR.
"""

import json
import random
import re
import secrets
from pathlib import Path

from course_lib.chapters import add_chapters_argument, choose_chapters
from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import count, say
from exercises.catalog import catalog_path
from exercises.hidden import DATA

HELP = "begin a folder of hidden tests"
# A test with the comment above it. Each begins and ends at a line's beginning, or is one line.
BLOCK = re.compile(r"(?:^//[^\n]*\n)*^TEST\((\w+), (\w+)\) (?:\{[^\n]*\}\n|.*?^\}\n)\n?", re.MULTILINE | re.DOTALL)
SEED = re.compile(r"\b((?:Random|\w*Sampler)(?: \w+)?[({])(\d+)\b")
MOST_SEED = 10**9


def add_arguments(parser):
    parser.add_argument("folder", metavar="DIR", type=Path, help="where to write them; missing or empty")
    add_chapters_argument(parser, "all that have graded tests")
    parser.add_argument("--seed", type=int, metavar="S", help="what the new seeds are drawn from (default: nobody knows)")


def run(args):
    if args.folder.exists() and (not args.folder.is_dir() or any(args.folder.iterdir())):
        raise CourseError(f"{args.folder} is not empty; name a folder that is missing or empty")
    draw = random.Random(secrets.token_bytes(16) if args.seed is None else args.seed)
    chapters = [chapter for chapter in choose_chapters(args.chapters) if catalog_path(chapter).exists()]
    written = sum(write_chapter(chapter, args.folder / chapter, draw) for chapter in chapters)
    if not written:
        raise CourseError(f"no graded test of {', '.join(chapters)} draws random numbers, so other seeds change nothing")
    say(f"{args.folder}: {count(written, 'test')} with other seeds. Change their parameters and points as you like, then:")
    say(f"  ./course grade NN --hidden {args.folder}    tries them on this tree")
    return 0


def write_chapter(chapter, place, draw):
    """Writes a chapter's tests that have a seed and returns how many there are."""
    known = {test["name"]: test for test in json.loads(catalog_path(chapter).read_text(encoding="utf-8"))["tests"]}
    listed = []
    for path in sorted((ROOT / "tests" / chapter).glob("graded_*.cpp")):
        text, names = with_other_seeds(path.read_text(encoding="utf-8"), draw)
        if names:
            place.mkdir(parents=True, exist_ok=True)
            (place / path.name[len("graded_"):]).write_text(text, encoding="utf-8")
            listed += [{**known[name], "name": f"Hidden{name}"} for name in names]
    if listed:
        order = list(known)
        listed.sort(key=lambda test: order.index(test["name"][len("Hidden"):]))
        data = {"chapter": chapter, "tests": listed}
        (place / DATA).write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    return len(listed)


def with_other_seeds(text, draw):
    """A source of tests without those that have no seed, and the names of those that stay."""
    names = []

    def changed(block):
        body, seeds = SEED.subn(lambda seed: f"{seed[1]}{draw.randrange(1, MOST_SEED)}", block[0])
        if not seeds:
            return ""
        names.append(f"{block[1]}.{block[2]}")
        return body.replace(f"TEST({block[1]}, ", f"TEST(Hidden{block[1]}, ", 1)

    return BLOCK.sub(changed, text), names
