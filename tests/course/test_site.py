"""The site of this very tree: it builds without a problem, and headless Chromium shows it as it is meant."""

import csv
import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from course_lib.paths import ROOT
from docs.browser import Browser
from docs.builder import Builder
from docs.integrators import SCENES
from docs.tree import Tree

BUILD = Path(os.environ.get("CAUSTIC_BUILD_DIR", ROOT / "build" / "release"))
FORMULAS_SET = "typeof MathJax == 'undefined' || (MathJax.isReady && MathJax.Hub.queue.pending == 0)"
# What the browser knows of a page: formulas asked for, drawn and not understood; its text, code and formulas aside.
FACTS = """(() => {
    const copy = document.querySelector('.contents').cloneNode(true);
    copy.querySelectorAll('code, .fragment, pre, script, style, .MathJax_SVG, .MathJax_Preview').forEach(e => e.remove());
    const math = typeof MathJax == 'undefined' ? [] : MathJax.Hub.getAllJax();
    return {
        asked: document.querySelectorAll('script[type^="math/tex"]').length,
        drawn: document.querySelectorAll('.MathJax_SVG svg').length,
        wrong: math.filter(formula => formula.texError).map(formula => formula.originalText),
        snippets: document.querySelectorAll('.snippet-head').length,
        images: document.querySelectorAll('.contents img').length,
        unnamed: [...document.querySelectorAll('.contents img')].filter(e => !e.alt.trim()).map(e => e.src),
        prose: copy.textContent
    };
})()"""
PHONE = (390, 844)
# How far the page's text reaches to the right, and the wide formulas that scroll by themselves, all of them or by keys.
WIDTHS = """new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
    const page = document.getElementById('doc-content');
    const wide = [...document.querySelectorAll('.MathJax_SVG_Display, .MathJax_SVG.wide')].filter(e => e.scrollWidth > e.clientWidth);
    done({needs: page.scrollWidth, has: page.clientWidth, wide: wide.length, reached: wide.filter(e => e.tabIndex == 0).length});
})))"""
# The least contrast of text to its ground (WCAG 2.1, 1.4.3) on the page, and the words that have it.
CONTRAST = """(() => {
    const numbers = colour => colour.match(/[\\d.]+/g).map(Number);
    const light = colour => numbers(colour).slice(0, 3).map(v => v / 255)
        .map(v => v <= 0.03928 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4))
        .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    const ground = element => {
        for (; element; element = element.parentElement) {
            const colour = getComputedStyle(element).backgroundColor;
            if ((numbers(colour)[3] ?? 1) == 1) return colour;
        }
        return 'rgb(255, 255, 255)';
    };
    let least = {contrast: 21, words: ''};
    for (const element of document.querySelectorAll('.contents :is(p, li, td, th, h1, h2, h3, figcaption, code, a, span, summary)')) {
        const words = [...element.childNodes].filter(node => node.nodeType == 3).map(node => node.data.trim()).join(' ').trim();
        if (!words || !element.getClientRects().length) continue;
        const [one, other] = [light(getComputedStyle(element).color), light(ground(element))].sort((a, b) => b - a);
        const contrast = (one + 0.05) / (other + 0.05);
        if (contrast < least.contrast) least = {contrast, words: words.slice(0, 60)};
    }
    return least;
})()"""
ALL_LOADED = "[...document.images].every(image => image.complete)"
RAW_FORMULA = re.compile(r"\\f[$\[\]{}]|\\[()\[\]]|\$[^$\s][^$]*\$")
# Besides the pages from Markdown, one of each kind that Doxygen makes.
KINDS = ("classcaustic_1_1BezierCurve.html", "bezier__curve_8cpp_source.html", "namespacecaustic.html",
         "annotated.html", "files.html", "hierarchy.html")


