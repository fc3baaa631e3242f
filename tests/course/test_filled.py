"""Whoever began a chapter by ./course new-chapter has filled what its template leaves open."""

import re
import unittest

from course_lib.paths import ROOT
from exercises.trees import source_files


class Filled(unittest.TestCase):
    # Files that speak of what is to be filled without being such.
    SPEAK_OF_IT = ("tools/templates/", "tools/commands/new_chapter.py", "tests/course/test_filled.py", "CONTRIBUTING.md")

    def test_nothing_of_the_template_is_left_in_this_tree(self):
        left = []
        for name in source_files():
            if name.startswith(self.SPEAK_OF_IT) or not name.endswith((".md", ".h", ".cpp", ".json", ".txt", ".gp")):
                continue
            if re.search(r"\bFILL\b", (ROOT / name).read_text(encoding="utf-8")):
                left.append(name)
        self.assertEqual(left, [], "Which words of the template has nobody replaced?")


if __name__ == "__main__":
    unittest.main()
