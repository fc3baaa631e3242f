"""What every chapter's executable promises: the same pictures for any number of threads, and no half work."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from commands import figures
from course_lib import provenance
from course_lib.chapters import all_chapters
from course_lib.paths import DRAFT_FIGURES

BIN = Path(os.environ["CAUSTIC_BUILD_DIR"]) / "bin"
SEVERAL = 2  # threads


def run_chapter(chapter, *words):
    return subprocess.run([BIN / chapter, *map(str, words)], text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def drafted(chapter, table, names):
    """The files of these figures among the drafts of ./course figures, drawn by several threads: name -> bytes.

    What is up to date there is not drawn again, and what this draws, ./course figures needs not.
    """
    wanted = SimpleNamespace(quality="draft", only=names, force=False, seed=1, threads=SEVERAL)
    folder = DRAFT_FIGURES / chapter
    if any(entry["threads"] < SEVERAL for name, entry in provenance.read(folder).items() if name in names):
        wanted.force = True
    figures.draw_chapter(chapter, table, wanted)
    entries = provenance.read(folder)
    return {file: (folder / file).read_bytes() for name in names for file in entries[name]["files"]}


def drawn_by_one_thread(chapter, names, folder):
    only = [word for name in names for word in ("--only", name)]
    finished = run_chapter(chapter, "--out", folder, "--threads", 1, *only)
    if finished.returncode != 0:
        raise AssertionError(finished.stderr)
    return {path.name: path.read_bytes() for path in (Path(folder) / chapter).iterdir() if path.name != "provenance.json"}


class Chapter:
    """The promises of one chapter; `chapter` is set by the classes below."""

    chapter = ""

    def test_untimed_figures_are_the_same_for_one_thread_and_two(self):
        with tempfile.TemporaryDirectory() as folder:
            table = figures.table_of_contents(self.chapter)
            untimed = [name for name, timed in table.items() if not timed]
            self.assertTrue(untimed, "A chapter draws at least one figure without times.")
            parallel, serial = drafted(self.chapter, table, untimed), drawn_by_one_thread(self.chapter, untimed, folder)
            self.assertEqual(sorted(serial), sorted(parallel))
            different = [name for name in serial if serial[name] != parallel[name]]
            self.assertEqual(different, [], "Which sum is taken in the order in which threads finish?")

    def test_figures_are_known_before_anything_is_built(self):
        for chapter in all_chapters():
            self.assertEqual(figures.spelled_figures(chapter), list(figures.table_of_contents(chapter)))

    def test_bad_command_lines_are_refused_and_write_nothing(self):
        for words in (["--only", "no_such_figure"], ["--threads", "0"], ["--quality", "best"], ["--nonsense"]):
            with self.subTest(words), tempfile.TemporaryDirectory() as folder:
                finished = run_chapter(self.chapter, "--out", folder, *words)
                self.assertEqual(finished.returncode, 2)
                self.assertEqual(len(finished.stderr.splitlines()), 1, finished.stderr)
                self.assertEqual(list(Path(folder).iterdir()), [])


def load_tests(loader, tests, pattern):
    """A class for each chapter."""
    suite = unittest.TestSuite()
    for chapter in all_chapters():
        promises = type(f"Chapter_{chapter}", (Chapter, unittest.TestCase), {"chapter": chapter})
        suite.addTests(loader.loadTestsFromTestCase(promises))
    return suite


if __name__ == "__main__":
    unittest.main()
