"""tools/docs: what is converted and how, and that each kind of mistake in a page or a header is found and named."""

import json
import shutil
import tempfile
import unittest
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from docs.builder import Builder
from docs.doxygen_warnings import relevant_warnings
from docs.links import dead_links
from docs.markdown import Converter
from docs.parts import declared_names, reduced
from docs.snippets import all_snippets
from docs.tree import Tree, github_anchor

CURVE = """#include "curve/curve.h"

int twice(int x) {
    //! [ex-01.1]
    const int sum = x + x;
    return sum;
    //! [ex-01.1]
}
"""
CURVE_HEADER = """#pragma once

namespace caustic {

/// Twice a number.
int twice(int x);

}  // namespace caustic
"""
LESSON = """# Curves

## The idea

Twice $x$ is $2x$:

[code: ex-01.1](../../common/curve/curve.cpp)
"""
DECLARATIONS = {
    "topics": {"core": [], "curve": ["core"]},
    "files": {"common/curve/curve.h": {"topic": "curve", "chapter": 1},
              "common/curve/curve.cpp": {"topic": "curve", "chapter": 1}},
    "chapters": {"01_curves": []},
}


class SmallTree(unittest.TestCase):
    """A tree with one chapter, one exercise and one lesson that shows it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "tree"
        self.write("README.md", "# Caustic\n\nSee [the idea](chapters/01_curves/README.md#the-idea).\n")
        self.write("GLOSSARY.md", "# Glossary\n\n## Curves\n")
        self.write("docs/architecture.md", "# Architecture\n\n## Topics\n\n<!-- site: topics -->\n\n<!-- site: library -->\n")
        self.write("chapters/01_curves/README.md", LESSON)
        self.write("chapters/01_curves/main.cpp", "int main() { return 0; }\n")
        self.write("common/curve/curve.cpp", CURVE)
        self.write("common/curve/curve.h", CURVE_HEADER)
        self.write("build/declarations.json", json.dumps(DECLARATIONS))

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def convert(self, text, path="chapters/01_curves/README.md"):
        """The page's text for Doxygen, without its title, and what is wrong with it."""
        self.write(path, f"# Title\n\n{text}")
        tree = Tree(self.root)
        converter = Converter(tree, tree.pages[path], all_snippets(self.root), {"stars": lambda page: "***"})
        converted = converter.convert().split("\n", 2)[2]
        return converted.strip(), [str(problem) for problem in converter.problems]

    def builder(self):
        return Builder(self.root, self.root / "build/docs", self.root / "build/declarations.json", DECLARATIONS)


class Markdown(SmallTree):
    def assert_converts(self, text, expected):
        self.assertEqual(self.convert(text), (expected, []))

    def test_formulas(self):
        self.assert_converts("a $x^2$, $y_i$.", r"a \f$x^2\f$, \f$y_i\f$.")
        self.assert_converts("$$\na\n+ b\n$$", r"\f[ a + b \f]")
        self.assert_converts("| $a$ | $b$ |", r"| \f$a\f$ | \f$b\f$ |")

    def test_what_is_no_formula(self):
        for text in ("from 5$ to 6$", "US$5 and US$6", r"\$x and \$y", "$ x $", "`$x$` and ``a`$x$``"):
            self.assert_converts(text, text)

    def test_code_stays_as_it_is(self):
        text = "```sh\necho $HOME $PATH [a](b)\n# no heading\n```\n\n~~~\n$x$\n```\n$y$\n~~~"
        self.assert_converts(text, text.replace("```sh", "```{.unparsed}", 1).replace("~~~", "~~~{.unparsed}", 1))
        self.assert_converts("- item\n\n  ```cpp\n  f($x$);\n  ```", "- item\n\n  ```{.cpp}\n  f($x$);\n  ```")

    def test_links_to_pages(self):
        target = "chapter_01_curves.html"
        self.write("docs/other.md", "# Other\n\n## A *nice* day, isn't it?\n\n## Curves\n\n## Curves\n")
        self.assertEqual(self.convert("[x](../../docs/other.md#a-nice-day-isnt-it)"),
                         ('<a href="other.html#other-a-nice-day-isnt-it">x</a>', []))
        self.assertEqual(self.convert("[x](../../docs/other.md#curves-1)"), ('<a href="other.html#other-curves-1">x</a>', []))
        self.assertEqual(self.convert("[`x`](../01_curves)"), (f'<a href="{target}">`x`</a>', []))
        self.assertEqual(self.convert("## Here\n\n[x](#here)")[0].splitlines()[-1],
                         f'<a href="{target}#chapter_01_curves-here">x</a>')

    def test_links_to_files_wait_for_doxygen(self):
        self.assert_converts("[x](../../common/curve/curve.cpp#L3)", '<a href="tree:/common/curve/curve.cpp#L3">x</a>')
        self.assert_converts("[x](https://example.org/a_b)", "[x](https://example.org/a_b)")

    def test_pictures_keep_their_path(self):
        self.write("figures/01_curves/a.png", "")
        converted, problems = self.convert('![a "b"](../../figures/01_curves/a.png)')
        self.assertIn('<img src="files/figures/01_curves/a.png" alt="a &quot;b&quot;"', converted)
        self.assertEqual(problems, [])

    def test_snippets_come_with_their_place_and_without_indentation(self):
        converted, problems = self.convert("[code: ex-01.1](../../common/curve/curve.cpp)")
        self.assertIn("~~~~{.cpp}\nconst int sum = x + x;\nreturn sum;\n~~~~", converted)
        self.assertIn("common/curve/curve.cpp:5</a>", converted)
        self.assertEqual(problems, [])

    def test_a_snippet_in_a_list_stays_in_it(self):
        converted = self.convert("- so:\n\n  [code: ex-01.1](../../common/curve/curve.cpp)")[0]
        self.assertIn("\n  ~~~~{.cpp}\n  const int sum = x + x;\n  return sum;\n  ~~~~", converted)

    def test_a_snippet_link_within_a_sentence_is_a_link(self):
        self.assertNotIn("~~~~", self.convert("see [code: ex-01.1](../../common/curve/curve.cpp)")[0])

    def test_generated_parts(self):
        self.assert_converts("<!-- site: stars -->", "***")

    def test_headings_have_labels_that_are_unique_in_the_site(self):
        converted, _ = self.convert("## Bézier's `curve`\n\n## Bézier's `curve`")
        self.assertIn("{#chapter_01_curves-beziers-curve}", converted)
        self.assertIn("{#chapter_01_curves-beziers-curve-1}", converted)

    def test_anchors_are_githubs(self):
        self.assertEqual(github_anchor("C0, G1 and C1: what's new?"), "c0-g1-and-c1-whats-new")
        self.assertEqual(github_anchor("The [glossary](GLOSSARY.md) of Bézier_curves"), "the-glossary-of-bézier_curves")


