"""Doxygen's warnings, without those that a reader of the header would not share.

Doxygen asks for a docstring at every single member. We read a docstring as a person does: it stands for the paragraph of
declarations below it, up to the next blank line. So the docstring of a struct covers the members that follow it at once,
and "the same, channel by channel" covers both overloads. What lives in a .cpp alone is nobody's interface.
"""

import re
from pathlib import Path

PLACE = re.compile(r"^(?P<file>[^:\n]+):(?P<line>\d+): (?:warning|error): (?P<text>.*)$")
# Copies, moves and comparisons that the compiler writes do what everybody expects.
DEFAULTED = re.compile(r"= (default|delete);")
UNDOCUMENTED = re.compile(r"^(?:Member (?P<member>[~\w]+|operator\S+).*|Compound (?P<compound>[\w:]+)) is not documented\.$")


def relevant_warnings(log, root):
    """The warnings that count, each once, with paths below the tree's top."""
    root = Path(root).resolve()
    found = []
    for line in log.splitlines():
        line = line.replace(f"{root}/", "")
        if line.strip() and line not in found and not is_covered(line, root):
            found.append(line)
    return found


def is_covered(warning, root):
    """Whether it misses a docstring that the paragraph has, or that nobody needs."""
    place = PLACE.match(warning)
    undocumented = UNDOCUMENTED.match(place["text"]) if place else None
    if undocumented is None:
        return False
    path, number = root / place["file"], int(place["line"])
    if path.suffix == ".h":
        return has_docstring(path.read_text(encoding="utf-8").splitlines(), number - 1)
    name = undocumented["member"] or undocumented["compound"].split("::")[-1]
    header = path.with_suffix(".h")
    return not header.exists() or is_declared_with_docstring(name, header)


def is_declared_with_docstring(name, header):
    """Whether each declaration of the name in the header is covered; also when there is none."""
    lines = header.read_text(encoding="utf-8").splitlines()
    declarations = [index for index, line in enumerate(lines)
                    if re.search(rf"(?<![\w.]){re.escape(name)}\(", line.split("//")[0])]
    return all(has_docstring(lines, index) for index in declarations)


def has_docstring(lines, index):
    """Whether a docstring stands above the line within its paragraph, or behind it."""
    if "///<" in lines[index] or DEFAULTED.search(lines[index]):
        return True
    for line in reversed(lines[:index]):
        if not line.strip():
            return False
        if re.match(r"\s*(///(?!<)|/\*\*|\*/)", line):
            return True
    return False
