"""All mistakes by rule of a chapter's exercises."""

import difflib
import hashlib
import re
from dataclasses import dataclass, field

from course_lib.paths import ROOT
from mutation.operators import edits_of
from mutation.operators_types import Context
from mutation.signature import read_signature
from mutation.structure import Body
from strip import body as body_of
from strip import exercises_of_tree, lines_of, read_source

ENUMERATION = re.compile(r"\benum\s+(?:class\s+)?(\w+)[^{};]*\{([^}]*)\}")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@dataclass(frozen=True)
class Target:
    """An exercise whose body is changed."""

    exercise: object  # strip.Exercise
    source: str  # the whole file
    body: str  # what stands between the markers
    result: str  # the function's type

    @property
    def id(self):
        return self.exercise.id


@dataclass(frozen=True)
class Mutant:
    exercise: str  # "ex-02.3"
    operator: str
    path: str
    line: int  # of the file, where the change begins
    was: str  # the changed lines as they were, without indentation
    becomes: str  # and as they are
    body: str = field(repr=False)  # all of the body

    @property
    def id(self):
        """Short, and the same as long as the exercise and its change are."""
        return hashlib.sha256(f"{self.exercise}\n{self.body}".encode("utf-8", "surrogateescape")).hexdigest()[:12]

    @property
    def place(self):
        return f"{self.path}:{self.line}"


def read_targets(catalog, root=ROOT):
    """The chapter's exercises, by id."""
    marked = exercises_of_tree(root)
    found = {}
    for id in catalog.exercises:
        exercise = marked[id]
        source = read_source(root / exercise.path)
        before = "".join(lines_of(source)[:exercise.first - 1])
        found[id] = Target(exercise, source, body_of(source, exercise), read_signature(before, exercise.place).result)
    return found


def read_enumerations(root=ROOT):
    """Enumeration -> its enumerators, for every one declared under common/."""
    found = {}
    for path in sorted((root / "common").rglob("*.h")):
        for match in ENUMERATION.finditer(COMMENT.sub("", read_source(path))):
            names = [re.match(r"\s*(\w*)", part)[1] for part in match[2].split(",")]
            found[match[1]] = [name for name in names if name]
    return found


def mutants_of(target, enumerations):
    """Every mutant of an exercise once, in the order of operators and source."""
    exercise = target.exercise
    before = "".join(lines_of(target.source)[:exercise.first - 1])
    context = Context(read_signature(before, exercise.place), enumerations)
    seen = {squeezed(target.body)}
    for operator, start, end, text in edits_of(Body(target.body), context):
        changed = target.body[:start] + text + target.body[end:]
        if squeezed(changed) not in seen:
            seen.add(squeezed(changed))
            yield described(target, operator, changed)


def squeezed(text):
    """Two bodies that differ in white space or comments only are one."""
    return re.sub(r"\s+", "", COMMENT.sub("", text))


def described(target, operator, changed):
    old, new = target.body.split("\n"), changed.split("\n")
    blocks = [b for b in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes() if b[0] != "equal"]
    first, last = blocks[0][1], blocks[-1][2]
    behind = len(old) - last
    was = [line.strip() for line in old[first:last]]
    becomes = [line.strip() for line in new[first:len(new) - behind]]
    return Mutant(target.id, operator, target.exercise.path, target.exercise.first + 1 + first, "\n".join(was),
                  "\n".join(becomes), changed)
