"""tools/chapter_order.py finds every kind of include that the course forbids, and nothing else."""

import os
import tempfile
import unittest
from pathlib import Path

import chapter_order

DECLARATIONS = {
    "topics": {"core": [], "math": ["core"], "curve": ["math"], "accel": ["math"], "shape": ["curve", "accel"],
               "support": ["core", "math"]},
    "files": {
        "common/core/text.h": {"topic": "core", "chapter": 1},
        "common/math/vector.h": {"topic": "math", "chapter": 1},
        "common/curve/curve.h": {"topic": "curve", "chapter": 1},
        "common/curve/curve.cpp": {"topic": "curve", "chapter": 1},
        "common/curve/patch.h": {"topic": "curve", "chapter": 3},
        "common/accel/tree.h": {"topic": "accel", "chapter": 4},
        "common/shape/mesh.cpp": {"topic": "shape", "chapter": 4},
        "tests/support/kit.h": {"topic": "support", "chapter": 1},
    },
}

# What each file of the made-up tree says; the listing tells which of them the compiler opened.
SOURCES = {
    "common/curve/curve.cpp": '#include "curve/curve.h"\n',
    "common/curve/curve.h": '#pragma once\n\n#include "math/vector.h"\n',
    "common/shape/mesh.cpp": '#include "accel/tree.h"\n#include "core/text.h"\n',
}


class ChapterOrder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()
        self.build = self.root / "build" / "release"
        for name, text in SOURCES.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def violations(self, *units, state="VALID"):
        """What is found in a listing as ninja prints it; a unit is its source and then what it opens."""
        listing = ""
        for source, *opened in units:
            files = [source] + [f"../../{file}" if not file.startswith("/") else file for file in opened]
            files[0] = f"../../{source}"
            listing += f"some.dir/{Path(source).name}.o: #deps {len(files)}, deps mtime 12345 ({state})\n"
            listing += "".join(f"    {file}\n" for file in files) + "\n"
        parsed = chapter_order.parse_dependencies(listing, self.build, self.root)
        found = chapter_order.violations(parsed, chapter_order.Order(DECLARATIONS), self.root)
        return [(v.includer, v.line, v.included) for v in found], " ".join(v.rule for v in found)

    def test_allowed_includes_pass(self):
        found, _ = self.violations(
            ("common/curve/curve.cpp", "/usr/include/math.h", "common/curve/curve.h", "common/math/vector.h"),
            ("common/shape/mesh.cpp", "common/accel/tree.h", "common/core/text.h"))
        self.assertEqual(found, [], "Is using a topic through another one allowed?")

    def test_a_file_of_a_later_chapter_is_found_at_its_line(self):
        self.write("common/curve/curve.h", '#pragma once\n\n#include "math/vector.h"\n#include "curve/patch.h"\n')
        found, rule = self.violations(
            ("common/curve/curve.cpp", "common/curve/curve.h", "common/math/vector.h", "common/curve/patch.h"))
        self.assertEqual(found, [("common/curve/curve.h", 4, "common/curve/patch.h")])
        self.assertIn("chapter 1 cannot know what chapter 3 adds", rule)

    def test_a_topic_that_is_not_used_is_found(self):
        self.write("common/shape/mesh.cpp", "int x;\n")
        self.write("common/accel/tree.h", '#include "curve/patch.h"\n')
        found, rule = self.violations(("common/accel/tree.h", "common/curve/patch.h"))
        self.assertEqual(found, [("common/accel/tree.h", 1, "common/curve/patch.h")])
        self.assertIn("accel does not use topic curve", rule)

    def test_a_header_that_is_compiled_by_itself_counts_as_that_header(self):
        self.write("common/accel/tree.h", "")
        self.write("common/curve/curve.h", '#include "accel/tree.h"\n')
        checked = "build/release/headers/common/curve/curve.h.checked"
        self.write(f"{checked}.d", f"{checked}: /dev/null /usr/include/math.h \\\n {self.root}/common/curve/curve.h \\\n "
                   f"{self.root}/common/accel/tree.h\n")
        self.assertEqual(chapter_order.header_units(DECLARATIONS, self.build, self.root), [], "Was it compiled to its end?")
        self.write(checked, "")
        units = chapter_order.header_units(DECLARATIONS, self.build, self.root)
        found = chapter_order.violations(units, chapter_order.Order(DECLARATIONS), self.root)
        self.assertEqual([(v.includer, v.line, v.included) for v in found],
                         [("common/curve/curve.h", 1, "common/accel/tree.h")])

        later = (self.root / checked).stat().st_mtime + 1
        os.utime(self.root / "common/accel/tree.h", (later, later))
        self.assertEqual(chapter_order.header_units(DECLARATIONS, self.build, self.root), [], "Was it checked as it is now?")

    def test_an_undeclared_file_is_found(self):
        self.write("common/curve/curve.cpp", '#include "curve/secret.h"\n')
        found, rule = self.violations(("common/curve/curve.cpp", "common/curve/secret.h"))
        self.assertEqual(found, [("common/curve/curve.cpp", 1, "common/curve/secret.h")])
        self.assertIn("declared in no caustic_topic", rule)

    def test_the_library_knows_neither_chapters_nor_tests(self):
        for included in ("chapters/01_curves/profile.h", "tests/01_curves/helper.h"):
            self.write("common/curve/curve.cpp", f'#include "../../{included}"\n')
            found, _ = self.violations(("common/curve/curve.cpp", included))
            self.assertEqual(found, [("common/curve/curve.cpp", 1, included)])

    def test_chapters_stay_apart_and_know_no_tests(self):
        for included in ("chapters/01_curves/profile.h", "tests/support/kit.h", "tests/04_tree/helper.h",
                         "chapters/05_rays/later.h"):
            self.write("chapters/04_tree/main.cpp", f'#include "{Path(included).name}"\n')
            found, _ = self.violations(("chapters/04_tree/main.cpp", included))
            self.assertEqual(found, [("chapters/04_tree/main.cpp", 1, included)])

    def test_tests_see_their_own_chapter_and_the_kit_but_graded_ones_the_library_only(self):
        chapter = "chapters/04_tree/scene.h"
        found, _ = self.violations(("tests/04_tree/property_tree.cpp", chapter, "tests/support/kit.h"))
        self.assertEqual(found, [])
        self.write("tests/04_tree/graded_tree.cpp", '#include "scene.h"\n')
        found, _ = self.violations(("tests/04_tree/graded_tree.cpp", chapter))
        self.assertEqual(found, [("tests/04_tree/graded_tree.cpp", 1, chapter)])

    def test_an_include_that_no_line_shows_is_blamed_on_the_source(self):
        found, _ = self.violations(("common/curve/curve.cpp", "common/accel/tree.h"))
        self.assertEqual(found, [("common/curve/curve.cpp", 0, "common/accel/tree.h")])

    def test_stale_entries_are_left_out(self):
        found, _ = self.violations(("common/curve/curve.cpp", "common/accel/tree.h"), state="STALE")
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
