"""tools/docs: mistakes in headers and dead links are found and named, and what the site draws itself is right."""

import json
import shutil
import tempfile
import unittest
from pathlib import Path

from course_lib.paths import ROOT
from docs.doxygen_warnings import relevant_warnings
from docs.exercise_table import ExerciseTable, code_lines
from docs.links import dead_links
from docs.mistake_table import MistakeTable, in_a_cell
from docs.parts import declared_names
from docs.topic_map import reduced
from docs.tree import Tree

from docs_tree import CURVE_HEADER, SmallTree


class Doxygen(SmallTree):
    """The whole way, with a real Doxygen."""

    def setUp(self):
        super().setUp()
        for name in ("docs/Doxyfile", "docs/theme", "tools"):
            source, target = ROOT / name, self.root / name
            if source.is_dir():
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copyfile(source, target)

    def test_a_good_tree_becomes_a_site(self):
        builder = self.builder()
        self.assertEqual(builder.lesson_problems() + builder.build(), [])
        lesson = (builder.html / "chapter_01_curves.html").read_text()
        self.assertIn(r"\(2x\)", lesson)
        self.assertIn('<div class="title">01 Curves </div>', lesson)
        self.assertIn("curve_8cpp_source.html#l00005", lesson)
        self.assertIn('href="namespacecaustic.html#', lesson)  # `twice` in what the chapter adds to the library
        self.assertRegex((builder.html / "architecture.html").read_text(), r"<svg(.|\n)*>curve</text>")

    def test_what_is_built_meanwhile_is_not_looked_at(self):
        self.write("build/grade/1/tree/common/bad.h", "#pragma once\nint undocumented();\n")
        (self.root / "build/grade/1/tree/gone.h").symlink_to("nowhere.h")  # as a file that goes while Doxygen walks
        self.assertEqual(self.builder().build(), [])

    def test_an_undocumented_member_fails(self):
        self.write("common/curve/curve.h", CURVE_HEADER.replace("/// Twice a number.\n", ""))
        problems = self.builder().build()
        self.assertEqual(len(problems), 1, problems)
        self.assertRegex(problems[0], r"^common/curve/curve\.(h|cpp):\d+: warning: Member twice.* is not documented\.$")

    def test_a_docstring_that_doxygen_does_not_understand_fails(self):
        self.write("common/curve/curve.h", CURVE_HEADER.replace("Twice", "Twice <out>"))
        problems = self.builder().build()
        self.assertTrue(any(problem.startswith("common/curve/curve.h:5: ") for problem in problems), problems)


class Exercises(unittest.TestCase):
    """The page that lists all exercises."""

    def test_only_lines_with_code_count(self):
        self.assertEqual(code_lines("// Why.\n\nconst int a = 1;  // one\n/* two\n   lines */\nreturn a;\n"), 2)

    def test_each_chapter_has_its_exercises_and_a_hundred_points(self):
        page = ExerciseTable(Tree(ROOT)).page()
        chapters = page.count("\n## ")
        self.assertEqual(page.count(" | 100 |\n"), chapters)
        self.assertGreaterEqual(page.count("| ex-"), 6 * chapters)
        self.assertNotIn("| 0 |", page)


class Mistakes(unittest.TestCase):
    """The page that lists all mistakes."""

    @classmethod
    def setUpClass(cls):
        cls.page = MistakeTable(Tree(ROOT)).page()

    def test_each_patch_has_its_row_and_each_graded_test_catches_one(self):
        patches = list((ROOT / "tests").glob("*/mistakes/*.patch"))
        self.assertEqual(self.page.count("| ex-"), len(patches))
        for path in patches:
            self.assertEqual(self.page.count(f"tree:/{path.relative_to(ROOT)}"), 1, path.name)
        for path in (ROOT / "tests").glob("*/grading.json"):
            for test in json.loads(path.read_text())["tests"]:
                self.assertIn(f"| `{test['name']}` |\n", self.page)

    def test_the_sums_are_those_of_the_rows(self):
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in self.page.split("\n## ")[0].splitlines()[2:] if line]
        *chapters, total = rows
        for column in (1, 2, 3, 5):
            self.assertEqual(sum(int(row[column]) for row in chapters), int(total[column]))
        self.assertEqual(int(total[3]), self.page.count("| ex-"))

    def test_no_sentence_breaks_its_cell(self):
        for line in self.page.splitlines():
            if line.startswith("| ex-"):
                self.assertEqual(line.count("|"), 4, line)
        self.assertEqual(in_a_cell("a < b | *c* & `d`"), "a &lt; b &#124; &#42;c&#42; &amp; d")


