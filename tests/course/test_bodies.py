"""tools/exercises/bodies.py and splicing.py: which bodies are taken, and what else of a file counts. Nothing is built here."""

import unittest

import strip
from course_lib.paths import ROOT
from exercises.bodies import complaint_about, tokens, worth_a_look
from exercises.splicing import Spliced, decoded

STARTER = """#include "a.h"

namespace caustic {

int one() {
    //! [ex-01.1]
    throw NotImplemented("ex-01.1");
    //! [ex-01.1]
}

int two() {
    //! [ex-01.2]
    throw NotImplemented("ex-01.2");
    //! [ex-01.2]
}

}  // namespace caustic
"""
SOLVED = STARTER.replace('throw NotImplemented("ex-01.1");', "return 1;").replace('throw NotImplemented("ex-01.2");', "return 2;")

HONEST = (
    "// the #1 case\nreturn 1;\n",
    "/* } # fork() { */ return 1;\n",
    'log("# } fork {"); return 1;\n',
    'const auto t = R"(\n#include <x>\n } )"; return 1;\n',
    "const char c = '}'; const char d = '\\''; const char e = '#'; return 1;\n",
    "const int million = 1'000'000; return 0x1p-3 < 1e+5 ? million : 1;\n",
    "const auto help = [](double x) { return x < 0 ? -x : x; };\nreturn help(1);\n",
    "struct Pair { int a; int b; };\nreturn Pair{1, 2}.a;\n",
    "stream.read(buffer); file.write(x); list.open(); return 1;\n",
    "const auto thread = 1; const int open = 2, signal = 3; return thread + open + signal;\n",
    "if (open and signal) return thread;\n",
    "const Node& open = nodes.front(); auto& pipe = open; return pipe;\n",
    "int test = 1; return a ? b : test;\n",
    "return __builtin_clz(3u) + __builtin_popcountll(7);\n",
    "// caf\udce9 in Latin-1, \u4e2d\u6587 in Chinese\nreturn 1;\n",
    "std::printf(\"%d\\n\", 1); return std::remove(a.begin(), a.end(), 0) - a.begin();\n",
)

REFUSED = {
    "closes what the body did not open": (
        "return 1; }\nint evil() { return 2;\n", "/* { */ }\n", '"{" }\n', "// {\n}\n", 'R"({)" }\n', "'{' }\n", "{ } }{\n"),
    "is not closed": ("if (x) {\n", "/* } */ {\n", 'R"(})" {\n', "1'0 {\n"),
    "has no end": ("/* no end\n", 'f("no end\n', "'no end\n", 'R"(no end\n', 'R"x( )" )y"\n'),
    "is a preprocessor line": ("#define EXPECT_EQ(a, b)\n", "/**/ # undef EXPECT_EQ\n", "%:define X\n", "int a;\n  #include </etc/passwd>\n",
                               'R"(\n)"\n#undef X\n', "import <fstream>;\n", "??=define X\n"),
    "joins it with the next": ("// a comment \\\nreturn 1;\n", "sys\\\ntem(1);\n", "// \\  \n"),
    "is an old way to write a brace": ("%> int evil() <%\n",),
    "is no part of a text file": ("return 1;\0\n",),
    "stands outside of a text": ("\\u0066ork();\n",),
    "is reserved for the compiler": (
        "_Pragma(\"x\")\n", "__asm__(\"\");\n", "struct X { __attribute__((constructor)) static void f() {} };\n",
        "__builtin_return_address(0);\n", "__libc_start_main;\n"),
    "is assembler": ("asm(\".incbin \\\"x\\\"\");\n",),
    "is a linkage specification": ('extern "C" int puts(const char*);\n', "extern int secret;\n"),
    "is an attribute of the compiler": ("struct X { [[gnu::constructor]] static void f() {} };\n", "[[using gnu: used]] int x;\n"),
    "is of the test kit": ("EXPECT_EQ(1, 1);\n", "ASSERT_TRUE(true);\n", "testing::UnitTest::GetInstance();\n", "test::agree(1);\n",
                           "::testing::Test t;\n", "namespace t = testing;\n", "GTEST_SKIP();\n", "SUCCEED();\n"),
    "is of the operating system": (
        "fork();\n", "::fork();\n", "std::system(\"x\");\n", "system(\"x\");\n", "execve(a, b, c);\n", "execl(a, b);\n",
        "syscall(1);\n", "dlopen(a, 1);\n", "dlsym(a, b);\n", "ptrace(0);\n", "std::getenv(\"A\");\n", "auto w = write;\n", "::write(3, a, 1);\n",
        "::open(a, 0);\n", "open(a, 0);\n", "auto o = &open;\n", "kill(getppid(), 9);\n", "std::ifstream file(a);\n", "std::basic_ofstream<char> f;\n",
        "std::FILE* f;\n", "std::fopen(a, b);\n", "stdout->_fileno = 4;\n", "std::filesystem::exists(a);\n",
        "std::thread t(f);\n", "using namespace std;\nthread t(f);\n", "timer_create(a);\n", "thrd_create(a);\n", "pthread_create(a);\n", "std::atexit(f);\n", "longjmp(a, 1);\n", "char** e = environ;\n",
        'f("/proc/self/cmdline");\n', 'f("/dev/fd/4");\n', 'f(R"(/proc/1)");\n', "posix_spawn(a);\n", "mprotect(a, b, c);\n"),
}


