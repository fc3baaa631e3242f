"""tools/docs: panels of figures, sliders, what makes a figure, charts of all integrators, what the search finds first."""

import json
import math
import re
import tempfile
import unittest
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.png import read_png
from docs.figure_gallery import Makers
from docs.integrators import Integrators, common_time, error_at
from docs.panels import Sheet, png
from docs.search import entry, keys, put_lessons_first
from docs.tree import Tree

from docs_tree import SmallTree

GREY, WHITE = b"\x60\x70\x80", b"\xff\xff\xff"


def sheet(width, height, panels, holes=()):
    """A white PNG with grey rectangles (left, top, right, bottom), and white ones within them."""
    rows = [[WHITE] * width for _ in range(height)]
    for rectangles, colour in ((panels, GREY), (holes, WHITE)):
        for left, top, right, bottom in rectangles:
            for y in range(top, bottom):
                rows[y][left:right] = [colour] * (right - left)
    return png([b"".join(row) for row in rows], width, 3)


class Panels(unittest.TestCase):
    FOUR = [(20, 30, 140, 150), (160, 30, 280, 150), (20, 180, 140, 300), (160, 180, 280, 300)]

    def sheet_of(self, *contents):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "sheet.png").write_bytes(sheet(*contents))
        return Sheet(self.folder / "sheet.png")

    def test_rows_and_columns(self):
        self.assertEqual(self.sheet_of(300, 320, self.FOUR).panels(), self.FOUR)

    def test_what_is_white_within_a_panel_does_not_cut_it(self):
        self.assertEqual(self.sheet_of(300, 320, self.FOUR, [(40, 60, 100, 90)]).panels(), self.FOUR)

    def test_letters_are_no_panels(self):
        self.assertEqual(self.sheet_of(300, 320, [*self.FOUR, (20, 5, 100, 20)]).panels(), self.FOUR)

    def test_a_panel_becomes_a_picture(self):
        four = self.sheet_of(300, 320, self.FOUR)
        self.assertTrue(four.save_panel(4, self.folder / "panels" / "sheet-4.png"))
        cut = read_png(self.folder / "panels" / "sheet-4.png")
        self.assertEqual((cut.width, cut.height, set(cut.rows)), (120, 120, {GREY * 120}))
        for number in (0, 5):
            self.assertFalse(four.save_panel(number, self.folder / "none.png"))


class Sliders(SmallTree):
    def test_pictures_and_panels(self):
        self.write("figures/01_curves/a.png", "")
        converted, problems = self.convert('<!-- site: slider ../../figures/01_curves/a.png "raw & flat" '
                                           '../../figures/01_curves/a.png#2 "smooth" -->')
        self.assertEqual(problems, [])
        self.assertIn('<img class=before src="files/figures/01_curves/a.png" alt="raw &amp; flat"', converted)
        self.assertIn('<img src="panels/figures/01_curves/a-2.png" alt="smooth"', converted)
        self.assertIn('type="range"', converted)

    def test_a_picture_that_is_not_there(self):
        self.write("figures/01_curves/a.png", "")
        for target in ("../../figures/01_curves/b.png", "../../figures/01_curves/a.png#x"):
            with self.subTest(target=target):
                problems = self.convert(f'<!-- site: slider ../../figures/01_curves/a.png "a" {target} "b" -->')[1]
                self.assertEqual(len(problems), 1)
                self.assertIn("there is no picture", problems[0])


class WhatMakesAFigure(SmallTree):
    def setUp(self):
        super().setUp()
        self.write("figures/01_curves/provenance.json", json.dumps({"figures": {"a": {"files": ["a.csv", "a.png"]}}}))
        self.write("chapters/01_curves/main.cpp", '    {"a", shared(drawA), true},\n    {"b", drawB},\n')
        self.write("chapters/01_curves/figures/a.cpp", "#include <a>\n\nvoid drawA(Runs& runs,\n           Context& context) {\n}\n")

    def test_data_code_and_command(self):
        links = Makers(self.root, "01_curves").links("a.png")
        self.assertIn('<a href="tree:/figures/01_curves/a.csv">a.csv</a>', links)
        self.assertIn('<a href="tree:/chapters/01_curves/figures/a.cpp#L3">code</a>', links)
        self.assertIn("./course figures 01 --only a<", links)

    def test_what_nothing_is_known_of(self):
        self.assertEqual(Makers(self.root, "01_curves").links("c.png"), "")
        self.assertIsNone(Makers(self.root, "01_curves").code("b"))


