"""tools/docs: what is converted and how, and that each kind of mistake in a page is found and named."""

import json
import unittest

from course_lib.errors import CourseError
from docs.snippets import all_snippets
from docs.tree import github_anchor

from docs_tree import CURVE, LESSON, SmallTree


class Markdown(SmallTree):
    def assert_converts(self, text, expected):
        self.assertEqual(self.convert(text), (expected, []))

    def test_formulas(self):
        self.assert_converts("a $x^2$, $y_i$.", r"a \f$x^2\f$, \f$y_i\f$.")
        self.assert_converts("$$\na\n+ b\n$$", r"\f[ a + b \f]")
        self.assert_converts("| $a$ | $b$ |\n| --- | --- |", r"| \f$a\f$ | \f$b\f$ |" + "\n| --- | --- |")

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

    def test_chinese_pages(self):
        path = "chapters/01_curves/README.zh.md"
        self.assertEqual(self.convert("一**点** $x$ ，*斜* $y$ 。", path), ("一<b>点</b> \\f$x\\f$，<em>斜</em> \\f$y\\f$。", []))
        self.write("README.zh.md", "# 题\n\n## 一\n\n## 二\n")
        self.assertEqual(self.convert("[x](../../README.zh.md#二)", path), ('<a href="zh_index.html#zh_index-2">x</a>', []))
        self.assertEqual(self.convert("[x](README.md)", path), ('<a href="chapter_01_curves.html">x</a>', []))
        self.write(path, LESSON)
        self.assertEqual(self.builder().lesson_problems(), [], "The English lesson alone is to show each exercise once.")

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
        self.assert_problem("| a |\n| --- |\n| b |\n\n| c |\n| d |", 7, "an empty line within the table")
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


if __name__ == "__main__":
    unittest.main()
