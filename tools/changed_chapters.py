"""Prints the numbers of the chapters whose files changed lately: changed_chapters.py [BASE].

What changed is what lies between BASE and HEAD. Without BASE: the last commit that is twelve hours older than HEAD, for
one landing is less than that. A file of the shared library belongs to the chapter that it is tagged with. What no chapter
owns (build files, the test kit, tools, packages) belongs to all of them; lessons, pages and figures to none. When git
cannot tell, all chapters count as changed.
"""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from course_lib.chapters import all_chapters
from course_lib.paths import ROOT, build_dir

LANDING_SECONDS = 12 * 3600
WITHOUT_CODE = re.compile(r"^(docs|figures|\.devcontainer)/|\.md$|^(LICENSE|\.gitignore|\.clang-(format|tidy))$|^tests/course/")
OF_A_CHAPTER = re.compile(r"^(?:chapters|tests)/(\d\d)_\w+/")


def git(*words):
    """What git prints; nothing when it fails."""
    finished = subprocess.run(["git", *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return finished.stdout.strip() if finished.returncode == 0 else ""


def guess_base():
    head = git("log", "-1", "--format=%ct")
    return git("rev-list", "-1", f"--before={int(head) - LANDING_SECONDS}", "HEAD") if head else ""


def changed_files(base):
    """The paths that differ between base and HEAD; None when git cannot tell."""
    if not base or not git("rev-parse", "--verify", "--quiet", base + "^{commit}"):
        return None
    return git("diff", "--name-only", base, "HEAD").splitlines()


def chapters_of(paths, tags, every):
    """The numbers of the chapters ("01") that the paths belong to; `tags`: file of the library -> chapter."""
    found = set()
    for path in paths:
        chapter = OF_A_CHAPTER.match(path)
        if WITHOUT_CODE.search(path):
            continue
        if chapter:
            found.add(chapter[1])
        elif path in tags:
            found.add(f"{tags[path]:02}")
        else:
            return list(every)
    return sorted(found & set(every))


def changed_chapters(base=None):
    """The numbers of the chapters whose files changed since a commit; all when git cannot tell."""
    every = [name[:2] for name in all_chapters()]
    paths = changed_files(base or os.environ.get("CAUSTIC_BASE") or guess_base())
    if paths is None:
        return every
    files = json.loads((build_dir() / "declarations.json").read_text())["files"]
    tags = {name: entry["chapter"] for name, entry in files.items() if entry["topic"] != "support"}
    return chapters_of(paths, tags, every)


def main(arguments):
    print(" ".join(changed_chapters(arguments[0] if arguments else None)))


if __name__ == "__main__":
    main(sys.argv[1:])
