"""./course grade --all on the toy course: a folder of hand-ins, honest and other, is graded each as if it were alone."""

import csv
import hashlib
import io
import stat
import tempfile
import unittest
import zipfile
from pathlib import Path

from course_lib.errors import CourseError
from exercises import hand_ins, overview
from exercises.trees import source_files, starter_overlay
from toy_course import ToyCase, course, where

SUMS, CLAMP = "common/math/sums.cpp", "common/math/clamp.h"
TOTAL, LARGEST, MEAN = 40, 30, 20  # points of the exercises of sums.cpp; clamp.h has the other 10


def zipped(files, change=lambda entry: entry):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(change(zipfile.ZipInfo(name)), content, zipfile.ZIP_DEFLATED)
    return data.getvalue()


def linked(entry):
    entry.external_attr = (stat.S_IFLNK | 0o777) << 16
    return entry


class All(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.before = cls.state_of_the_tree()
        cls.folder = cls.top / "handed_in"
        cls.folder.mkdir()
        cls.points = {}
        for name, (points, content) in cls.cases().items():
            cls.points[name] = points
            cls.hand_in(name, content)
        (cls.folder / "notes.txt").write_text("Who is ill")
        (cls.folder / "linked").symlink_to(cls.toy)
        cls.csv, cls.html = cls.top / "grades.csv", cls.top / "grades.html"
        cls.ended = course(cls.toy, "grade", "01", "--all", cls.folder, "--csv", cls.csv, "--html", cls.html, *where(),
                           "--time-limit", "2")
        assert cls.ended.returncode == 0, cls.ended.stdout + cls.ended.stderr
        cls.rows = {row["hand_in"]: row for row in csv.DictReader(io.StringIO(cls.csv.read_text()))}

    @classmethod
    def state_of_the_tree(cls):
        return {name: hashlib.sha256((cls.toy / name).read_bytes()).hexdigest() for name in source_files(cls.toy)}

    @classmethod
    def hand_in(cls, name, content):
        """Writes one: bytes into a file, the files of a dict into a folder."""
        if isinstance(content, bytes):
            (cls.folder / name).write_bytes(content)
            return
        for path, text in content.items():
            (cls.folder / name / path).parent.mkdir(parents=True, exist_ok=True)
            (cls.folder / name / path).write_bytes(text)

    @classmethod
    def cases(cls):
        """Name -> (points that are due, what is handed in)."""
        sums, clamp = (cls.toy / SUMS).read_bytes(), (cls.toy / CLAMP).read_bytes()
        starter = starter_overlay(cls.toy)

        def total(line):
            """All is right, but for a line in the first exercise."""
            return {SUMS: sums.replace(b"double sum = 0;", line + b"\n    double sum = 0;"), CLAMP: clamp}

        def every_line_ends(end):
            return {SUMS: sums.replace(b"\n", end), CLAMP: clamp.replace(b"\n", end)}

        rest = 100 - TOTAL - MEAN  # the mean needs the total
        files = {SUMS: sums, CLAMP: clamp}
        return {
            "reference": (100, files),
            "reference.zip": (100, zipped(files)),
            "whole_folder.zip": (100, zipped({f"ada/{path}": text for path, text in files.items()})),
            "platform": (100, {"ada_assignment/submission_01.zip": zipped(files)}),
            "in_a_folder": (100, {f"student/{path}": text for path, text in files.items()}),
            "starter": (0, {path: starter[path] for path in files}),
            "half": (100 - LARGEST, {**files, SUMS: sums.replace(b"double most", b'throw NotImplemented("ex-01.2");\n    double most')}),
            "without_header": (90, {SUMS: sums}),
            "number_sign": (100, {**files, CLAMP: clamp.replace(b"    if (value", b"    // the #1 case\n    if (value", 1)}),
            "crlf": (100, every_line_ends(b"\r\n")),
            "cr": (100, every_line_ends(b"\r")),
            "utf_16": (100, {path: text.decode().encode("utf-16") for path, text in files.items()}),
            "no_body.zip": (10, zipped({SUMS: b"int main() {}\n", CLAMP: clamp})),
            "crash": (rest, total(b"volatile int* nowhere = nullptr;\n    *nowhere = 1;")),
            "endless": (rest, total(b"for (volatile int i = 0;; i = i + 1) {\n    }")),
            "exception": (rest, total(b'throw std::runtime_error("\\033[2J");')),
            "does_not_compile": (rest, total(b"return zero;")),
            "forks": (rest, total(b"fork();")),
            "word": (rest, total(b'std::ifstream("/proc/self/cmdline");')),
            "constructor": (100, {**files, SUMS: sums + b"struct Leave { Leave() { std::abort(); } } leave;\n"}),
            "assertion": (rest, total(b"#define EXPECT_EQ(a, b)")),
            "leaves": (rest, total(b"std::exit(0);")),
            "=HYPERLINK(1)": (100, files),
            "<script>": (100, files),
            "rubbish.zip": (0, b"PK\x03\x04 rubbish"),
            "empty.zip": (0, zipped({})),
            "bomb.zip": (0, zipped({SUMS: b"/" * (8 << 20), CLAMP: clamp})),
            "traversal.zip": (0, zipped({**files, "../../evil": b""})),
            "link.zip": (0, zipped(files, linked)),
            "windows.zip": (0, zipped({path.replace("/", "\\"): text for path, text in files.items()})),
        }

    def row_of(self, name):
        return self.rows["'" + name if name.startswith("=") else name]

    def test_each_gets_the_points_that_are_due(self):
        self.assertEqual({name: self.row_of(name)["points"] for name in self.points},
                         {name: str(points) for name, points in self.points.items()})
        self.assertEqual(len(self.rows), len(self.points))

    def test_each_row_says_why(self):
        reasons = {"constructor": "changed outside of an exercise's body", "does_not_compile": "'zero' was not declared",
                   "forks": "'fork' is of the operating system", "without_header": f"{CLAMP} is missing",
                   "leaves": "has exit: a person should look at it", "windows.zip": "has backslashes",
                   "empty.zip": "holds no exercise file",
                   "bomb.zip": "larger than 1 MiB", "traversal.zip": "points out of the archive", "link.zip": "symbolic link"}
        for name, reason in reasons.items():
            self.assertIn(reason, self.row_of(name)["remarks"], name)
        self.assertEqual([name for name in self.points if self.row_of(name)["to_look_at"] != "0"], ["leaves"])
        self.assertEqual(self.row_of("reference")["remarks"], "")

    def test_what_is_no_hand_in_is_named(self):
        for name in ("notes.txt", "linked"):
            self.assertIn(f"note: {name} is neither a folder nor a ZIP file", self.ended.stdout)

    def test_the_page_shows_all_and_runs_nothing(self):
        page = self.html.read_text()
        self.assertEqual(page.count("<details"), len(self.points))
        self.assertIn("&lt;script&gt;", page)
        self.assertNotIn("<script", page)
        self.assertNotRegex(page + self.ended.stdout, "\x1b")
        self.assertIn("Look at: ", page)

    def test_the_graders_tree_is_as_it_was(self):
        self.assertEqual(self.state_of_the_tree(), self.before)
        self.assertEqual(sorted(path.name for path in self.top.iterdir()), ["grades.csv", "grades.html", "handed_in", "toy"])


class Parts(unittest.TestCase):
    def test_a_folder_without_hand_ins_is_no_folder_of_hand_ins(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "notes.txt").write_text("")
            for wrong in (folder, f"{folder}/none", f"{folder}/notes.txt"):
                self.assertRaises(CourseError, hand_ins.entries, wrong)

    def test_no_cell_is_a_formula(self):
        for name in ("=1+1", "+1", "-1", "@x"):
            self.assertTrue(overview.plain(name).startswith("'"))
        self.assertEqual(overview.plain("two\nlines"), "two lines")

    def test_one_that_cannot_be_graded_is_said_and_not_a_zero(self):
        one = hand_ins.HandIn("ada", [], "the disk is full")
        self.assertEqual(overview.remark(one), "not graded: the disk is full")
        written = overview.to_csv([one], [], "bubblewrap").decode().splitlines()
        self.assertEqual(written[1], "ada,,0,0,bubblewrap,not graded: the disk is full")


if __name__ == "__main__":
    unittest.main()
