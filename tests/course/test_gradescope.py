"""The autograder's archive, unpacked and run where Gradescope has it: /autograder, in a scratch folder."""

import json
import os
import shutil
import subprocess
import unittest
import zipfile

from exercises.trees import starter_overlay
from schema_check import json_errors, read
from toy_course import ToyCase, course, solve

LIBRARY = ("common/math/sums.cpp", "common/math/clamp.h", "common/math/products.cpp")
HIDDEN = """#include <gtest/gtest.h>

#include "math/products.h"

TEST(Hidden, OtherWeights) { EXPECT_EQ(caustic::weightedTotal({1, 1}, {3, 4}), 7); }
"""


class Gradescope(ToyCase):
    """Unpacks the archive and sets the image up once; each test hands something in."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        hidden = cls.top / "mine/02_second"
        hidden.mkdir(parents=True)
        (hidden / "others.cpp").write_text(HIDDEN)
        tests = [{"name": "Hidden.OtherWeights", "exercise": "ex-02.1", "points": 50, "lookAt": "The weights."}]
        (hidden / "grading.json").write_text(json.dumps({"chapter": "02_second", "tests": tests}))
        packed = course(cls.toy, "gradescope", "2", "--hidden", cls.top / "mine")
        assert packed.returncode == 0, packed.stderr
        cls.archive = cls.toy / "build/autograder_02.zip"
        cls.image = cls.unpacked("image", cls.archive)
        cls.set_up = cls.run_script(cls.image, "source/setup.sh")

    @classmethod
    def unpacked(cls, name, archive):
        """A folder as Gradescope makes it: the archive in source/, run_autograder beside it."""
        top = cls.top / name
        with zipfile.ZipFile(archive) as packed:
            packed.extractall(top / "source")
            for entry in packed.infolist():
                (top / "source" / entry.filename).chmod(entry.external_attr >> 16)
        shutil.copy2(top / "source/run_autograder", top / "run_autograder")
        return top

    @classmethod
    def run_script(cls, top, script):
        return subprocess.run([top / script], cwd=top, env={**os.environ, "AUTOGRADER_ROOT": str(top)}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def hand_in(self, files, top=None):
        """Runs the autograder on files and returns (exit code, results.json, output)."""
        top = top or self.image
        for name in ("submission", "results"):
            shutil.rmtree(top / name, ignore_errors=True)
        (top / "submission").mkdir()
        for path, content in files.items():
            (top / "submission" / path).parent.mkdir(parents=True, exist_ok=True)
            (top / "submission" / path).write_bytes(content)
        ended = self.run_script(top, "run_autograder")
        results = top / "results/results.json"
        if results.exists():
            self.assertEqual(json_errors(results, "gradescope.schema.json"), [])
        return ended.returncode, read(results) if results.exists() else None, ended.stdout

    def solved(self):
        return {path: (self.toy / path).read_bytes() for path in LIBRARY}

    def test_the_scripts_lie_at_the_top_and_can_be_run(self):
        with zipfile.ZipFile(self.archive) as packed:
            rights = {entry.filename: entry.external_attr >> 16 & 0o777 for entry in packed.infolist()}
        for name in ("setup.sh", "run_autograder", "grader/course"):
            self.assertEqual(rights.get(name), 0o755, name)
        self.assertEqual(self.set_up.returncode, 0, self.set_up.stdout)

    def test_the_archive_holds_no_solution(self):
        solution = starter_overlay(self.toy)
        for path in LIBRARY:
            self.assertEqual((self.image / "source/grader" / path).read_bytes(), solution[path], path)
        names = [path.name for path in (self.image / "source/grader/tests").rglob("*")]
        self.assertFalse({"mistakes", "alternatives"} & set(names))

    def test_what_submit_packs_gets_its_points_and_its_hidden_ones(self):
        code, results, said = self.hand_in(self.solved())
        self.assertEqual((code, results["score"]), (0, 150), said)
        self.assertEqual([(test["name"], test["score"], test["visibility"]) for test in results["tests"]],
                         [("Products.WeightsMultiplyValues", 100, "visible"), ("Hidden.OtherWeights", 50, "hidden")])
        self.assertIn("02_second: 100 of 100 points", results["output"])

    def test_an_archive_in_the_folder_is_taken(self):
        tree = self.top / "student"
        self.assertEqual(course(self.toy, "start", tree).returncode, 0)
        solve(tree, self.toy, "ex-01.1", "ex-01.2", "ex-01.3", "ex-01.4", "ex-02.1")
        self.assertEqual(course(tree, "submit", "2").returncode, 0)
        content = (tree / "build/submission_02.zip").read_bytes()
        self.assertEqual(self.hand_in({"submission_02.zip": content})[1]["score"], 150)

    def test_what_is_no_hand_in_gets_no_points_and_is_told_why(self):
        code, results, _ = self.hand_in({"essay.txt": b"a thought"})
        self.assertEqual((code, results["score"]), (0, 0))
        self.assertIn("holds no exercise file", results["output"])

    def test_a_fault_of_the_autograder_gives_no_results(self):
        path = self.image / "source/hidden/02_second/others.cpp"
        self.addCleanup(path.write_text, HIDDEN)
        path.write_text(HIDDEN.replace("weightedTotal", "weighedTotal"))
        code, results, said = self.hand_in(self.solved())
        self.assertEqual((code, results), (1, None))
        self.assertIn("course: a hidden test does not build: tests/02_second/graded_hidden_others.cpp:5:", said)

    def test_on_the_references_earlier_chapters_later_ones_count_alone(self):
        out = self.top / "on_reference.zip"
        self.assertEqual(course(self.toy, "gradescope", "02_second", "--on-reference", "--out", out).returncode, 0)
        top = self.unpacked("on_reference", out)
        second = {LIBRARY[2]: self.solved()[LIBRARY[2]]}
        self.assertEqual(self.hand_in(second, top)[1]["score"], 100)
        self.assertIn("throw NotImplemented", (top / "source/grader" / LIBRARY[2]).read_text())

    def test_errors_are_one_line(self):
        tree = self.top / "errors"
        self.assertEqual(course(self.toy, "start", tree).returncode, 0)
        for where, words, reason in ((self.toy, ("9",), "there is no chapter '9'"), (tree, ("1",), "made in the course's own"),
                                     (self.toy, ("1", "--hidden", self.top / "mine"), "has no hidden tests of 01_first"),
                                     (self.toy, ("1", "--out", "/proc/no/file.zip"), "cannot be written")):
            ended = course(where, "gradescope", *words)
            self.assertEqual((ended.returncode, ended.stderr.count("\n")), (1, 1), ended.stderr)
            self.assertIn(reason, ended.stderr)


if __name__ == "__main__":
    unittest.main()
