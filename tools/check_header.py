"""Compiles a header by itself: check_header.py HEADER CHECKED PRECOMPILED COMPILER ARGUMENT...

Only its syntax is checked, and nothing comes before it but what cannot matter: a header that includes Eigen's geometry, itself
or through others of ours, sees all of it whether or not it was read before. So these use PRECOMPILED, which holds that and
nothing else ("none": there is no such), and take a third of the time (scene.h: 1.4 s instead of 4.4). What was opened goes to CHECKED.d; CHECKED is written
when all is well.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)
FOLDERS = ("common", "tests")
HELD = "Eigen/Geometry"


def foreign_includes(header, root=ROOT, seen=None):
    """The names in <> that a header includes, itself or through headers of ours."""
    seen = set() if seen is None else seen
    found = set()
    for bracket, name in INCLUDE.findall(header.read_text(encoding="utf-8", errors="replace")):
        if bracket == "<":
            found.add(name)
            continue
        for path in (header.parent / name, *(root / folder / name for folder in FOLDERS)):
            if path.is_file() and path not in seen:
                seen.add(path)
                found |= foreign_includes(path, root, seen)
    return found


def main(arguments):
    header, checked, precompiled, *compiler = arguments
    first = ["-include", precompiled] if precompiled != "none" and HELD in foreign_includes(Path(header)) else []
    command = [*compiler, *first, "-include", header, "-fsyntax-only", "-MD", "-MT", checked, "-MF", f"{checked}.d",
               "-x", "c++", "/dev/null"]
    code = subprocess.run(command).returncode
    if code == 0:
        Path(checked).touch()
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
