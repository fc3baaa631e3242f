"""The Chinese pages say what the English ones say: the same sections with the same formulas, pictures, code, links and numbers."""

import re
import unittest
from collections import Counter
from pathlib import PurePosixPath

from course_lib.paths import ROOT
from docs.markdown import GENERATED, INLINE, SLIDER, SNIPPET_LINE, TABLE_RULE
from docs.tree import CHINESE, FENCE, HEADING, Tree, english

ITEM = re.compile(r"^\s*(-|\d\.) ")
EXERCISE = re.compile(r"^\| (ex-\d\d\.\d+) \|.*?\| (`[^|]+`) \| (\d+) \| (\d+) \|", re.MULTILINE)
NUMBER = re.compile(r"\d+(?:[.,]\d+)*")
WORDS_IN_A_FORMULA = re.compile(r"\\text\{[^}]*\}")
# What GitHub wants beside a formula within a line: the line's end, a space or a sign of ASCII.
FREE = re.compile(r"^[\s!-/:-@\[-`{-~]?$")
SWITCH = {"en": "[中文]({})", "zh": "[English]({})"}


def sections(text):
    """A page cut at its headings: the lines of each, the heading first; what a fence holds is a line of its own."""
    found, fence = [[]], None
    for line in text.splitlines():
        matched = FENCE.match(line)
        if fence:
            found[-1][-1] += "\n" + line
            if matched and line.strip() == fence:
                fence = None
            continue
        if matched:
            fence = matched[1]
        elif HEADING.match(line):
            found.append([])
        found[-1].append(line)
    return found


def outline(lines):
    """What stands in a section in which order: the heading's level, code, pictures, displayed formulas, lists, tables."""
    found, text = [], "\n".join(lines)
    for block in re.split(r"\n\s*\n", text):
        first = block.strip().split("\n")[0]
        if HEADING.match(first):
            found.append(("heading", len(HEADING.match(first)[1])))
        if FENCE.match(first):
            found.append(("fence", block.strip()))
            continue
        for line in block.splitlines():
            if SNIPPET_LINE.match(line):
                found.append(("code", SNIPPET_LINE.match(line).groups()[1:]))
            elif GENERATED.match(line) or SLIDER.match(line):
                found.append(("site", line.split('"')[0]))
            elif TABLE_RULE.match(line):
                found.append(("table", line.count("|")))
            elif line.startswith("|"):
                found.append(("row", line.replace(r"\|", "").count("|")))
            elif ITEM.match(line):
                found.append(("item", ITEM.match(line)[1]))
        for matched in INLINE.finditer(block):
            if matched["display"] is not None:
                found.append(("formula", plain_formula(matched["display"])))
            elif matched["image"] is not None:
                found.append(("picture", matched["image"]))
    return found


def plain_formula(formula):
    return " ".join(WORDS_IN_A_FORMULA.sub("", formula).split())


def words(lines):
    """What a section holds within its text, in any order: formulas, code, links and numbers."""
    text = "\n".join(line for line in lines if not FENCE.match(line) and not SNIPPET_LINE.match(line))
    found = Counter()
    left = INLINE.sub(lambda matched: counted(matched, found), text)
    found.update(("number", number) for number in NUMBER.findall(left))
    return found


def counted(matched, found):
    """Counts what a part of the text is and returns what is left of it to be read."""
    if matched["code"] is not None:
        found[("code", " ".join(matched["code"].split()))] += 1
    elif matched["formula"] is not None:
        found[("formula", plain_formula(matched["formula"]))] += 1
    elif matched["target"] is not None:
        target = matched["target"].split("#")
        # Headings have other names in other languages.
        found[("link", target[0].replace(CHINESE, ".md") + ("#" if len(target) > 1 else ""))] += 1
        return INLINE.sub(lambda inner: counted(inner, found), matched["text"])
    for kind in ("strong", "emphasis"):
        if matched[kind] is not None:
            return INLINE.sub(lambda inner: counted(inner, found), matched[kind])
    return " " if matched["alt"] is None else matched["alt"]


def without_switch(text, path):
    """The page without the line that leads to the other language; it stands below the title."""
    language, other = ("zh", english(path)) if path.name.endswith(CHINESE) else ("en", path.with_name(path.stem + CHINESE))
    lines = text.splitlines()
    if len(lines) < 3 or lines[2] != SWITCH[language].format(other.name):
        raise AssertionError(f"{path}:3: here is to stand {SWITCH[language].format(other.name)}")
    return "\n".join(lines[:2] + lines[3:])


