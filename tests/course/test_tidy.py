"""What makes ./course tidy read a file again, and which of its rules' names it looks up."""

import os
import unittest
from pathlib import Path

import chapter_order
from commands import tidy

BUILD = Path(os.environ["CAUSTIC_BUILD_DIR"])
RULES = """Checks: >
  -*,bugprone-*,cert-err34-c,
  modernize-use-nullptr,
  -bugprone-branch-clone
"""


class Tidy(unittest.TestCase):
    def test_no_file_that_the_compiler_opened_is_forgotten(self):
        units = [(source, {name for name in opened if tidy.SOURCES.match(name)})
                 for source, opened in chapter_order.parse_dependencies(chapter_order.read_listing(BUILD), BUILD)
                 if tidy.SOURCES.match(source)]
        self.assertGreater(sum(len(opened) for _, opened in units), 1000, "Is there a build?")
        for source, opened in units:
            self.assertEqual(opened - tidy.read_with(source), set(), source)

    def test_checks_are_looked_up_that_are_named_and_wanted(self):
        self.assertEqual(tidy.CHECK_BY_NAME.findall(RULES), ["cert-err34-c", "modernize-use-nullptr"])


if __name__ == "__main__":
    unittest.main()
