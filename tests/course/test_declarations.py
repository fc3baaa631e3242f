"""What CMake was told agrees with what lies in the tree."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from course_lib import ctest, provenance
from course_lib.chapters import all_chapters
from course_lib.paths import FIGURES, ROOT


def read_declarations(build_dir):
    return json.loads((Path(build_dir) / "declarations.json").read_text())


DECLARATIONS = read_declarations(os.environ["CAUSTIC_BUILD_DIR"])


class Declarations(unittest.TestCase):
    def test_every_file_of_the_library_is_declared(self):
        files = {path.relative_to(ROOT).as_posix() for path in (ROOT / "common").rglob("*")
                 if path.suffix in (".h", ".cpp", ".gp")}
        declared = {name for name in DECLARATIONS["files"] if name.startswith("common/")}
        self.assertEqual(files, declared, "Which CMakeLists.txt leaves a file out?")

    def test_every_source_is_compiled(self):
        commands = json.loads((Path(os.environ["CAUSTIC_BUILD_DIR"]) / "compile_commands.json").read_text())
        compiled = {Path(command["file"]).resolve() for command in commands}
        sources = [path for folder in ("common", "chapters", "tests") for path in (ROOT / folder).rglob("*.cpp")]
        written_for_tests = ROOT / "tests" / "course"
        left_out = [path.relative_to(ROOT).as_posix() for path in sources
                    if path not in compiled and written_for_tests not in path.parents
                    and "benchmarks" not in path.parts]
        self.assertEqual(left_out, [], "Which source is built by nothing?")

    def test_every_chapter_is_declared(self):
        self.assertEqual(sorted(DECLARATIONS["chapters"]), all_chapters())

    def test_figures_are_those_that_are_declared(self):
        for chapter, declared in DECLARATIONS["chapters"].items():
            pictures = sorted(path.name for path in (FIGURES / chapter).glob("*.png"))
            self.assertEqual(pictures, sorted(declared), f"{chapter}: FIGURES of its caustic_chapter, or figures/{chapter}?")

    def test_every_file_of_a_chapters_figures_belongs_to_one(self):
        benchmarks = "".join(path.read_text() for path in (ROOT / "tests" / "benchmarks").glob("*/run.py"))
        for chapter in DECLARATIONS["chapters"]:
            owned = {name for entry in provenance.read(FIGURES / chapter).values() for name in entry["files"]}
            present = {path.name for path in (FIGURES / chapter).glob("*")} - {"provenance.json"}
            self.assertEqual(owned - present, set(), f"{chapter}: not committed?")
            left_over = [name for name in present - owned if f'"{name}"' not in benchmarks]
            self.assertEqual(left_over, [], f"{chapter}: what made it?")


def ninja_inputs(target):
    """All that ninja makes or reads for a target."""
    command = ["ninja", "-C", os.environ["CAUSTIC_BUILD_DIR"], "-t", "inputs", target]
    return set(subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines())


class Headers(unittest.TestCase):
    def test_each_is_checked_by_itself_with_its_chapter(self):
        declared = {name: f"headers_{file['chapter']:02d}" for name, file in DECLARATIONS["files"].items() if name.endswith(".h")}
        for target in sorted(set(declared.values())):
            checked = {path.removeprefix(f"{ROOT}/") for path in ninja_inputs(target) if path.endswith(".h")}
            self.assertEqual(checked, {name for name in declared if declared[name] == target}, target)
        checked = {path.removeprefix(f"{ROOT}/") for path in ninja_inputs("headers") if path.endswith(".h")}
        self.assertEqual(checked, set(declared))


class Programs(unittest.TestCase):
    def test_what_a_chapters_tests_run_is_built_with_them(self):
        build = Path(os.environ["CAUSTIC_BUILD_DIR"])
        started = {}  # kind_NN -> the programs that its tests start
        for entry in ctest.entries("release", ctest.of_kind("graded", "property", "stability", "large")):
            number, kind = entry.labels[0].split(".")
            programs = {Path(word).relative_to(build).as_posix() for word in entry.command if word.startswith(f"{build}/bin/")}
            started.setdefault(f"{kind}_{number}", set()).update(programs)
        for target, programs in started.items():
            self.assertEqual(programs - {f"bin/{target}"} - ninja_inputs(target), set(),
                             f"./course test {target[-2:]} in a fresh clone builds {target}; what builds these?")


class FrontPage(unittest.TestCase):
    def test_every_chapter_that_stands_has_a_row_with_its_lesson_and_its_figures(self):
        text = (ROOT / "README.md").read_text()
        for chapter in all_chapters():
            row = rf"^\| {chapter[:2]} \| .*\(chapters/{chapter}/README\.md\).*\(figures/{chapter}\)"
            self.assertIsNotNone(re.search(row, text, re.MULTILINE), f"README.md's table of chapters lacks {chapter}")


class UpToAChapter(unittest.TestCase):
    def test_later_files_and_chapters_are_not_declared(self):
        with tempfile.TemporaryDirectory() as folder:
            command = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCAUSTIC_LAST_CHAPTER=1"]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            declarations = read_declarations(folder)
        self.assertEqual(list(declarations["chapters"]), ["01_bezier_curves"])
        tags = {entry["chapter"] for entry in declarations["files"].values()}
        self.assertEqual(tags, {1})
        first = {name for name, entry in DECLARATIONS["files"].items() if entry["chapter"] == 1}
        self.assertEqual(set(declarations["files"]), first)


if __name__ == "__main__":
    unittest.main()
