"""No block of more than ten lines of code stands twice."""

import unittest
from collections import defaultdict
from dataclasses import dataclass

from course_lib.paths import ROOT
from exercises.trees import source_files

MOST = 10  # lines of code: blank ones, comments and includes aside
CODE = (".cpp", ".h", ".py", ".cmake", ".gp", "CMakeLists.txt")
NO_CODE = {"C++": ("//", "#include", "#pragma"), "other": ("#", "import ", "from ")}
# Two files that may have a block in common, and why.
KNOWN = {
    ("common/medium/homogeneous_medium.cpp", "tests/support/coloured_fog.cpp"):
        "tests of earlier chapters need a medium that scatters, and must not wait for chapter 11's",
}


@dataclass(frozen=True)
class Block:
    """Lines of code that stand in two places."""

    lines: int
    first: str  # "common/math/ray.h:12"
    second: str

    @property
    def files(self):
        return tuple(sorted(place.rpartition(":")[0] for place in (self.first, self.second)))


def code_lines(name, text):
    """[(number, line without white space at its ends)] of what is code."""
    left_out = NO_CODE["C++" if name.endswith((".cpp", ".h")) else "other"]
    lines = ((number, " ".join(line.split())) for number, line in enumerate(text.splitlines(), start=1))
    return [(number, line) for number, line in lines if line and not line.startswith(left_out)]


def repeated(texts):
    """The blocks of more than MOST lines that stand twice in files, given as name -> text."""
    code = {name: code_lines(name, text) for name, text in texts.items()}
    places = defaultdict(list)
    for name, lines in code.items():
        for start in range(len(lines) - MOST):
            places[tuple(line for _, line in lines[start:start + MOST + 1])].append((name, start))
    found = []
    for name, start, other, begin in ((*all_places[0], *place) for all_places in places.values() for place in all_places[1:]):
        mine, its = code[name], code[other]
        if start and begin and mine[start - 1][1] == its[begin - 1][1]:
            continue  # the end of a longer one
        length = MOST + 1
        while max(start - len(mine), begin - len(its)) + length < 0 and mine[start + length][1] == its[begin + length][1]:
            length += 1
        found.append(Block(length, f"{name}:{mine[start][0]}", f"{other}:{its[begin][0]}"))
    return found


class Repetition(unittest.TestCase):
    def test_no_block_of_more_than_ten_lines_stands_twice(self):
        names = [name for name in source_files() if name.endswith(CODE)]
        blocks = repeated({name: (ROOT / name).read_text(encoding="utf-8") for name in names})
        self.assertGreater(len(names), 500)
        self.assertEqual([block for block in blocks if block.files not in KNOWN], [])
        self.assertEqual({block.files for block in blocks}, set(KNOWN), "Is one of them no longer so?")


class Finding(unittest.TestCase):
    LINES = [f"int a{i} = {i};" for i in range(MOST + 1)]

    def blocks(self, first, second):
        return repeated({"a.cpp": "\n".join(first), "b.h": "\n".join(second)})

    def test_a_block_is_found_whatever_its_spaces_and_comments(self):
        spaced = ["// more", "{", *(f"    {line}\n\n    // why" for line in self.LINES), "}"]
        self.assertEqual(self.blocks(self.LINES, spaced), [Block(MOST + 1, "a.cpp:1", "b.h:3")])

    def test_ten_lines_are_none(self):
        self.assertEqual(self.blocks(self.LINES[1:], self.LINES[1:]), [])

    def test_a_long_one_is_found_once(self):
        self.assertEqual(self.blocks(["int b;", *self.LINES, "int c;"], ["int b;", *self.LINES]), [Block(MOST + 2, "a.cpp:1", "b.h:1")])

    def test_within_a_file_too(self):
        self.assertEqual(repeated({"x.py": "\n".join([*self.LINES, "y", *self.LINES])}), [Block(MOST + 1, "x.py:1", "x.py:13")])


if __name__ == "__main__":
    unittest.main()
