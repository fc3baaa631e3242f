"""The report of all figures: every picture, caption, table and origin of what is committed, on one page that can be printed."""

import base64
import contextlib
import io
import json
import re
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

from course_lib import figure_report
from course_lib.errors import CourseError
from course_lib.figure_report import report

LESSON = """# Curves & lines

![A cup, "sliced"](../../figures/01_curves/cup.png) and ![of another chapter](../../figures/02_rays/plot.png)
"""
MAIN = 'int main() {\n    return run({\n        {"cup", drawCup},\n        {"plot", chartPlot},\n    });\n}\n'
# One black pixel.
PIXEL = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==")
ENTRIES = {
    "cup": {"files": ["cup.png"], "inputs": {"sources": "a" * 64, "assets/cup.svg": "b" * 64}, "quality": "report", "seed": 1,
            "threads": 2, "timed": False, "seconds": 3.02, "peak_mib": 123.4},
    "plot": {"files": ["plot.csv", "plot.png", "gone.png"], "inputs": {"sources": "a" * 64}, "quality": "report", "seed": 3,
             "threads": 1, "timed": True, "seconds": 70, "peak_mib": 9.6},
}


class Reports(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        rows = "".join(f"<{i}>,{i},0.1234567890123,-1e-300,nan\n" for i in range(100))
        for name, content in {"chapters/01_curves/README.md": LESSON, "chapters/01_curves/main.cpp": MAIN,
                              "chapters/01_curves/figures/cup.cpp": "\nvoid drawCup(int) {\n}\n",
                              "chapters/02_rays/README.md": "# Rays\n", "figures/01_curves/cup.png": PIXEL,
                              "figures/01_curves/plot.png": PIXEL + b"0", "figures/01_curves/plot.csv": f"a,b,c,d,e\n{rows}",
                              "figures/01_curves/provenance.json": json.dumps({"figures": ENTRIES})}.items():
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content if isinstance(content, bytes) else content.encode())

    def page(self, reasons_of=lambda chapter, entry: []):
        return report(["01_curves", "02_rays"], reasons_of, "abc123", self.root)

    def test_every_picture_is_in_it_with_its_caption(self):
        page = self.page()
        pictures = [base64.b64decode(text) for text in re.findall(r'src="data:image/png;base64,([^"]+)"', page)]
        self.assertEqual(pictures, [PIXEL, PIXEL + b"0"])
        self.assertIn("<figcaption>A cup, &quot;sliced&quot; <small>(cup.png)</small>", page)
        self.assertIn("<figcaption>plot <small>(plot.png)</small>", page, "Is another chapter's caption taken for it?")
        self.assertIn("gone.png is missing.", page)
        self.assertIn("2 figures, 3 pictures, commit abc123", page)
        self.assertIn('<h2 id="01_curves">01 Curves &amp; lines</h2>', page)
        self.assertIn('<h2 id="02_rays">02 Rays</h2>\n<p>Nothing is committed.</p>', page)

    def test_tables_show_their_beginning_and_hold_all(self):
        page = self.page()
        whole = re.search(r'<a download="plot.csv" href="data:text/csv;base64,([^"]+)">plot.csv</a>, 100 rows', page)
        self.assertEqual(base64.b64decode(whole[1]), (self.root / "figures/01_curves/plot.csv").read_bytes())
        self.assertIn("<tr><th>a<th>b<th>c<th>d<th>e</thead>", page)
        self.assertIn('<tr><td>&lt;3&gt;<td class="number">3<td class="number">0.123457<td class="number">-1e-300<td class="number">nan',
                      page)
        self.assertEqual(page.count("<tr><td>"), figure_report.BEGINNING)
        self.assertIn("88 more rows in the file.", page)

    def test_each_figure_says_what_made_it(self):
        page = self.page()
        for part in ("<code>./course figures 01 --only cup</code>, drawn by <code>chapters/01_curves/figures/cup.cpp:2</code>",
                     "report quality, seed 1, 2 threads, 3.0 s, at most 123 MiB; the same bits each time",
                     "report quality, seed 3, 1 thread, 1 min 10 s, at most 10 MiB; shows measured times",
                     "made from sources <code>aaaaaaaaaaaa</code>, assets/cup.svg <code>bbbbbbbbbbbb</code>"):
            self.assertIn(part, page)

    def test_what_is_stale_says_why_and_what_is_unknown_says_nothing(self):
        stale = self.page(lambda chapter, entry: ["its sources changed"] if entry["seed"] == 3 else [])
        self.assertEqual(stale.count("not what the sources make now: its sources changed"), 1)
        self.assertEqual(stale.count("this is what the sources make"), 1)
        self.assertNotIn("the sources make", self.page(lambda chapter, entry: None))

    def test_it_is_printed(self):
        with mock.patch.multiple(figure_report, FOLDER=self.root / "out", reasons_now=lambda: lambda chapter, entry: None,
                                 report=lambda *ignored: self.page()), contextlib.redirect_stdout(io.StringIO()):
            figure_report.write(["01_curves"], SimpleNamespace(check=False, only=[], force=False, open=False))
        printed = (self.root / "out/figures.pdf").read_bytes()
        self.assertTrue(printed.startswith(b"%PDF-"))
        self.assertGreaterEqual(max(map(int, re.findall(rb"/Count (\d+)", printed))), 2, "Does each chapter begin a page?")
        self.assertGreaterEqual(printed.count(b"/Subtype /Image"), 2)

    def test_it_goes_with_no_other_errand(self):
        for wrong in ({"check": True}, {"only": ["cup"]}, {"force": True}):
            with self.assertRaisesRegex(CourseError, "--report shows all that is committed"):
                figure_report.write([], SimpleNamespace(**{"check": False, "only": [], "force": False, "open": False, **wrong}))


if __name__ == "__main__":
    unittest.main()
