"""./course mutants --systematic: what the operators make, and how mutants are told apart."""

import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from course_lib.errors import CourseError
from mutation.known import KnownOutcomes
from mutation.mutants import Target, mutants_of, squeezed
from mutation.operators import OPERATORS
from mutation.operators_types import Context
from mutation.same_code import same_as_last
from mutation.schema import blamed, make_schema
from mutation.signature import read_signature
from mutation.store import Store
from mutation.structure import Body
from strip import body as body_of
from strip import find_exercises

FILE = """#include "a.h"

namespace caustic {

%s {
    //! [ex-01.1]
%s    //! [ex-01.1]
}

}  // namespace caustic
"""


def target_of(head, *lines):
    text = FILE % (head, "".join(f"    {line}\n" for line in lines))
    exercise = find_exercises(text, "common/a/a.cpp")[0]
    before = text[:text.index("//! [")]
    return Target(exercise, text, body_of(text, exercise), read_signature(before, exercise.place).result)


def made(operator, head, *lines, enumerations=None):
    """What an operator makes of a body: the changed lines as they become."""
    target = target_of(head, *lines)
    before = target.source[:target.source.index("//! [")]
    context = Context(read_signature(before, "a.cpp:5"), enumerations or {})
    bodies = []
    for start, end, text in OPERATORS[operator](Body(target.body), context):
        changed = target.body[:start] + text + target.body[end:]
        bodies.append(" ".join(changed.split()))
    return bodies


class Signatures(unittest.TestCase):
    def read(self, head):
        return read_signature(f"namespace a {{\n\nint before() {{ return 1; }}\n\n{head} {{\n", "a.cpp:5")

    def test_the_type_and_the_parameters_are_read(self):
        found = self.read("std::optional<Hit> Ball::intersect(const Ray& ray, Real, Vec2 u) const")
        self.assertEqual(found.result, "std::optional<Hit>")
        self.assertEqual([(p.type, p.name) for p in found.parameters], [("Ray", "ray"), ("Real", ""), ("Vec2", "u")])

    def test_templates_attributes_and_operators_are_not_of_the_type(self):
        self.assertEqual(self.read("template <typename T, int N>\nstatic BasicInterval<T> f(const M<T, N>& x, T y)").result,
                         "BasicInterval<T>")
        self.assertEqual(self.read("[[nodiscard]] inline const Vec3& Mesh::at(int i)").result, "const Vec3&")
        self.assertEqual(self.read("private:\n    // Splits it.\n    void split(int x)").result, "void")

    def test_what_is_no_function_is_refused(self):
        with self.assertRaisesRegex(CourseError, "a.cpp:5: mistakes by rule need a marker right behind a function's head"):
            self.read("struct A")
        with self.assertRaisesRegex(CourseError, "a function that says its type before its name"):
            self.read("A(int x)")


