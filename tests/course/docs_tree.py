"""A tree with one page, one header and one lesson, for the tests of tools/docs."""

import json
import tempfile
import unittest
from pathlib import Path

from docs.builder import Builder
from docs.markdown import Converter
from docs.snippets import all_snippets
from docs.tree import Tree

CURVE = """#include "curve/curve.h"

int twice(int x) {
    //! [ex-01.1]
    const int sum = x + x;
    return sum;
    //! [ex-01.1]
}
"""
CURVE_HEADER = """#pragma once

namespace caustic {

/// Twice a number.
int twice(int x);

}  // namespace caustic
"""
LESSON = """# Curves

## The idea

Twice $x$ is $2x$:

[code: ex-01.1](../../common/curve/curve.cpp)
"""
DECLARATIONS = {
    "topics": {"core": [], "curve": ["core"]},
    "files": {"common/curve/curve.h": {"topic": "curve", "chapter": 1},
              "common/curve/curve.cpp": {"topic": "curve", "chapter": 1}},
    "chapters": {"01_curves": []},
}


class SmallTree(unittest.TestCase):
    """A tree with one chapter, one exercise and one lesson that shows it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "tree"
        self.write("README.md", "# Caustic\n\nSee [the idea](chapters/01_curves/README.md#the-idea).\n")
        self.write("GLOSSARY.md", "# Glossary\n\n## Curves\n")
        self.write("docs/architecture.md", "# Architecture\n\n## Topics\n\n<!-- site: topics -->\n\n<!-- site: library -->\n")
        self.write("chapters/01_curves/README.md", LESSON)
        self.write("chapters/01_curves/main.cpp", "int main() { return 0; }\n")
        self.write("common/curve/curve.cpp", CURVE)
        self.write("common/curve/curve.h", CURVE_HEADER)
        self.write("build/declarations.json", json.dumps(DECLARATIONS))

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def convert(self, text, path="chapters/01_curves/README.md"):
        """The page's text for Doxygen, without its title, and what is wrong with it."""
        self.write(path, f"# Title\n\n{text}")
        tree = Tree(self.root)
        converter = Converter(tree, tree.pages[path], all_snippets(self.root), {"stars": lambda page: "***"})
        converted = converter.convert().split("\n", 2)[2]
        return converted.strip(), [str(problem) for problem in converter.problems]

    def builder(self):
        return Builder(self.root, self.root / "build/docs", self.root / "build/declarations.json", DECLARATIONS)
