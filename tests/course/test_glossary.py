"""GLOSSARY.md keeps its word: what it names for a chapter that stands, the library declares."""

import re
import unittest

from course_lib.chapters import all_chapters
from course_lib.paths import ROOT

HEAD = "| symbol | in code | meaning | unit, domain | ch. | source |"
# Topics of which every public type has a row: what light, lens and paths are made of.
COMPLETE = ("sampling", "texture", "material", "medium", "light", "camera", "scene", "integrator")
TYPE = re.compile(r"^(?:class|struct|enum class) (\w+)\b(?!\s*;)", re.MULTILINE)
CELLS = len(HEAD.strip("|").split("|"))


def rows():
    """(line, cells) of all rows of the tables that map symbols to names."""
    inside = False
    for number, line in enumerate((ROOT / "GLOSSARY.md").read_text(encoding="utf-8").splitlines(), start=1):
        if not line.startswith("|"):
            inside = False
        elif line == HEAD:
            inside = True
        elif inside and not line.startswith("| ---"):
            yield number, [cell.strip() for cell in line.strip("|").split("|")]


class Glossary(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.headers = [path.read_text(encoding="utf-8") for path in (ROOT / "common").rglob("*.h")]
        cls.standing = {int(chapter[:2]) for chapter in all_chapters()}

    def declares(self, name):
        """Whether a header has the name; of A::b, one that declares A and has b."""
        scope, _, member = name.rpartition("::")
        return any(re.search(rf"\b{member}\b", header) and
                   (not scope or re.search(rf"\b(class|struct|enum class|namespace) {scope}\b", header))
                   for header in self.headers)

    def test_rows_are_complete(self):
        found = list(rows())
        self.assertGreater(len(found), 100)
        for number, cells in found:
            with self.subTest(line=number):
                self.assertEqual(len(cells), CELLS, "Does a formula have a bar in it? Write \\lvert.")
                self.assertTrue(cells[2])
                self.assertRegex(cells[4], r"^(0[1-9]|1\d)\b", "the chapter that introduces it")

    def test_names_of_chapters_that_stand_are_declared(self):
        checked = 0
        for number, cells in rows():
            if int(cells[4][:2]) not in self.standing:
                continue
            for name in re.findall(r"`([^`]+)`", cells[1]):
                with self.subTest(line=number, name=name):
                    self.assertTrue(self.declares(name), "Is it called otherwise? Name and glossary have to agree.")
                checked += 1
        self.assertGreater(checked, 25)

    def test_every_public_type_of_light_transport_has_a_row(self):
        named = {part for _, cells in rows() for name in re.findall(r"`([^`]+)`", cells[1]) for part in name.split("::")}
        checked = 0
        for topic in COMPLETE:
            for header in sorted((ROOT / "common" / topic).glob("*.h")):
                for name in TYPE.findall(header.read_text(encoding="utf-8")):
                    with self.subTest(header=f"{topic}/{header.name}"):
                        self.assertIn(name, named, "Add it to the row of what it belongs to, or a row of its own.")
                    checked += 1
        self.assertGreater(checked, 60)

    def test_sources_are_listed(self):
        text = (ROOT / "GLOSSARY.md").read_text(encoding="utf-8")
        listed = re.findall(r"^\| ([^|]+) \|", text[text.index("## Sources"):], re.MULTILINE)
        for number, cells in rows():
            with self.subTest(line=number):
                self.assertTrue(not cells[5] or any(cells[5].startswith(source) for source in listed), cells[5])


if __name__ == "__main__":
    unittest.main()