class Operators(unittest.TestCase):
    def test_comparisons_are_turned_and_made_strict(self):
        self.assertEqual(made("relation", "bool f(int a)", "return a < 1;"), ["return a <= 1;", "return a > 1;"])

    def test_template_arguments_are_no_comparisons(self):
        self.assertEqual(made("relation", "int f()", "std::vector<std::pair<int, int>> a;", "return g<1>(a);"), [])

    def test_signs_and_products(self):
        self.assertEqual(made("sign", "int f(int a)", "return -a + 1;"), ["return -a - 1;", "return a + 1;"])
        self.assertEqual(made("product", "int f(int a)", "return a * *b;"), ["return a / *b;"])

    def test_factors_and_terms_are_left_out(self):
        squeeze = [text.replace(" ", "") for text in made("factor", "int f(int a)", "return a * (b + c) / d + e;")]
        self.assertEqual(squeeze, ["return(b+c)/d+e;", "returna/d+e;", "returna*(b+c)+e;"])
        squeeze = [text.replace(" ", "") for text in made("term", "int f(int a)", "return a * b - c + d;")]
        self.assertEqual(squeeze, ["return-c+d;", "returna*b+d;", "returna*b-c;"])
        self.assertIn("return 1 / b;", made("factor", "int f(int a)", "return a / b;"))

    def test_bounds_are_exchanged_and_left_out(self):
        self.assertEqual(made("minmax", "int f(int a)", "return std::min(a, 2);"),
                         ["return std::max(a, 2);", "return (a);", "return (2);"])

    def test_numbers_are_off(self):
        self.assertEqual(made("constant", "int f(int a)", "return 0;"), ["return 1;"])
        self.assertEqual(made("constant", "int f(int a)", "return 3 + 100;"), ["return 4 + 100;", "return 2 + 100;", "return 3 + 50;"])
        self.assertEqual(made("constant", "int f(int a)", "return 1e-9;"), ["return 1e-06;", "return 0.0;"])

    def test_functions_are_left_out(self):
        self.assertEqual(made("call", "int f(int a)", "return std::abs(a).norm();"), ["return (a).norm();", "return std::abs(a);"])

    def test_conditions(self):
        self.assertEqual(made("logic", "int f(int a)", "if (!a || b) return c;", "return 2;"),
                         ["if (a || b) return c; return 2;", "if (!a && b) return c; return 2;", "if ( b) return c; return 2;",
                          "if (!a ) return c; return 2;"])
        self.assertEqual(made("choice", "int f(int a)", "return a > b ? 1 : 2;"), ["return true ? 1 : 2;", "return false ? 1 : 2;"])
        self.assertEqual(made("branch", "int f(int a)", "if (a) return 1;", "return 2;"),
                         ["if (true) return 1; return 2;", "if (!(a)) return 1; return 2;"])

    def test_statements_are_left_out_but_not_the_last_return(self):
        self.assertEqual(made("statement", "int f(int a)", "const auto g = [&](int b) { a += b; };", "if (a) g(1);", "return a;"),
                         ["const auto g = [&](int b) { ; }; if (a) g(1); return a;",
                          "const auto g = [&](int b) { a += b; }; ; return a;",
                          "const auto g = [&](int b) { a += b; }; if (a) ; return a;"])

    def test_loops_end_earlier(self):
        self.assertEqual(made("loop", "void f(int a)", "for (int i = 0; i < a; ++i) g(i);"),
                         ["for (int i = 0; 1 + i < a; ++i) g(i);", "for (int i = 0; i < a; ++i) { g(i); break; }"])

    def test_the_result_is_returned_early(self):
        self.assertEqual(made("early", "int f(int a)", "int b = a;", "b += 1;", "b += 2;", "return b;"),
                         ["int b = a; return b; b += 1; b += 2; return b;", "int b = a; b += 1; return b; b += 2; return b;"])

    def test_arguments_are_exchanged(self):
        self.assertEqual(made("exchange", "A f(int a)", "return {g(a, 1), 1};"), ["return {1, g(a, 1)};", "return {g(1, a), 1};"])

    def test_names_of_one_type_are_taken_for_one_another(self):
        self.assertEqual(made("parameter", "Real f(Real a, const Real& b, int c)", "return a + c;"), ["return b + c;"])
        self.assertEqual(made("local", "int f(int a)", "const Real b = 1;", "const Real c = b;", "return c;"),
                         ["const Real b = 1; const Real c = c; return c;", "const Real b = 1; const Real c = b; return b;"])
        self.assertEqual(made("enumerator", "int f(int a)", "return g(Mode::One);", enumerations={"Mode": ["One", "Two"]}),
                         ["return g(Mode::Two);"])
        self.assertEqual(made("twin", "int f(Vec3 a)", "return a.x() + hit.ns;"), ["return a.y() + hit.ns;", "return a.x() + hit.ng;"])

    def test_values_are_spoilt(self):
        self.assertEqual(made("precision", "int f(int a)", "return a;"), ["return mutation::narrowed(a);"])
        self.assertEqual(made("channel", "Color f(Color a)", "return a * 2;"),
                         ["return mutation::firstChannel(a * 2);", "return mutation::firstChannel(a) * 2;"])
        self.assertEqual(made("octant", "Real f(const Vec3& w)", "return w.z();"), ["return mutation::offInOctant(w.z(), w);"])


