"""What every chapter's executable promises: the same pictures for any number of threads, and no half work."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from course_lib.chapters import all_chapters

BIN = Path(os.environ["CAUSTIC_BUILD_DIR"]) / "bin"


def run_chapter(chapter, *words):
    return subprocess.run([BIN / chapter, *map(str, words)], text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def untimed_figures(chapter):
    lines = run_chapter(chapter, "--list").stdout.splitlines()
    return [line for line in lines if not line.endswith("(timed)")]


def drawn(chapter, folder, threads):
    """The files of a chapter's untimed figures as drafts: name -> bytes."""
    only = [word for name in untimed_figures(chapter) for word in ("--only", name)]
    finished = run_chapter(chapter, "--out", folder, "--threads", threads, *only)
    if finished.returncode != 0:
        raise AssertionError(finished.stderr)
    return {path.name: path.read_bytes() for path in (Path(folder) / chapter).iterdir() if path.name != "provenance.json"}


class Chapters(unittest.TestCase):
    def test_untimed_figures_are_the_same_for_one_thread_and_two(self):
        for chapter in all_chapters():
            with self.subTest(chapter), tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
                serial, parallel = drawn(chapter, one, threads=1), drawn(chapter, two, threads=2)
                self.assertEqual(sorted(serial), sorted(parallel))
                self.assertTrue(serial, "A chapter draws at least one figure without times.")
                different = [name for name in serial if serial[name] != parallel[name]]
                self.assertEqual(different, [], "Which sum is taken in the order in which threads finish?")

    def test_bad_command_lines_are_refused_and_write_nothing(self):
        for chapter in all_chapters():
            for words in (["--only", "no_such_figure"], ["--threads", "0"], ["--quality", "best"], ["--nonsense"]):
                with self.subTest(f"{chapter} {words}"), tempfile.TemporaryDirectory() as folder:
                    finished = run_chapter(chapter, "--out", folder, *words)
                    self.assertEqual(finished.returncode, 2)
                    self.assertEqual(len(finished.stderr.splitlines()), 1, finished.stderr)
                    self.assertEqual(list(Path(folder).iterdir()), [])


if __name__ == "__main__":
    unittest.main()
