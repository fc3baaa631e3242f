"""tools/compiler.sh: trees share what ccache compiled, precompiled headers too, and a changed header is never missed."""

import os
import re
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from course_lib.paths import ROOT

COMPILER = os.environ.get("CXX", "c++")


class Compiler(unittest.TestCase):
    """Trees with a source and a precompiled header of something foreign; each built as CMake and ninja do it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = Path(folder.name).resolve()
        self.environment = {**os.environ, "CCACHE_DIR": str(self.top / "ccache"), "LC_ALL": "C"}
        self.environment.pop("CCACHE_DISABLE", None)
        (self.top / "foreign").mkdir()
        self.write_foreign(1)

    def write_foreign(self, value):
        (self.top / "foreign/foreign.h").write_text(f"#pragma once\ninline int value() {{ return {value}; }}\n")
        time.sleep(1.1)  # ccache trusts no header that is as young as the compilation

    def make_tree(self, name):
        build = self.top / name / "build"
        build.mkdir(parents=True)
        (build / "pch.hxx").write_text("#pragma GCC system_header\n#include <foreign.h>\n")
        (build / "pch.hxx.cxx").write_text("")
        (build.parent / "main.cpp").write_text("int main() { return value(); }\n")
        return build

    def build(self, build):
        """What the program returns that is built in a tree."""
        common = [ROOT / "tools/compiler.sh", build.parent, "ccache", COMPILER, "-isystem", self.top / "foreign", "-O1",
                  "-include", build / "pch.hxx"]
        for words in (["-x", "c++-header", "-MD", "-MF", "pch.hxx.gch.d", "-o", "pch.hxx.gch", "-c", build / "pch.hxx.cxx"],
                      ["-Winvalid-pch", "-Werror", "-MD", "-MF", "main.o.d", "-o", "main.o", "-c", build.parent / "main.cpp"]):
            subprocess.run([*map(str, common), *map(str, words)], cwd=build, env=self.environment, check=True)
        subprocess.run([COMPILER, "-o", "main", "main.o"], cwd=build, check=True)
        return subprocess.run([build / "main"]).returncode

    def hits(self):
        shown = subprocess.run(["ccache", "--print-stats"], env=self.environment, capture_output=True, text=True, check=True).stdout
        return sum(int(number) for number in re.findall(r"^(?:direct|preprocessed)_cache_hit\s+(\d+)", shown, re.MULTILINE))

    def test_a_second_tree_gets_header_and_object_from_the_cache(self):
        self.assertEqual(self.build(self.make_tree("one")), 1)
        self.assertEqual(self.hits(), 0)
        self.assertEqual(self.build(self.make_tree("some where/else")), 1)
        self.assertEqual(self.hits(), 2)

    def test_a_changed_foreign_header_is_seen_in_every_tree(self):
        trees = [self.make_tree("one"), self.make_tree("other")]
        self.assertEqual([self.build(tree) for tree in trees], [1, 1])
        self.write_foreign(2)
        self.assertEqual([self.build(tree) for tree in trees], [2, 2])
        self.write_foreign(1)
        self.assertEqual([self.build(tree) for tree in trees], [1, 1])


if __name__ == "__main__":
    unittest.main()