def differences(chinese, english_text):
    """Where two pages differ in what both are to have; one line for each section."""
    ours, theirs = sections(chinese), sections(english_text)
    if len(ours) != len(theirs):
        return [f"{len(ours) - 1} headings instead of {len(theirs) - 1}"]
    found = []
    for mine, other in zip(ours, theirs):
        name = mine[0] if mine else "the beginning"
        if outline(mine) != outline(other):
            found.append(f"{name}: it has {outline(mine)} instead of {outline(other)}")
        for what, more in (("lacks", words(other) - words(mine)), ("has besides", words(mine) - words(other))):
            if more:
                found.append(f"{name}: it {what} {dict(more)}")
    return found


class Translations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = Tree(ROOT)
        cls.pages = {page.path: (ROOT / page.path).read_text(encoding="utf-8") for page in cls.tree.chinese()}

    def test_the_front_page_and_the_first_lessons_are_there(self):
        self.assertIn(PurePosixPath("README.zh.md"), self.pages)
        lessons = [self.tree.chapter_of(page) for page in self.tree.chapters("zh")]
        self.assertEqual(lessons, [self.tree.chapter_of(page) for page in self.tree.chapters()][:len(lessons)])

    def test_both_say_the_same(self):
        for path, text in self.pages.items():
            with self.subTest(page=str(path)):
                other = (ROOT / english(path)).read_text(encoding="utf-8")
                self.assertEqual(differences(without_switch(text, path), without_switch(other, english(path))), [])

    def test_both_have_the_same_exercises(self):
        for page in self.tree.chapters("zh"):
            with self.subTest(page=str(page.path)):
                exercises = EXERCISE.findall(self.pages[page.path])
                self.assertGreaterEqual(len(exercises), 4)
                self.assertEqual(exercises, EXERCISE.findall((ROOT / english(page.path)).read_text(encoding="utf-8")))

    def test_links_stay_in_the_language_where_they_can(self):
        for path, text in self.pages.items():
            for matched in re.finditer(r"\]\(([^)#\s]+\.md)", "\n".join(text.splitlines()[3:])):
                target = (ROOT / path.parent / matched[1]).resolve()
                with self.subTest(page=str(path), link=matched[1]):
                    self.assertFalse(target.with_name(target.stem + CHINESE).exists() and not matched[1].endswith(CHINESE))

    def test_formulas_stand_free_as_github_wants_them(self):
        for path, text in self.pages.items():
            for matched in INLINE.finditer(text):
                if matched["formula"] is not None:
                    with self.subTest(page=str(path), formula=matched[0]):
                        end = matched.end("formula") + 1
                        self.assertRegex(text[matched.start() - 1], FREE)
                        self.assertRegex(text[end:end + 1], FREE)
            loose = re.findall(r"[^\s!-~]\$|\$[^\s!-~]", re.sub(r"```.*?```", "", text, flags=re.DOTALL))
            self.assertEqual(loose, [], path)


class Differences(unittest.TestCase):
    PAGE = "# T\n\na $x$ `b` [l](m.md#n) 3\n\n$$ y $$\n\n![p](q.png)\n\n| a | b |\n| - | - |\n| 1 | 2 |\n\n- i\n\n```sh\n# c\n```\n\n## S\n"

    def test_each_kind_is_found(self):
        self.assertEqual(differences(self.PAGE, self.PAGE), [])
        for old, new in (("$x$", "$z$"), ("`b`", "`c`"), ("m.md", "k.md"), (" 3", " 4"), ("$$ y $$", "$$ z $$"), ("q.png", "r.png"),
                         ("| 1 | 2 |\n", ""), ("- i", "i"), ("# c", "# d"), ("## S", "### S"), ("## S", "S")):
            with self.subTest(new=new):
                self.assertNotEqual(differences(self.PAGE.replace(old, new), self.PAGE), [])

    def test_words_may_differ(self):
        other = self.PAGE.replace("# T", "# 题").replace("a $x$", "甲 $x$").replace("#n", "#天").replace("![p]", "![图]").replace("m.md", "m.zh.md")
        self.assertEqual(differences(other, self.PAGE), [])


if __name__ == "__main__":
    unittest.main()
