"""docs/architecture.md leads where it says: each name that it links to a header is declared there."""

import re
import unittest

from course_lib.paths import ROOT

PAGE = ROOT / "docs" / "architecture.md"
LINK = re.compile(r"\[`(?P<name>[\w:]+)`\]\((?P<path>\.\./common/[^)#]+\.h)\)")


def body_of(header, name):
    """What a class declares; empty when the header declares no such class."""
    found = re.search(rf"^(?:class|struct) {name}\b[^;{{]*\{{\n(.*?)^\}};", header, re.MULTILINE | re.DOTALL)
    return found[1] if found else ""


def declares(header, name):
    """Whether a header declares a class, a function, or `Class::member`."""
    owner, _, member = name.rpartition("::")
    scope = body_of(header, owner) if owner else header
    code = re.sub(r"//[^\n]*", "", scope)
    return re.search(rf"\b(?:class|struct) {member}\b[^;]*\{{|\b{member}\(", code) is not None


class ADatumsWay(unittest.TestCase):
    def test_each_step_is_declared_where_its_link_leads(self):
        links = [(found["name"], found["path"]) for found in LINK.finditer(PAGE.read_text(encoding="utf-8"))]
        self.assertGreater(len(links), 25)
        for name, path in links:
            with self.subTest(name=name):
                header = (PAGE.parent / path).read_text(encoding="utf-8")
                self.assertTrue(declares(header, name), f"{path} declares no {name}")

    def test_what_is_not_declared_is_found(self):
        header = "/// Not f(x) but\nclass A : public B {\npublic:\n    void f() const;  // g()\n};\nstruct C;\nint h(int);\n"
        declared = {name for name in ("A", "A::f", "h", "A::g", "A::h", "f2", "C", "B", "C::f") if declares(header, name)}
        self.assertEqual(declared, {"A", "A::f", "h"})


if __name__ == "__main__":
    unittest.main()
