"""tools/exercises/submission.py: what is taken from a submission, and what is refused. Nothing is built here."""

import hashlib
import io
import json
import os
import stat
import tempfile
import unittest
import zipfile
from pathlib import Path

from course_lib.errors import CourseError
from exercises import submission
from exercises.trees import starter_overlay
from toy_course import ToyCase

SUMS, CLAMP, PRODUCTS = "common/math/sums.cpp", "common/math/clamp.h", "common/math/products.cpp"


class Submissions(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sums = (cls.toy / SUMS).read_bytes()
        cls.clamp = (cls.toy / CLAMP).read_bytes()
        cls.products = (cls.toy / PRODUCTS).read_bytes()
        cls.starter = starter_overlay(cls.toy)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def in_folder(self, files):
        for name, content in files.items():
            path = self.folder / "handed_in" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        return self.folder / "handed_in"

    def in_zip(self, files, change=lambda entry: entry):
        path = self.folder / "handed_in.zip"
        with zipfile.ZipFile(path, "w") as archive:
            for name, content in files.items():
                archive.writestr(change(zipfile.ZipInfo(name)), content)
        return path

    @staticmethod
    def changed(content):
        """A file with something of one's own in a body."""
        return content.replace(b"return total", b"return 1 * total")

    def read(self, source, chapters=("01",)):
        return submission.read_submission(source, chapters, self.toy)

    def refused(self, source, reason):
        with self.assertRaisesRegex(CourseError, reason):
            self.read(source)

    def test_only_files_with_exercises_are_taken(self):
        mine = self.changed(self.sums)
        files = {SUMS: mine, CLAMP: self.clamp, "tests/01_first/grading.json": b"{}", "common/math/sums.h": b"no",
                 "CMakeLists.txt": b"no", "tests/01_first/graded_sums.cpp": b"no", "common/math/more.cpp": b"no"}
        for source in (self.in_folder(files), self.in_zip(files)):
            taken = self.read(source)
            self.assertEqual(taken.overlay, {SUMS: mine, CLAMP: self.clamp})
            self.assertEqual(taken.notes, [])

    def test_files_of_other_chapters_are_not_taken(self):
        mine = self.changed(self.products)
        files = {SUMS: self.sums, CLAMP: self.clamp, PRODUCTS: mine}
        self.assertEqual(set(self.read(self.in_folder(files)).overlay), {SUMS, CLAMP})
        self.assertEqual(set(self.read(self.in_folder(files), ("01", "02")).overlay), {SUMS, CLAMP, PRODUCTS})
        self.assertEqual(self.read(self.in_folder(files), ("02",)).overlay, {PRODUCTS: mine})

    def test_a_missing_file_counts_as_the_starters(self):
        taken = self.read(self.in_folder({SUMS: self.sums}))
        self.assertEqual(taken.overlay[CLAMP], self.starter[CLAMP])
        self.assertEqual(taken.notes, [f"{CLAMP} is missing; its exercises count as not done"])

    def test_a_zip_of_a_whole_folder_is_read(self):
        mine = self.changed(self.sums)
        self.assertEqual(self.read(self.in_zip({"me/" + SUMS: mine, "me/notes.txt": b""})).overlay[SUMS], mine)

    def test_a_zip_of_two_trees_is_refused(self):
        self.refused(self.in_zip({"me/" + SUMS: b"mine", "you/" + SUMS: b"yours"}), "several trees")

    def test_nothing_of_use_is_refused(self):
        self.refused(self.in_folder({"a.txt": b""}), "holds no exercise file")
        self.refused(self.in_zip({"a.txt": b""}), "holds no exercise file")
        self.refused(self.folder / "none", "there is no submission")

    def test_a_file_that_is_no_zip_is_refused(self):
        path = self.folder / "handed_in.zip"
        for content in (b"", b"rubbish", b"PK\x03\x04 rubbish"):
            path.write_bytes(content)
            self.refused(path, "cannot be read as a ZIP file")

    def test_a_damaged_zip_is_refused(self):
        path = self.in_zip({SUMS: self.sums})
        data = bytearray(path.read_bytes())
        data[60] ^= 0xff
        path.write_bytes(data)
        self.refused(path, "cannot be read as a ZIP file")

    def test_paths_out_of_the_archive_are_refused(self):
        for name in ("../" + SUMS, "/etc/passwd", "a/../../b", "C:/x"):
            self.refused(self.in_zip({SUMS: self.sums, name: b""}), "points out of the archive")

    def test_backslashes_are_explained(self):
        self.refused(self.in_zip({SUMS.replace("/", "\\"): self.sums}), "has backslashes, as some tools of Windows write them")

    def test_symbolic_links_are_refused(self):
        def link(entry):
            if entry.filename == CLAMP:
                entry.external_attr = (stat.S_IFLNK | 0o777) << 16
            return entry
        self.refused(self.in_zip({SUMS: self.sums, CLAMP: b"/etc/passwd"}, link), "symbolic link")
        top = self.in_folder({SUMS: self.sums})
        (top / CLAMP).symlink_to("/etc/passwd")
        self.refused(top, "symbolic link")

    def test_a_folder_behind_a_symbolic_link_is_refused(self):
        top = self.in_folder({"other/math/sums.cpp": self.sums})
        (top / "common").symlink_to("other")
        self.refused(top, "symbolic link")

    def test_something_that_is_no_file_counts_as_missing(self):
        top = self.in_folder({SUMS: self.sums})
        os.mkfifo(top / CLAMP)
        self.assertEqual(self.read(top).overlay[CLAMP], self.starter[CLAMP])

    def test_huge_files_are_refused_without_being_unpacked(self):
        path = self.folder / "bomb.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(SUMS, b"/" * (64 << 20))
        self.refused(path, "larger than 1 MiB")
        self.refused(self.in_folder({SUMS: b"/" * (2 << 20)}), "larger than 1 MiB")

    def test_too_many_entries_are_refused(self):
        data = io.BytesIO()
        with zipfile.ZipFile(data, "w") as archive:
            for number in range(submission.MOST_ENTRIES + 1):
                archive.writestr(f"{number}", b"")
        path = self.folder / "many.zip"
        path.write_bytes(data.getvalue())
        self.refused(path, "10001 entries")

    def test_one_name_twice_is_refused(self):
        path = self.folder / "twice.zip"
        with self.assertWarns(UserWarning), zipfile.ZipFile(path, "w") as archive:
            archive.writestr(SUMS, b"one")
            archive.writestr(SUMS, b"two")
        self.refused(path, "twice")

    def test_the_manifest_tells_when_a_file_was_changed(self):
        for content, notes in ((self.sums, []), (self.changed(self.sums), [f"{SUMS} was changed after ./course submit packed it"])):
            manifest = {"files": {SUMS: hashlib.sha256(self.sums).hexdigest()}}
            files = {SUMS: content, CLAMP: self.clamp, "manifest.json": json.dumps(manifest).encode()}
            self.assertEqual(self.read(self.in_zip(files)).notes, notes)

    def test_of_sources_and_headers_only_the_bodies_are_taken(self):
        for path, content in ((CLAMP, self.clamp), (SUMS, self.sums)):
            theirs = b"#define EXPECT_EQ(a, b)\n" + content.replace(b"return ", b"return 0 + ", 1) + b"struct Leave {} leave;\n"
            taken = self.read(self.in_folder({CLAMP: self.clamp, SUMS: self.sums, path: theirs}))
            self.assertEqual(taken.overlay[path], content.replace(b"return ", b"return 0 + ", 1))
            self.assertEqual(taken.notes, [f"{path}:1: changed outside of an exercise's body, which does not count"])

    def test_a_number_sign_in_a_headers_comment_costs_nothing(self):
        theirs = self.clamp.replace(b"    if (value", b"    // the #1 case\n    if (value")
        taken = self.read(self.in_folder({CLAMP: theirs, SUMS: self.sums}))
        self.assertEqual((taken.overlay[CLAMP], taken.notes, taken.refused), (theirs, [], {}))

    def test_a_refused_body_becomes_a_stub(self):
        theirs = self.clamp.replace(b"    if (value", b"#define EXPECT_EQ(a, b)\n    if (value")
        taken = self.read(self.in_folder({CLAMP: theirs, SUMS: self.sums}))
        self.assertEqual(taken.overlay[CLAMP], self.starter[CLAMP])
        self.assertEqual(taken.refused, {"ex-01.4": f"{CLAMP}:11: this is a preprocessor line"})

    def test_a_header_with_broken_markers_counts_as_not_done(self):
        theirs = self.clamp.replace(b"//! [ex-01.4]", b"", 1)
        taken = self.read(self.in_folder({SUMS: self.sums, CLAMP: theirs}))
        self.assertEqual(taken.overlay[CLAMP], self.starter[CLAMP])
        self.assertIn("closing marker", " ".join(taken.notes))


if __name__ == "__main__":
    unittest.main()
