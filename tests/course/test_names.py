"""What lessons, hints, `lookAt` and docstrings name is there: in the code as a student sees it, without the bodies to be written."""

import json
import re
import unittest

from course_lib.chapters import all_chapters
from course_lib.paths import FIGURES, ROOT
from docs.markdown import INLINE
from docs.tree import FENCE
from strip import find_exercises

NAME = re.compile(r"[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*(?:\(\))?", re.ASCII)
FILE = re.compile(r"[\w-]+\.(?:csv|json|h|cpp)")
COMMAND = re.compile(r"\./course (\w[\w-]*).*")
# Names in a text without backquotes: A::b, a member_, aName, or call().
NAME_BY_SHAPE = re.compile(r"\b[A-Za-z_]\w*(?:::[A-Za-z_]\w*)+|\b[a-z]\w*_(?![\w{])|\b[a-z]+(?:[A-Z]\w*)+|\b[a-z]\w+(?=\(\))",
                           re.ASCII)
TEST_FILE = re.compile(r"\btests/[\w/]+(?:\.\w+)?")


def code_spans(text):
    """What stands in backquotes on a page, fences aside."""
    lines, fence = [], False
    for line in text.splitlines():
        if FENCE.match(line):
            fence = not fence
        elif not fence:
            lines.append(line)
    return [found["code"].strip("`") for found in INLINE.finditer("\n".join(lines)) if found["code"]]


def without_bodies(text, path):
    lines = text.splitlines()
    for exercise in reversed(find_exercises(text, path)):
        del lines[exercise.first:exercise.last - 1]
    return "\n".join(lines)


class Code:
    """The library, the chapters' own files and what their commands know, as a student has them."""

    def __init__(self):
        files = [path for folder in ("common", "chapters") for path in (ROOT / folder).rglob("*") if path.suffix in (".h", ".cpp")]
        self._texts = [without_bodies(path.read_text(encoding="utf-8"), str(path)) for path in files]
        self._words = {word for text in self._texts for word in re.findall(r"\w+", text)}
        self._files = {path.name for folder in ("common", "chapters", "tests") for path in (ROOT / folder).rglob("*.*")}
        self._files |= {path.name for path in FIGURES.rglob("*.*")}
        self._commands = {path.stem.replace("_", "-") for path in (ROOT / "tools" / "commands").glob("*.py")}

    def has(self, name):
        """Whether a name is declared; of A::b, in a file that declares A."""
        scope, _, member = name.removesuffix("()").rpartition("::")
        if scope.partition("::")[0] in ("std", "Eigen"):
            return True
        if not scope:
            return member in self._words
        declared = re.compile(rf"\b(?:class|struct|enum class|namespace) {scope.rpartition('::')[2]}\b")
        return any(declared.search(text) and re.search(rf"\b{member}\b", text) for text in self._texts)

    def missing(self, code):
        """What a span of code names that isn't there; None when all is well, or when it is no name at all."""
        command = COMMAND.fullmatch(code)
        if command:
            return None if command[1] in self._commands else command[1]
        if FILE.fullmatch(code):
            return None if code in self._files else code
        if NAME.fullmatch(code):
            return None if self.has(code) else code
        return next((name for name in NAME_BY_SHAPE.findall(code) if "/" not in code and not self.has(name)), None)


def names_in(text):
    """What a hint names, in backquotes or not."""
    return {code for code in re.findall(r"`([^`]+)`", text) if NAME.fullmatch(code)} | set(NAME_BY_SHAPE.findall(text))


class Names(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.code = Code()

    def test_lessons_name_what_is_there(self):
        checked = 0
        for chapter in all_chapters():
            spans = code_spans((ROOT / "chapters" / chapter / "README.md").read_text(encoding="utf-8"))
            with self.subTest(chapter=chapter):
                self.assertEqual([code for code in spans if self.code.missing(code)], [])
            checked += len(spans)
        self.assertGreater(checked, 300)

    def test_hints_name_what_is_there(self):
        checked = 0
        for chapter in all_chapters():
            catalog = json.loads((ROOT / "tests" / chapter / "grading.json").read_text(encoding="utf-8"))
            texts = [(id, hint) for id, one in catalog["exercises"].items() for hint in one["hints"]]
            texts += [(one["name"], one["lookAt"]) for one in catalog["tests"]]
            for where, text in texts:
                with self.subTest(of=where):
                    names = names_in(text)
                    self.assertEqual([name for name in sorted(names) if not self.code.has(name)], [], text)
                    checked += len(names)
        self.assertGreater(checked, 100)

    def test_docstrings_name_tests_that_are_there(self):
        for path in sorted((ROOT / "common").rglob("*.h")):
            for name in TEST_FILE.findall(path.read_text(encoding="utf-8")):
                with self.subTest(header=path.name):
                    self.assertTrue((ROOT / name).exists(), name)

    def test_what_is_missing_is_found(self):
        for code in ("slabIntervall", "Scene::demands", "Sceen::needs", "./course chek 02", "qantity.csv", "Ggx::lamda()",
                     "at(Dimension::vertx)"):
            self.assertTrue(self.code.missing(code), code)
        for code in ("slabInterval", "Scene::needs()", "std::max", "./course check 02", "quantity.csv", "-ffp-contract=off",
                     "Dimension::vertex(vertex, VertexUse::LightPoint)"):
            self.assertIsNone(self.code.missing(code), code)
        self.assertEqual(names_in("With shearedVertx(), `halve`, position_ and Ray::at: two words, v(x), 3 at (a) e.g. x_{0}."),
                         {"shearedVertx", "halve", "position_", "Ray::at"})

    def test_bodies_are_not_looked_at(self):
        text = "int a;\n//! [ex-01.1]\nint secret;\n//! [ex-01.1]\nint b;\n"
        self.assertNotIn("secret", without_bodies(text, "a.h"))
        self.assertIn("int b", without_bodies(text, "a.h"))


if __name__ == "__main__":
    unittest.main()