class ErrorOverTime(SmallTree):
    HEAD = "method,setting,time,time_unit,error,error_unit\n"

    def test_rows_go_to_their_scene_and_the_first_chapter_counts(self):
        self.write("figures/07_path_tracing/speed_accuracy.csv", self.HEAD + "A,scene=caustic;samples=2,2,s,0.5,r\n"
                   "A,scene=caustic;samples=1,1,s,1,r\nB,scene=diffuse_box;samples=1,1,s,7,r\n")
        self.write("figures/08_photon_mapping/speed_accuracy.csv", self.HEAD + "A,photons=1,1,s,9,r\nC,photons=1,4,s,3,r\n")
        page = Integrators(self.root).page()
        self.assertIn("## The caustic of a glass ball", page)
        self.assertIn("| method | error after 2 s |\n| :-- | --: |\n| A | 0.5 |\n| C | 3 |\n", page)
        self.assertIn("| B | 7 |", page)
        self.assertNotIn("peers", page)

    def test_a_tree_without_measurements(self):
        self.assertEqual(Integrators(self.root).page(), "Nothing is measured yet.")

    def test_between_points_the_line_is_straight_in_the_logarithms(self):
        points = [(1, 8), (4, 4), (16, 2)]
        self.assertTrue(math.isclose(error_at(points, 2), 8 / math.sqrt(2)))
        for seconds, error in ((0.5, 8), (4, 4), (16, 2)):
            self.assertTrue(math.isclose(error_at(points, seconds), error))
        self.assertEqual(common_time({"a": points, "b": [(1, 1), (9, 1)]}), 9)


class Search(SmallTree):
    def test_a_text_is_found_by_each_longer_word_without_accents(self):
        self.assertEqual(keys("01 Bézier curves of x"), ["01 bezier curves of x", "bezier curves of x", "curves of x"])

    def test_chinese_is_found_from_each_character(self):
        self.assertEqual(keys("08 光子"), ["08 光子", "光子", "子"])

    def test_entries_are_as_doxygens(self):
        self.assertEqual(entry("a b", 3, "It's", "x.html#y", "Page"), "  ['a_20b_p3',['It&#x27;s',['../x.html#y',1,'Page']]],\n")

    def make_search(self, script):
        self.write("html/search/search.js", script)
        self.write("html/search/searchdata.js", 'var indexSectionsWithContent =\n{\n  0: "acr",\n  1: "c"\n};\n')
        self.write("html/search/all_0.html", '<script src="all_0.js">')
        for index in range(3):
            self.write(f"html/search/all_{index}.js", "var searchData=\n[\n  ['curve_0',['Curve',['../c.html',1,'']]]\n];\n")

    def test_titles_come_first_then_headings_then_doxygens(self):
        self.make_search('x = this.DOMSearchField().value.replace(/^ +/, "");')
        put_lessons_first(Tree(self.root), self.root / "html")
        data = (self.root / "html/search/all_1.js").read_text()
        places = [data.index(text) for text in ("../chapter_01_curves.html'", "../glossary.html#glossary-curves'", "../c.html")]
        self.assertEqual(places, sorted(places))
        self.assertIn('normalize("NFD")', (self.root / "html/search/search.js").read_text())

    def test_letters_that_doxygen_has_not_are_added(self):
        self.make_search('x = this.DOMSearchField().value.replace(/^ +/, "");')
        self.write("README.zh.md", "# 光\n")
        put_lessons_first(Tree(self.root), self.root / "html")
        letters = re.search('0: "(.*)"', (self.root / "html/search/searchdata.js").read_text(encoding="utf-8"))[1]
        self.assertEqual(letters[:3] + letters[-1], "acr光")
        last = f"all_{len(letters) - 1:x}"
        self.assertIn("['光_p", (self.root / f"html/search/{last}.js").read_text(encoding="utf-8"))
        self.assertEqual((self.root / f"html/search/{last}.html").read_text(), f'<script src="{last}.js">')

    def test_another_doxygens_search_is_an_error(self):
        self.make_search("other")
        with self.assertRaisesRegex(CourseError, "search.js is another one"):
            put_lessons_first(Tree(self.root), self.root / "html")


if __name__ == "__main__":
    unittest.main()