class Warnings(unittest.TestCase):
    """A docstring stands for the paragraph of declarations below it."""

    def relevant(self, header, source=""):
        """Lines of the header at which Doxygen's complaint would count, had it complained at every line that isn't blank."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "a.h").write_text(header)
            (root / "a.cpp").write_text(source)
            lines = [number for number, line in enumerate(header.splitlines(), start=1) if line]
            log = "\n".join(f"{root}/a.h:{line}: warning: Member m (variable) of class A is not documented." for line in lines)
            return [int(warning.split(":")[1]) for warning in relevant_warnings(log, root)]

    def test_the_paragraph_is_covered_up_to_the_next_blank_line(self):
        self.assertEqual(self.relevant("/// Two.\nint a();\nint b();\n\nint c();\n"), [1, 5])

    def test_a_docstring_behind_covers_its_own_line_alone(self):
        self.assertEqual(self.relevant("int a;  ///< one\nint b;\n"), [2])

    def test_what_the_compiler_writes_needs_none(self):
        self.assertEqual(self.relevant("A(const A&) = default;\nA& operator=(const A&) = delete;\nA();\n"), [3])

    def test_a_comment_is_no_docstring(self):
        self.assertEqual(self.relevant("// Why.\nint a();\n"), [1, 2])

    def test_what_lives_in_a_source_file_alone_needs_none(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "a.h").write_text("int shown(int x);\n")
            (root / "a.cpp").write_text("")
            log = "".join(f"{root}/a.cpp:{line}: warning: Member {name}(int x) (function) of namespace n is not documented.\n"
                          for line, name in ((1, "hidden"), (2, "shown")))
            self.assertEqual(len(relevant_warnings(log, root)), 1)

    def test_other_warnings_count_once_each(self):
        self.assertEqual(relevant_warnings("a.md:1: warning: x\n\na.md:1: warning: x\n", "."), ["a.md:1: warning: x"])


class Links(unittest.TestCase):
    def dead(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder, name.replace("__", "/") + (".js" if name.startswith("search") else ".html"))
                path.parent.mkdir(exist_ok=True)
                path.write_text(text)
            return dead_links(folder)

    def test_living_ones(self):
        self.assertEqual(self.dead(a='<a href="b.html#x">b</a> <a href="#">top</a> <a href="https://example.org">c</a>',
                                   b='<h1 id="x">x</h1><img src="a.html">'), [])

    def test_dead_ones(self):
        for text, reason in (('<a href="c.html">', "no such file"), ('<a href="#y">', "no such anchor"),
                             ('<a\nhref="a.html#y">', "no such anchor"), ('<img src="c.png">', "no such file"),
                             ('<script src="c.js">', "no such file"), ('<link href="c.css">', "no such file"),
                             ('<a href="../x.html">', "leads out"), ('<a href="file:///etc/passwd">', "unknown scheme")):
            with self.subTest(text=text):
                dead = self.dead(a=text)
                self.assertEqual(len(dead), 1)
                self.assertIn(reason, dead[0])
                self.assertTrue(dead[0].startswith("a.html:1: "), dead[0])

    def test_dead_ones_in_the_searchs_data(self):
        data = "[['x',['../a.html#y',1,''],['../a.html',1,'']]]"
        self.assertEqual(self.dead(a="", search__all_0=data), ["search/all_0.js:1: a.html#y: there is no such anchor"])


class Parts(unittest.TestCase):
    def test_arrows_that_follow_from_others_are_not_drawn(self):
        uses = {"core": [], "math": ["core"], "curve": ["core", "math"], "shape": ["math", "curve"]}
        self.assertEqual(reduced(uses), {"core": [], "math": ["core"], "curve": ["math"], "shape": ["curve"]})

    def test_names_that_a_header_declares(self):
        header = """
class Forward;
/// class Comment
class Curve : public Base {
    int member() const;
};
enum class Kind { A, B };
using Pair = std::pair<int, int>;
std::vector<Curve> load(const std::string& name);
template <typename T>
T& twice(T x) {
    return x;
}
namespace detail {
int hidden();
}
"""
        self.assertEqual(declared_names(header), ["Curve", "Kind", "Pair", "load", "twice"])


if __name__ == "__main__":
    unittest.main()
