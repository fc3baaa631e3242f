"""Which chapters a change belongs to: what .ci/run looks at more closely."""

import unittest

from changed_chapters import changed_files, chapters_of

TAGS = {"common/core/text.h": 1, "common/accel/tree.h": 4}
EVERY = ["01", "02", "04"]


class ChangedChapters(unittest.TestCase):
    def changed(self, *paths):
        return chapters_of(paths, TAGS, EVERY)

    def test_files_belong_to_their_chapter_and_library_files_to_their_tag(self):
        self.assertEqual(self.changed("chapters/02_rays/main.cpp", "common/accel/tree.h"), ["02", "04"])
        self.assertEqual(self.changed("tests/04_tree/mistakes/lost_leaf.patch"), ["04"])

    def test_texts_and_pictures_belong_to_none(self):
        self.assertEqual(self.changed("README.md", "chapters/02_rays/README.md", "figures/02_rays/a.png", "docs/Doxyfile"), [])

    def test_what_no_chapter_owns_belongs_to_all(self):
        for path in ("CMakeLists.txt", "tests/support/kit.h", "tools/strip.py", "common/new/undeclared.h", "packages.txt"):
            self.assertEqual(self.changed(path, "README.md"), EVERY, path)

    def test_a_chapter_that_is_gone_is_not_asked_for(self):
        self.assertEqual(self.changed("chapters/03_gone/main.cpp"), [])

    def test_a_base_that_git_does_not_know_means_that_it_cannot_tell(self):
        self.assertIsNone(changed_files(""))
        self.assertIsNone(changed_files("no-such-commit"))


if __name__ == "__main__":
    unittest.main()
