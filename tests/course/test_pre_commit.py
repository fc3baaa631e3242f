""".pre-commit-config.yaml: each hook's command is there, lets this tree pass, and finds what it is for."""

import os
import re
import shlex
import subprocess
import tempfile
import unittest
from pathlib import Path

from course_lib.paths import ROOT

HOOK = re.compile(r"^ {6}- id: (\S+)\n((?: {8}\S.*\n)+)", re.MULTILINE)


def hooks():
    """Hook's name -> its command, as words."""
    text = (ROOT / ".pre-commit-config.yaml").read_text()
    return {name: shlex.split(re.search(r"entry: (.*)", rest)[1]) for name, rest in HOOK.findall(text)}


def run(hook, *files, folder=ROOT):
    return subprocess.run([*hooks()[hook], *map(str, files)], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)


class Hooks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def test_all_are_local(self):
        text = (ROOT / ".pre-commit-config.yaml").read_text()
        self.assertEqual(re.findall(r"repo: (.*)", text), ["local"])
        self.assertEqual(text.count("- id: "), len(hooks()))
        self.assertEqual(text.count("language: system"), len(hooks()))

    def test_pages_and_chapters_of_this_tree_pass(self):
        for hook in ("translations", "filled"):
            ended = run(hook)
            self.assertEqual(ended.returncode, 0, f"{hook}: {ended.stdout}")
            self.assertIn("OK", ended.stdout)

    def test_spaces_at_a_lines_end_are_found_but_in_patches(self):
        environment = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull}
        subprocess.run(["git", "init", "-q", self.folder], check=True, env=environment)
        self.write("a.patch", " \n")
        subprocess.run(["git", "-C", self.folder, "add", "a.patch"], check=True)
        self.assertEqual(run("whitespace", folder=self.folder).returncode, 0)
        self.write("a.md", "a \n")
        subprocess.run(["git", "-C", self.folder, "add", "a.md"], check=True)
        ended = run("whitespace", folder=self.folder)
        self.assertNotEqual(ended.returncode, 0)
        self.assertIn("a.md:1: trailing whitespace", ended.stdout)

    def test_large_files_are_named(self):
        small, large = self.write("small", "x"), self.write("large", "x" * 2_000_001)
        self.assertEqual(run("small-files", small).returncode, 0)
        ended = run("small-files", small, large)
        self.assertEqual(ended.returncode, 1)
        self.assertRegex(ended.stdout, r"^\S+large: it has 2\.0 MB, and 2 MB is the most; make it smaller\n$")


if __name__ == "__main__":
    unittest.main()