class Site(unittest.TestCase):
    """Each page, opened once."""

    @classmethod
    def setUpClass(cls):
        declarations = BUILD / "declarations.json"
        out = BUILD / "site"
        builder = Builder(ROOT, out, declarations, json.loads(declarations.read_text()))
        cls.problems = builder.lesson_problems() + builder.build()
        cls.html = out / "html"
        cls.tree = Tree(ROOT)
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.__exit__)
        cls.facts = {name: cls.visit(name) for name in [page.url for page in cls.tree.pages.values()] + list(KINDS)}

    @classmethod
    def visit(cls, name):
        cls.browser.messages.clear()
        cls.browser.open(cls.html / name, FORMULAS_SET)
        facts = cls.browser.evaluate(FACTS)
        cls.browser.resize(*PHONE)
        facts["phone"] = cls.browser.evaluate(WIDTHS)
        cls.browser.resize()
        return {**facts, "messages": list(cls.browser.messages)}

    def test_has_no_problem(self):
        self.assertEqual(self.problems, [], "Run ./course docs: which file and line does it name?")

    def test_sets_every_formula(self):
        for name, facts in self.facts.items():
            with self.subTest(page=name):
                self.assertEqual(facts["drawn"], facts["asked"], "Are all parts of MathJax that it needs in the site?")
                self.assertEqual(facts["wrong"], [], "Is that TeX?")
        self.assertGreater(self.facts["glossary.html"]["drawn"], 100)

    def test_leaves_no_formula_raw(self):
        for name, facts in self.facts.items():
            with self.subTest(page=name):
                self.assertEqual(RAW_FORMULA.findall(facts["prose"]), [], "Does a letter or a space stand in its way?")

    def test_every_lesson_has_formulas_and_its_exercises(self):
        self.assertTrue(self.tree.chapters())
        for page in self.tree.chapters():
            with self.subTest(page=str(page.path)):
                self.assertGreater(self.facts[page.url]["drawn"], 0)
                self.assertGreaterEqual(self.facts[page.url]["snippets"], 4)

    def test_no_page_complains_on_the_console(self):
        for name, facts in self.facts.items():
            with self.subTest(page=name):
                self.assertEqual(facts["messages"], [])

    def test_every_picture_says_what_it_shows(self):
        for name, facts in self.facts.items():
            with self.subTest(page=name):
                self.assertEqual(facts["unnamed"], [])
        self.assertGreater(sum(facts["images"] for facts in self.facts.values()), 150)

    def test_no_page_is_wider_than_a_phone(self):
        for page in self.tree.pages.values():
            with self.subTest(page=str(page.path)):
                facts = self.facts[page.url]["phone"]
                self.assertLessEqual(facts["needs"], facts["has"], "What stands out? Let it scroll in a box of its own.")
                self.assertEqual(facts["reached"], facts["wide"], "What scrolls is reached by the Tab key, too.")
        self.assertGreater(self.facts["chapter_07_path_tracing.html"]["phone"]["wide"], 0)

    def test_text_stands_out_in_light_and_dark(self):
        grounds = set()
        for name in ("chapter_07_path_tracing.html", "figures.html", "before_and_after.html", "topic_map.html", "glossary.html"):
            self.browser.open(self.html / name)
            for dark in ("false", "true"):
                self.browser.evaluate(f"document.documentElement.classList.toggle('dark-mode', {dark})")
                with self.subTest(page=name, dark=dark):
                    least = self.browser.evaluate(CONTRAST)
                    self.assertGreaterEqual(least["contrast"], 4.5, least["words"])
                grounds.add(self.browser.evaluate("getComputedStyle(document.body).backgroundColor"))
        self.assertEqual(len(grounds), 2)

    def load_pictures(self, name):
        """Opens a page and all its pictures; returns the addresses of those that are broken."""
        self.browser.open(self.html / name)
        self.browser.evaluate("document.querySelectorAll('img').forEach(image => image.loading = 'eager')")
        self.browser.wait_until(ALL_LOADED)
        return self.browser.evaluate("[...document.images].filter(image => image.naturalWidth == 0).map(image => image.src)")

    def test_the_gallery_has_every_figure_with_what_makes_it(self):
        self.assertEqual(self.load_pictures("figures.html"), [])
        shown = self.browser.evaluate("""[...document.querySelectorAll('.gallery figure')].map(figure => ({
            full: figure.querySelector('a.figure').getAttribute('href'), picture: figure.querySelector('img').getAttribute('src'),
            links: [...figure.querySelectorAll('.made a')].map(link => link.textContent),
            command: figure.querySelector('.made code').textContent}))""")
        self.assertEqual(len(shown), len(list((ROOT / "figures").glob("[0-9][0-9]_*/*.png"))))
        for figure in shown:
            with self.subTest(figure=figure["picture"]):
                self.assertEqual(figure["full"], figure["picture"], "A click shows it in full size.")
                self.assertIn("code", figure["links"], "Which function of the table in main.cpp draws it?")
                folder, name = figure["picture"].split("/")[-2:]
                if (ROOT / "figures" / folder / name).with_suffix(".csv").exists():
                    self.assertIn(name.replace(".png", ".csv"), figure["links"])
                asked = re.fullmatch(r"./course figures (\d\d) --only (\w+)", figure["command"])
                self.assertEqual(asked[1], folder[:2])
                self.assertIn(f'{{"{asked[2]}",', (ROOT / "chapters" / folder / "main.cpp").read_text())

    def test_sliders_compare_pictures_of_one_size_and_obey_keys(self):
        self.assertEqual(self.load_pictures("before_and_after.html"), [])
        sizes = self.browser.evaluate("""[...document.querySelectorAll('.slider')].map(slider =>
            [...slider.querySelectorAll('img')].map(image => `${image.naturalWidth} ${image.naturalHeight}`))""")
        self.assertGreaterEqual(len(sizes), 5)
        for pair in sizes:
            self.assertEqual(pair[0], pair[1])
        self.browser.evaluate("document.querySelector('.slider input').focus()")
        where = "getComputedStyle(document.querySelector('.slider')).getPropertyValue('--at').trim()"
        covered = "getComputedStyle(document.querySelector('.slider .before')).clipPath"
        self.assertEqual(self.browser.evaluate(where), "50%")
        before = self.browser.evaluate(covered)
        for _ in range(3):
            self.browser.press("ArrowLeft", 37)
        self.browser.wait_until(f"{where} == '47%'")
        self.assertNotEqual(self.browser.evaluate(covered), before)
        self.browser.press("Home", 36)
        self.browser.wait_until(f"{where} == '0%'")

    def test_the_page_of_integrators_has_every_method_that_was_measured(self):
        self.assertEqual(self.load_pictures("integrators.html"), [])
        cells = self.browser.evaluate("[...document.querySelectorAll('.contents td')].map(cell => cell.textContent.trim())")
        for chapter in ("07_path_tracing", "08_photon_mapping", "09_sppm"):
            with (ROOT / "figures" / chapter / "speed_accuracy.csv").open(encoding="utf-8", newline="") as file:
                methods = {row["method"] for row in csv.DictReader(file)}
            self.assertLessEqual(methods, set(cells), chapter)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.contents img').length"), len(SCENES))

    def test_every_topic_has_its_place(self):
        topics = [folder.name for folder in (ROOT / "common").iterdir() if folder.is_dir()]
        self.browser.open(self.html / "topic_map.html")
        for topic in topics:
            with self.subTest(topic=topic):
                chosen = f"document.querySelector('#place-{topic}, [name=place-{topic}]') !== null"
                self.assertTrue(self.browser.evaluate(chosen))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.topics .chosen').length"), len(topics))

    def found(self, words):
        """What the search finds, in order: addresses."""
        self.browser.open(self.html / "index.html")
        self.browser.evaluate("document.getElementById('MSearchField').focus()")
        self.browser.type(words)
        self.browser.wait_until("document.getElementById('MSearchResultsWindow').style.display == 'block'")
        shown = """[...document.querySelectorAll('.SRResult')].filter(result => result.style.display == 'block')
                   .flatMap(result => [...result.querySelectorAll('a')].map(link => link.href.split('/').pop()))"""
        return self.browser.wait_until(f"(found => found.length && found)({shown})", frame="MSearchResults")

    def test_the_search_finds_lessons_first_with_and_without_accents(self):
        for words in ("bezier", "Bézier"):
            with self.subTest(words=words):
                found = self.found(words)
                self.assertEqual(found[:2], ["chapter_01_bezier_curves.html", "chapter_03_bezier_surfaces.html"])
                self.assertIn("classcaustic_1_1BezierCurve.html", found)
        self.assertEqual(self.found("photon")[0], "chapter_08_photon_mapping.html")
        self.assertEqual(self.found("BezierCurve")[-1], "classcaustic_1_1BezierCurve.html")
        self.assertEqual(self.found("光子")[0], "zh_chapter_08_photon_mapping.html")

    def test_works_from_another_folder(self):
        moved = BUILD / "site" / "moved"
        shutil.rmtree(moved, ignore_errors=True)
        shutil.copytree(self.html, moved)
        self.browser.messages.clear()
        self.browser.open(moved / self.tree.chapters()[0].url, FORMULAS_SET)
        self.assertGreater(self.browser.evaluate(FACTS)["drawn"], 0)
        self.assertEqual(self.browser.messages, [])
        naming = subprocess.run(["grep", "-rlF", f"{ROOT}/", str(moved)], stdout=subprocess.PIPE, text=True).stdout
        self.assertEqual(naming, "", "Which page names a folder of this machine?")


if __name__ == "__main__":
    unittest.main()
