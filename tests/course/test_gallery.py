"""The page of all figures: lessons' order and captions, committed pictures while they are current, drafts else."""

import re
import tempfile
import unittest
from pathlib import Path

from course_lib.gallery import write_page

LESSON = """# 01 Curves & lines

![A cup, "sliced"](../../figures/01_curves/cup.png) and ![a plot](../../figures/01_curves/plot.png)
![of another chapter](../../figures/02_rays/ray.png)
"""


class Gallery(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.page = self.root / "build/figures/index.html"
        for name, text in (("chapters/01_curves/README.md", LESSON), ("chapters/02_rays/README.md", "# 02 Rays\n")):
            self.write(name, text)

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def shown(self, current=True):
        """The pictures on the page, in order; each must be there."""
        text = write_page(["01_curves", "02_rays"], lambda chapter: current, self.page, self.root).read_text()
        sources = re.findall(r'<img src="([^"]+)"', text)
        for source in sources:
            self.assertTrue((self.page.parent / source).exists(), source)
        return text, sources

    def test_pictures_stand_in_the_lessons_order_with_its_captions(self):
        for name in ("plot.png", "cup.png", "unnamed.png"):
            self.write(f"figures/01_curves/{name}")
        text, sources = self.shown()
        self.assertEqual(sources, [f"../../figures/01_curves/{name}" for name in ("cup.png", "plot.png", "unnamed.png")])
        self.assertIn("A cup, &quot;sliced&quot; <small>(cup.png, report)", text)
        self.assertIn("<h2>01 Curves &amp; lines</h2>", text)
        self.assertIn("<h2>02 Rays</h2>\n<p>Not drawn yet.</p>", text)

    def test_drafts_stand_in_for_what_is_stale_and_beside_what_is_current(self):
        self.write("figures/01_curves/cup.png")
        self.write("build/figures/01_curves/cup.png")
        self.assertEqual(self.shown(current=False)[1], ["01_curves/cup.png"])
        text, sources = self.shown(current=True)
        self.assertEqual(sources, ["../../figures/01_curves/cup.png"])
        self.assertIn('<a href="01_curves/cup.png">draft</a>', text)

    def test_older_pictures_without_a_draft_are_said_to_be_so(self):
        self.write("figures/01_curves/cup.png")
        self.assertIn("(cup.png, report, of older sources)", self.shown(current=False)[0])


if __name__ == "__main__":
    unittest.main()
