"""What is remembered as green, and that every input of a check makes it due again."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

from course_lib import checks, ctest, green
from course_lib.green import Memory


class Remembering(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "green.json"
        self.memory = Memory(self.path)

    def test_a_check_is_green_for_the_inputs_that_it_passed_with(self):
        self.assertIsNone(self.memory.passed("a", "1"))
        self.memory.remember("a", "1", 12)
        self.memory.remember("b", "1", 3)
        self.assertEqual(Memory(self.path).passed("a", "1"), 12)
        self.assertIsNone(self.memory.passed("a", "2"), "Its inputs changed.")

    def test_what_failed_is_due_again_although_it_passed_before(self):
        self.memory.remember("a", "1", 12)
        self.memory.forget("a")
        self.assertIsNone(self.memory.passed("a", "1"))

    def test_a_damaged_record_knows_nothing(self):
        self.path.write_text('{"a": ')
        self.assertIsNone(self.memory.passed("a", "1"))


class Inputs(unittest.TestCase):
    """On a made-up tree: each kind of check is due again after a change of what can change its outcome."""

    FILES = {"tools/tool.py": "", "cmake/Caustic.cmake": "", "common/core/check.h": "", "common/image/image.cpp": "",
             "common/tree/tree.cpp": "",
             "chapters/01_curves/chart.gp": "", "chapters/04_tree/chart.gp": "", "tests/01_curves/graded_a.cpp": "",
             "tests/04_tree/graded_b.cpp": "", "tests/course/test_gates.py": "", "assets/cup.svg": "", "README.md": "",
             "figures/01_curves/cup.png": "", "build/release/bin/graded_01": "", "build/release/bin/01_curves": "",
             "build/release/bin/curves_ranks": ""}
    TAGS = {"common/core/check.h": {"chapter": 1, "topic": "core"},
            "common/image/image.cpp": {"chapter": 1, "topic": "image"},
            "common/tree/tree.cpp": {"chapter": 4, "topic": "tree"}}
    PROGRAMS = {"01_curves": ["01_curves", "curves_ranks"], "04_tree": ["04_tree"]}
    COURSE = {"gates_01": (), "gates_04": (), "chapters_01": (), "strip": (), "grade": ("/course/alone.py",)}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in self.FILES.items():
            self.write(name, text)
        sources = [name for name in self.FILES if not name.startswith("build/")]
        for module, name, value in (
                (checks, "source_files", lambda root=None: sources),
                (checks, "files_to_build", lambda root=None: [n for n in sources if not n.startswith(("figures/", "tests/course/"))]),
                (checks, "declarations", lambda preset="release": {"files": self.TAGS, "programs": self.PROGRAMS}),
                (checks, "program", lambda name, preset: self.root / "build" / preset / "bin" / name),
                (green, "toolchain", lambda: self.installed)):
            patch = mock.patch.object(module, name, value)
            patch.start()
            self.addCleanup(patch.stop)
        patch = mock.patch.object(green.files_digest, "__defaults__", (self.root,))
        patch.start()
        self.addCleanup(patch.stop)
        self.installed = "g++ 12"
        self.before = self.inputs()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def inputs(self):
        entries = [ctest.Entry(f"course.{name}", ("course",), ("/usr/bin/env", *words)) for name, words in self.COURSE.items()]
        program = str(self.root / "build/release/bin/graded_01")
        entries.append(ctest.Entry("01.graded.A.B", ("01.graded",), (program, "--gtest_filter=A.B")))
        return {entry.check: checks.inputs_of([entry]) for entry in entries}

    def due_after(self, name):
        self.write(name, "changed")
        after = self.inputs()
        self.write(name, "")
        self.assertEqual(self.inputs(), self.before, "Is a change that was taken back no change?")
        return {check.removeprefix("course.") for check in after if after[check] != self.before[check]}

    def test_a_change_makes_due_what_depends_on_it_and_nothing_else(self):
        for name, due in {
                "README.md": {"strip"},
                "figures/01_curves/cup.png": {"strip"},
                "tools/tool.py": {"strip", "grade", "gates_01", "gates_04", "chapters_01"},
                "tests/course/test_gates.py": {"strip", "grade", "gates_01", "gates_04", "chapters_01"},
                "cmake/Caustic.cmake": {"strip", "grade", "gates_01", "gates_04"},
                "common/image/image.cpp": {"strip", "gates_01", "gates_04"},
                "common/core/check.h": {"strip", "grade", "gates_01", "gates_04"},
                "common/tree/tree.cpp": {"strip", "gates_04"},
                "tests/01_curves/graded_a.cpp": {"strip", "gates_01", "gates_04"},
                "tests/04_tree/graded_b.cpp": {"strip", "gates_04"},
                "chapters/01_curves/chart.gp": {"strip", "gates_01", "gates_04", "chapters_01", "01.graded"},
                "assets/cup.svg": {"strip", "gates_01", "gates_04", "chapters_01", "01.graded"},
                "build/release/bin/graded_01": {"01.graded"},
                "build/release/bin/01_curves": {"chapters_01", "01.graded"},
                "build/release/bin/curves_ranks": {"chapters_01", "01.graded"}}.items():
            self.assertEqual(self.due_after(name), due, name)

    def test_another_compiler_makes_everything_due(self):
        self.installed = "g++ 13"
        after = self.inputs()
        self.assertFalse([check for check in after if after[check] == self.before[check]])


if __name__ == "__main__":
    unittest.main()