class Bodies(unittest.TestCase):
    def test_honest_bodies_are_taken(self):
        for body in HONEST:
            self.assertIsNone(complaint_about(body), body)

    def test_all_bodies_of_the_reference_are_taken_and_none_is_worth_a_look(self):
        exercises = strip.exercises_of_tree(ROOT)
        self.assertGreater(len(exercises), 0)
        for exercise in exercises.values():
            body = strip.body(strip.read_source(ROOT / exercise.path), exercise)
            self.assertIsNone(complaint_about(body), exercise.id)
            self.assertEqual(worth_a_look(body), [], exercise.id)

    def test_all_that_alternatives_and_mistakes_write_is_taken(self):
        patches = [path for kind in ("mistakes", "alternatives") for path in (ROOT / "tests").glob(f"*/{kind}/*.patch")]
        for path in patches:
            written = [line[1:] for line in path.read_text().splitlines() if line.startswith("+") and not line.startswith("+++")]
            for line in written:
                complaint = complaint_about(line + "\n")
                self.assertTrue(complaint is None or "brace" in complaint.reason or "'{'" in complaint.reason
                                or "'}'" in complaint.reason or "no end" in complaint.reason, f"{path}: {line}: {complaint}")

    def test_what_is_no_body_is_refused_with_its_reason(self):
        for reason, bodies in REFUSED.items():
            for body in bodies:
                complaint = complaint_about(body)
                self.assertIsNotNone(complaint, body)
                self.assertIn(reason, complaint.reason, body)

    def test_the_line_of_a_complaint_is_its_own(self):
        self.assertEqual(complaint_about("int a;\n/* two\nlines */\nfork();\n").line, 4)
        self.assertEqual(complaint_about("int a;\n// x \\\n").line, 2)

    def test_every_file_of_the_library_is_read_to_its_end(self):
        for path in (ROOT / "common").rglob("*"):
            if path.suffix in (".h", ".cpp"):
                self.assertGreater(len(tokens(strip.read_source(path))), 0, path)

    def test_what_an_attack_needs_is_worth_a_look(self):
        self.assertEqual(worth_a_look("auto p = reinterpret_cast<char*>(1); // union\n"), ["reinterpret_cast"])
        for body in ("*(int*)8 = 1;\n", "g((char*)&x);\n", "(const T * *)(y);\n"):
            self.assertEqual(worth_a_look(body), ["a cast to a pointer"], body)
        for body in ("return (a * b) * (c);\n", "auto f = [](const T*) { return 1; };\n", "f(*p);\n"):
            self.assertEqual(worth_a_look(body), [], body)


class Splicing(unittest.TestCase):
    def spliced(self, theirs, starter=STARTER):
        spliced = Spliced()
        spliced.add("a.cpp", starter, theirs if theirs is None else theirs.encode())
        return spliced

    def test_bodies_are_put_into_our_file(self):
        spliced = self.spliced(SOLVED)
        self.assertEqual((spliced.texts, spliced.notes, spliced.refused), ({"a.cpp": SOLVED}, [], {}))

    def test_what_is_outside_of_a_body_does_not_count_and_that_is_said(self):
        changes = {'#include <fcntl.h>\n' + SOLVED: 1, SOLVED.replace("int two()", "static const int x = 1;\nint two()"): 11,
                   SOLVED + "struct Leave { Leave() { leave(); } } leave_;\n": 18, SOLVED.replace("int one", "long one"): 5}
        for theirs, line in changes.items():
            spliced = self.spliced(theirs)
            self.assertEqual(spliced.texts["a.cpp"], SOLVED)
            self.assertEqual(spliced.notes, [f"a.cpp:{line}: changed outside of an exercise's body, which does not count"])

    def test_comments_and_white_space_may_change_everywhere(self):
        theirs = "// Ada's\n" + SOLVED.replace("int one() {", "int  one()\n{  /* mine */")
        self.assertEqual(self.spliced(theirs).notes, [])

    def test_a_refused_body_costs_its_own_exercise_only(self):
        spliced = self.spliced(SOLVED.replace("return 1;", "return 1;\n    fork();"))
        self.assertEqual(spliced.refused, {
            "ex-01.1": "a.cpp:8: 'fork' is of the operating system (call it something else, if it is yours)"})
        self.assertEqual(spliced.texts["a.cpp"], STARTER.replace('throw NotImplemented("ex-01.2");', "return 2;"))

    def test_missing_files_and_markers_are_noted(self):
        self.assertEqual(self.spliced(None).notes, ["a.cpp is missing; its exercises count as not done"])
        self.assertIn("has no closing marker", self.spliced(SOLVED.replace("    //! [ex-01.2]\n}", "}")).notes[0])
        without = SOLVED.replace("    //! [ex-01.2]\n", "")
        self.assertEqual(self.spliced(without).notes, ["a.cpp: the markers of ex-01.2 are missing; it counts as not done"])

    def test_markers_that_hide_in_a_text_or_comment_end_the_body(self):
        for start, end in (('const auto x = R"(\n', ')";\n'), ("/*\n", "*/\n")):
            theirs = SOLVED.replace("return 1;", f"return 1;\n{start}    //! [ex-01.1]\n}}\nint evil() {{ return 3; }}\n{end}")
            self.assertNotIn("evil", self.spliced(theirs).texts["a.cpp"])

    def test_any_editors_files_are_read(self):
        for theirs in (SOLVED.replace("\n", "\r\n").encode(), SOLVED.replace("\n", "\r").encode(), SOLVED.encode("utf-16"),
                       b"\xef\xbb\xbf" + SOLVED.encode()):
            self.assertEqual(decoded(theirs), SOLVED)

    def test_what_a_person_should_look_at_is_said(self):
        spliced = self.spliced(SOLVED.replace("return 2;", "return *reinterpret_cast<int*>(1);"))
        self.assertEqual(spliced.looks, ["a.cpp:12: ex-01.2 has reinterpret_cast: a person should look at it"])


if __name__ == "__main__":
    unittest.main()
