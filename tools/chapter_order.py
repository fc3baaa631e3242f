"""Checks who includes whom: chapter_order.py BUILD_DIR.

Reads what the compiler really opened (ninja's dependency log, and the lists of the headers that were compiled by themselves)
and what CMake declared (declarations.json), and fails when
- a file tagged N includes a file tagged later,
- a topic's file includes one of a topic that it does not use, directly or through another,
- the library includes a file of a chapter or a test, or one that no caustic_topic declares,
- a chapter's file includes a file of another chapter or of the tests, or a graded test one of a chapter.
"""

import json
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

OBJECT_LINE = re.compile(r"^(?P<object>\S.*): #deps \d+, deps mtime -?\d+ \((?P<state>\w+)\)$")
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')


@dataclass(frozen=True)
class Place:
    """Where a file stands in the order of the course."""

    kind: str  # "topic", "chapter" or "test"
    chapter: int
    topic: str = ""


@dataclass(frozen=True)
class Violation:
    includer: str
    line: int
    included: str
    rule: str

    def __str__(self):
        return f"{self.includer}:{self.line}: includes {self.included}: {self.rule}"


class Order:
    """What the declarations say of each file of ours, and who may include whom."""

    def __init__(self, declarations):
        self._topics = declarations["topics"]
        self._files = declarations["files"]

    def place(self, path):
        """The place of a file; None for one that is outside of the order (third parties, benchmarks, generated)."""
        if path in self._files:
            return Place("topic", self._files[path]["chapter"], self._files[path]["topic"])
        found = re.match(r"^(chapters|tests)/(\d\d)_\w+/", path)
        if not found:
            return None
        return Place("chapter" if found[1] == "chapters" else "test", int(found[2]))

    def is_ours(self, path):
        return self.place(path) is not None or re.match(r"^(common|tests/support)/", path) is not None

    def may_use(self, topic):
        """The topic itself and all that it uses, directly or through another."""
        found = {topic}
        for used in self._topics[topic]:
            found |= self.may_use(used)
        return found

    def broken_rule(self, includer, included):
        """Why `includer` must not include `included`; None when it may."""
        one, other = self.place(includer), self.place(included)
        if other is None:
            return "it is declared in no caustic_topic; add it to its folder's CMakeLists.txt" if self.is_ours(included) else None
        if one is None:
            return None
        if other.chapter > one.chapter:
            return f"a file of chapter {one.chapter} cannot know what chapter {other.chapter} adds"
        if one.kind == "topic":
            return self._broken_by_topic(one, other)
        if other.kind == "topic":
            return "chapters do not use the test kit" if one.kind == "chapter" and other.topic == "support" else None
        return self._broken_by_chapter(includer, one, other)

    def _broken_by_topic(self, one, other):
        if other.kind != "topic":
            return f"the library knows no {other.kind}s"
        if other.topic in self.may_use(one.topic):
            return None
        return f"topic {one.topic} does not use topic {other.topic} (USES in its caustic_topic)"

    @staticmethod
    def _broken_by_chapter(includer, one, other):
        if one.kind == "chapter" and other.kind == "test":
            return "chapters know no tests"
        if one.chapter != other.chapter:
            return f"chapter {one.chapter} uses the library, not the files of chapter {other.chapter}"
        if other.kind == "chapter" and Path(includer).name.startswith("graded_"):
            return "a graded test sees the library only, so that it builds with what a student has"
        return None


def parse_dependencies(listing, build_dir, root=ROOT):
    """From the output of `ninja -t deps`: (source, [files that the compiler opened]) of each object that is up to date.

    Paths are relative to the root; files outside of it are left out.
    """
    root, build_dir = root.resolve(), build_dir.resolve()
    units, files = [], None
    for line in listing.splitlines():
        header = OBJECT_LINE.match(line)
        if header:
            files = []
            if header["state"] == "VALID":
                units.append(files)
        elif line.startswith("    ") and files is not None:
            files.append(line.strip())
    return [(relative(opened[0], build_dir, root) or opened[0], inside(opened[1:], build_dir, root))
            for opened in units if opened]


def header_units(declarations, build_dir, root=ROOT):
    """As parse_dependencies, of each header that was compiled by itself (target headers) since one of its files changed."""
    root, build_dir = root.resolve(), build_dir.resolve()
    units = []
    for name in declarations["files"]:
        mark = build_dir / "headers" / f"{name}.checked"
        opened = mark.with_name(f"{mark.name}.d")
        if mark.exists() and opened.exists():
            words = opened.read_text().partition(": ")[2].replace("\\\n", " ")
            paths = [path.replace("\\ ", " ") for path in re.split(r"(?<!\\)\s+", words) if path]
            found = inside(paths, build_dir, root)
            if all(is_older(root / path, mark) for path in found if path in declarations["files"]):
                units.append((name, [path for path in found if path != name]))
    return units


def is_older(path, mark):
    """Whether a file is still there and has not changed since another one was written."""
    return path.exists() and path.stat().st_mtime_ns <= mark.stat().st_mtime_ns


def relative(path, build_dir, root):
    whole = Path(build_dir, path)
    parts = []
    for part in whole.parts:
        if part == "..":
            parts.pop()
        else:
            parts.append(part)
    try:
        return Path(*parts).relative_to(root).as_posix()
    except ValueError:
        return None


def inside(paths, build_dir, root):
    found = (relative(path, build_dir, root) for path in paths)
    return [path for path in found if path is not None]


def include_line(includer, included, root):
    """The number of the line of `includer` that includes `included`; None when no line does."""
    try:
        lines = (root / includer).read_text(errors="replace").splitlines()
    except OSError:
        return None
    for number, line in enumerate(lines, start=1):
        found = INCLUDE.match(line)
        if found and ("/" + included).endswith("/" + re.sub(r"^(\.\.?/)+", "", found[1])):
            return number
    return None


def violations(units, order, root=ROOT):
    """All broken rules, each once, at the line that does it."""
    found = set()
    for source, opened in units:
        for included in opened:
            if order.broken_rule(source, included):
                found |= set(culprits(source, opened, included, order, root))
    return sorted(found, key=str)


def culprits(source, opened, included, order, root):
    """Who of a compiler run includes a forbidden file without being allowed to.

    A header that is allowed to is itself forbidden to the source, and is found as such. When no line can be found (a macro
    made the name), the source is named.
    """
    lines = {file: include_line(file, included, root) for file in [source, *opened] if file != included}
    includers = [file for file, line in lines.items() if line is not None]
    if not includers:
        yield Violation(source, 0, included, order.broken_rule(source, included))
    for file in includers:
        rule = order.broken_rule(file, included)
        if rule:
            yield Violation(file, lines[file], included, rule)


def read_listing(build_dir):
    # -n: a look at the log while another ninja writes it must not tidy it up.
    command = ["ninja", "-C", str(build_dir), "-n", "-t", "deps"]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def main(arguments):
    if len(arguments) != 1:
        sys.exit("usage: chapter_order.py BUILD_DIR")
    build_dir = Path(arguments[0])
    declarations = json.loads((build_dir / "declarations.json").read_text())
    order = Order(declarations)
    units = parse_dependencies(read_listing(build_dir), build_dir) + header_units(declarations, build_dir)
    if not units:
        sys.exit(f"chapter_order: nothing has been compiled in {build_dir}; build first")
    broken = violations(units, order)
    for violation in broken:
        print(f"{violation.includer}:{violation.line}: error: includes {violation.included}: {violation.rule}")
    if broken:
        return 1
    print(f"{len(units)} files compiled, each includes only what it may")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
