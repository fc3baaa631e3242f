"""tools/check_header.py: a header that needs what it does not include is refused; what may be read before it is what it includes."""

import os
import tempfile
import unittest
from pathlib import Path

import check_header

COMPILER = os.environ.get("CXX", "c++")


class Headers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def test_includes_are_followed_through_our_headers(self):
        self.write("common/math/vector.h", "#pragma once\n#include <Eigen/Geometry>\n")
        self.write("common/math/ray.h", '#include "math/vector.h"\n#include <cmath>\n')
        header = self.write("common/scene/scene.h", '#include "math/ray.h"\n#include "scene/scene.h"\n// #include <vector>\n')
        self.assertEqual(check_header.foreign_includes(header, self.root), {"Eigen/Geometry", "cmath"})
        self.assertEqual(check_header.foreign_includes(self.write("common/a.h", "#include <Eigen/Core>\n"), self.root), {"Eigen/Core"})

    def test_nothing_is_read_before_a_header_but_what_it_includes(self):
        precompiled = ["Eigen/Geometry=geometry.hxx", "Eigen/Core=core.hxx"]
        for text, found in (("#include <Eigen/Core>\n#include <Eigen/Geometry>\n", "geometry.hxx"), ("#include <Eigen/Core>\n", "core.hxx"),
                            ("#include <vector>\n", None), ('#include "math/vector.h"\n', "core.hxx"), ("#include <Eigen/LU>\n", None)):
            self.write("common/math/vector.h", "#include <Eigen/Core>\n")
            self.assertEqual(check_header.usable(self.write("common/b.h", text), precompiled, self.root), found, text)

    def checked(self, text):
        """Whether a header compiles by itself, and whether it was marked as checked."""
        header, mark = self.write("common/a.h", text), self.root / "a.h.checked"
        mark.unlink(missing_ok=True)
        code = check_header.main([str(header), str(mark), "--", COMPILER, "-std=c++20", "-w"])
        return code == 0, mark.exists()

    def test_a_header_that_needs_what_it_does_not_include_is_refused(self):
        self.assertEqual(self.checked("#pragma once\n#include <string>\ninline std::string a() { return {}; }\n"), (True, True))
        self.assertIn("a.h", (self.root / "a.h.checked.d").read_text())
        self.assertEqual(self.checked("#pragma once\ninline std::string a() { return {}; }\n"), (False, False))


if __name__ == "__main__":
    unittest.main()
