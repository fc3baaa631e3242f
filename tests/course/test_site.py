"""The site of this very tree: it builds without a problem, and headless Chromium shows it as it is meant."""

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
        prose: copy.textContent
    };
})()"""
RAW_FORMULA = re.compile(r"\\f[$\[\]{}]|\\[()\[\]]|\$[^$\s][^$]*\$")
# Besides the pages from Markdown, one of each kind that Doxygen makes.
KINDS = ("classcaustic_1_1BezierCurve.html", "bezier__curve_8cpp_source.html", "namespacecaustic.html",
         "annotated.html", "files.html", "hierarchy.html")


class Site(unittest.TestCase):
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
        return {**cls.browser.evaluate(FACTS), "messages": list(cls.browser.messages)}

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

    def test_the_front_page_draws_every_figure(self):
        self.browser.open(self.html / "index.html")
        self.browser.evaluate("document.querySelectorAll('img').forEach(image => image.loading = 'eager')")
        self.browser.wait_until("[...document.images].every(image => image.complete)")
        broken = "[...document.images].filter(image => image.naturalWidth == 0).map(image => image.src)"
        self.assertEqual(self.browser.evaluate(broken), [])
        shown = self.browser.evaluate("document.querySelectorAll('.gallery img').length")
        self.assertEqual(shown, len(list((ROOT / "figures").glob("[0-9][0-9]_*/*.png"))))

    def test_the_search_box_finds_a_class(self):
        self.browser.open(self.html / "index.html")
        self.browser.evaluate("document.getElementById('MSearchField').focus()")
        self.browser.type("BezierCurve")
        self.browser.wait_until("document.getElementById('MSearchResultsWindow').style.display == 'block'")
        shown = """[...document.querySelectorAll('.SRResult')].filter(result => result.style.display == 'block')
                   .flatMap(result => [...result.querySelectorAll('a')].map(link => link.href)).join(' ')"""
        found = self.browser.wait_until(shown, frame="MSearchResults")
        self.assertIn("classcaustic_1_1BezierCurve.html", found)

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