class Problems(SmallTree):
    """Each mistake is named with file and line."""

    def assert_problem(self, text, line, reason):
        problems = self.convert(text)[1]
        self.assertEqual(len(problems), 1, problems)
        self.assertTrue(problems[0].startswith(f"chapters/01_curves/README.md:{line}: "), problems[0])
        self.assertIn(reason, problems[0])

    def test_in_a_page(self):
        self.assert_problem("a\n\n[code: ex-01.2](../../common/curve/curve.cpp)", 5, "no code marked //! [ex-01.2]")
        self.assert_problem("[code: ex-01.1](../../common/curve/curve.h)", 3, "not in common/curve/curve.h")
        self.assert_problem("one\ntwo [x](missing.md) three", 4, "dead link: there is no chapters/01_curves/missing.md")
        self.assert_problem("[x](../../README.md#missing)", 3, "no heading #missing")
        self.assert_problem("![x](missing.png)", 3, "no picture")
        self.assert_problem("![x](https://example.org/x.png)", 3, "without a network")
        self.assert_problem(r"\snippet common/curve/curve.cpp ex-01.1", 3, "[code: ex-NN.k]")
        self.assert_problem("| a |\n| --- |\n| $|x|$ |", 5, "write \\lvert")
        self.assert_problem("<!-- site: moons -->", 3, "generates no 'moons'")

    def test_none_in_a_tree_without_mistakes(self):
        self.assertEqual(self.builder().lesson_problems(), [])

    def test_an_exercise_that_its_lesson_does_not_show(self):
        self.write("chapters/01_curves/README.md", "# Curves\n")
        problems = [text for text in self.builder().lesson_problems() if "ex-01.1" in text]
        self.assertEqual(problems, ["common/curve/curve.cpp:5: the lesson of chapter 01 shows ex-01.1 0 times instead of once"])

    def test_an_exercise_shown_twice(self):
        self.write("chapters/01_curves/README.md", LESSON + "\n" + LESSON.splitlines()[-1])
        self.assertEqual(len(self.builder().lesson_problems()), 1)

    def test_an_exercise_shown_by_another_page(self):
        self.write("docs/other.md", "# Other\n\n[code: ex-01.1](../common/curve/curve.cpp)\n")
        self.assertEqual(self.builder().lesson_problems(), ["docs/other.md:1: it shows ex-01.1, which is another chapter's"])

    def test_code_that_is_no_exercise_is_shown(self):
        self.write("common/curve/loop.h", "void f() {\n    //! [the-loop]\n    g();\n    //! [the-loop]\n}\n")
        self.assertEqual(self.builder().lesson_problems(), ["common/curve/loop.h:3: no page shows the-loop; take the marker away"])
        self.write("chapters/01_curves/README.md", LESSON + "\n[code: the-loop](../../common/curve/loop.h)\n")
        self.assertEqual(self.builder().lesson_problems(), [])
        converted, problems = self.convert("[code: the-loop](../../common/curve/loop.h)")
        self.assertEqual(problems, [])
        self.assertIn("~~~~{.cpp}\ng();\n~~~~", converted)

    def test_an_exercise_within_shown_code_keeps_its_lines_and_loses_its_markers(self):
        self.write("common/curve/outer.cpp", "//! [outer]\n" + CURVE.replace("ex-01.1", "ex-03.1") + "//! [outer]\n")
        code = all_snippets(self.root)["outer"].code
        self.assertNotIn("//!", code)
        self.assertIn("return", code)

    def test_shown_code_without_its_second_marker_is_an_error(self):
        self.write("common/curve/loop.h", "//! [the-loop]\n")
        with self.assertRaisesRegex(CourseError, "loop.h:1: the-loop has no closing marker"):
            all_snippets(self.root)

    def test_an_exercise_of_a_chapter_to_come_waits_for_its_lesson(self):
        self.write("common/curve/patch.cpp", CURVE.replace("ex-01.1", "ex-03.1"))
        self.assertEqual(self.builder().lesson_problems(), [])

    def test_a_link_to_what_a_students_tree_leaves_out(self):
        link = "[the tests](../../tests/course/test_docs.py)"
        self.assertEqual(len(self.convert(link)[1]), 1)
        self.write(".course/student.json", "{}")
        self.assertEqual(self.convert(link), ("the tests", []))
        self.assertEqual(len(self.convert("[x](../../tests/missing.cpp)")[1]), 1)

    def test_a_tree_without_front_page(self):
        (self.root / "README.md").unlink()
        self.assertIn("README.md:1: it is missing", self.builder().lesson_problems()[0])


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