class Mutants(unittest.TestCase):
    def test_each_body_is_made_once_and_none_is_the_reference(self):
        target = target_of("int f(int a)", "int b = a * a;", "if (a < 1 && b > 2) return 0;", "return std::max(a, b - 1);")
        found = list(mutants_of(target, {}))
        bodies = {squeezed(m.body) for m in found}
        self.assertEqual(len(bodies), len(found))
        self.assertNotIn(squeezed(target.body), bodies)
        self.assertEqual(len({m.id for m in found}), len(found))

    def test_a_mutant_says_what_it_changes(self):
        target = target_of("int f(int a)", "int b = a;", "return b < 1;")
        found = next(m for m in mutants_of(target, {}) if m.becomes == "return b <= 1;")
        self.assertEqual((found.operator, found.was, found.place), ("relation", "return b < 1;", "common/a/a.cpp:8"))

    def test_the_compilers_errors_lead_to_the_mutant(self):
        target = target_of("int f(int a)", "return a < 1;")
        mutants = list(mutants_of(target, {}))
        schema = make_schema(target, mutants)
        lines = schema.text.split("\n")
        for mutant, (first, last) in zip(mutants, schema.lines):
            self.assertEqual("\n".join(lines[first:last - 1]).strip(), mutant.becomes)
        first, second = (schema.lines[i][0] for i in (0, 1))
        output = (f"x.h: In instantiation of g:\nsrc/a.cpp:{first}:5:   required from here\nx.h:3:4: error: no\n"
                  f"src/a.cpp:{second}:9: note: declared here\n")
        self.assertEqual(blamed(output, "src/a.cpp", schema), {0})


class Known(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("library.o", "one.o", "two.o"):
            self.write(name, name)
        self.write("one.cpp", "TEST(A, One) {\n}\n")
        self.write("two.cpp", "TEST_F(A, Two) {\n}\n")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def known(self):
        toolchain = SimpleNamespace(
            library_words=("-la",), library_objects=(self.folder / "library.o",),
            test_objects={name: self.folder / f"{name}.o" for name in ("one", "two")},
            test_sources={name: self.folder / f"{name}.cpp" for name in ("one", "two")})
        return KnownOutcomes(Store(self.folder / "outcomes.jsonl"), toolchain)

    def kept(self, changed, state, by="", path="common/a/a.cpp"):
        """Whether an outcome is still known when an object has changed."""
        mutant = SimpleNamespace(exercise="ex-01.1", body=f"{changed} {state} {path}", path=path)
        outcome = {"state": state, "by": by}
        self.known().put(mutant, outcome)
        self.assertEqual(self.known().get(mutant), outcome)
        before = (self.folder / changed).read_text(encoding="utf-8")
        self.write(changed, "another")
        found = self.known().get(mutant)
        self.write(changed, before)
        return found is not None

    def test_what_was_caught_depends_on_the_file_that_caught_it(self):
        self.assertTrue(self.kept("one.o", "caught", "A.Two"))
        self.assertFalse(self.kept("two.o", "caught", "A.Two"))

    def test_what_escaped_may_be_caught_by_any_file(self):
        self.assertFalse(self.kept("one.o", "escaped"))
        self.assertFalse(self.kept("two.o", "escaped"))

    def test_what_compiles_depends_on_tests_only_in_a_header(self):
        self.assertTrue(self.kept("one.o", "invalid"))
        self.assertFalse(self.kept("one.o", "equivalent", path="common/a/a.h"))

    def test_nothing_is_known_of_another_library(self):
        for state in ("caught", "escaped", "invalid", "equivalent"):
            self.assertFalse(self.kept("library.o", state, "A.One" if state == "caught" else ""))


def function(name, *lines):
    return "\n".join([f"\t.type\t{name}, @function", f"{name}:", ".LFB7:", *lines, f"\t.size\t{name}, .-{name}", ""])


class SameCode(unittest.TestCase):
    DATA = "\t.section\t.rodata.cst8\n.LC0:\n\t.long\t1\n.LC1:\n\t.long\t2\n.LC2:\n\t.long\t1\n"

    def same(self, *bodies):
        names = [f"_Z1fvENKUlvE{'' if i == 0 else i - 1}_clEv" for i in range(len(bodies))]
        return same_as_last("\t.text\n" + "".join(function(n, *b) for n, b in zip(names, bodies)) + self.DATA, len(bodies))

    def test_labels_may_be_called_otherwise(self):
        self.assertEqual(self.same([".L2:", "\tjmp\t.L2"], [".L4:", "\tjmp\t.L5", ".L5:"], [".L7:", "\tjmp\t.L7"]), {0})

    def test_constants_count_by_what_they_hold(self):
        self.assertEqual(self.same(["\tmovsd\t.LC0(%rip), %xmm0"], ["\tmovsd\t.LC1(%rip), %xmm0"],
                                   ["\tmovsd\t.LC2(%rip), %xmm0"]), {0})

    def test_without_bodies_nothing_is_said(self):
        self.assertIsNone(same_as_last("\t.text\n" + function("_Z1gv", "\tret"), 2))


if __name__ == "__main__":
    unittest.main()
