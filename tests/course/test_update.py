"""./course update on the toy course: what a student wrote stays, what the course changed comes, and what can't be both goes
aside."""

import json
import shutil
import subprocess
import unittest

import strip
from exercises import student
from toy_course import course, reference_body, solve, write_body
from updated_course import CLAMP, MINE, PRODUCTS, SUMS, Updating, replace, snapshot

MARKER = "    //! [ex-01.{}]\n"


class Update(Updating):
    def test_an_unchanged_course_changes_nothing(self):
        write_body(self.tree, "ex-01.1", MINE)
        before = snapshot(self.tree)
        self.assertIn("This tree is as new as that.", self.update())
        self.assertEqual(snapshot(self.tree), before)

    def test_an_untouched_tree_becomes_what_start_would_make(self):
        self.change_much()
        self.update()
        self.assertEqual(snapshot(self.tree), snapshot(self.as_started()))

    def test_bodies_stay_and_all_around_them_comes(self):
        self.change_much()
        write_body(self.tree, "ex-01.1", MINE)
        write_body(self.tree, "ex-02.1", "return 0 * static_cast<double>(values.size() + weights.size());")
        said = self.update()
        self.assertIn("yours    ex-01.1: what you wrote stays", said)
        self.assertIn("to write ex-02.2", said)
        self.assertEqual(reference_body(self.tree, "ex-01.1"), MINE + "\n")
        self.assertIn("0 * static_cast", reference_body(self.tree, "ex-02.1"))
        wanted = snapshot(self.as_started())
        self.assertEqual({name for name, found in snapshot(self.tree).items() if wanted.get(name) != found}, {SUMS, PRODUCTS})
        self.assertIn("/// New words.", (self.tree / SUMS).read_text())
        self.assertIn("another chapter", (self.tree / "chapters/03_third/main.cpp").read_text())
        self.assertFalse((self.tree / "tests/01_first/mistakes").exists(), "Do patches show the solution?")
        self.assertIn("This tree is as new as that.", self.update())

    def test_a_body_whose_function_changed_goes_aside_and_its_stub_comes(self):
        self.change_much()
        write_body(self.tree, "ex-01.2", "return values.back();")
        write_body(self.tree, "ex-01.4", "return value + low + high;")
        said = self.update()
        self.assertIn("aside    ex-01.2.cpp: its function has changed; yours goes to .course/aside/", said)
        self.assertIn("aside    ex-01.4.h: it is no exercise any more", said)
        self.assertEqual(set(self.asides()), {"ex-01.2.cpp", "ex-01.4.h"})
        self.assertEqual(self.asides()["ex-01.2.cpp"], f"// ex-01.2, as you had it at {SUMS}:14: its function has changed.\n"
                         "double largest(const std::vector<double>& values) {\n    return values.back();\n")
        self.assertIn('throw NotImplemented("ex-01.2")', reference_body(self.tree, "ex-01.2"))
        self.assertEqual((self.tree / CLAMP).read_bytes(), (self.new / CLAMP).read_bytes())

    def test_words_and_spaces_of_a_head_may_change(self):
        replace(self.new / SUMS, "double total(const std::vector<double>& values) {",
                "double total(\n    const std::vector<double>&  values  /* all */) {")
        write_body(self.tree, "ex-01.1", MINE)
        self.update()
        self.assertEqual((reference_body(self.tree, "ex-01.1"), self.asides()), (MINE + "\n", {}))

    def test_an_exercise_that_moved_takes_its_body_along(self):
        text = (self.new / SUMS).read_text()
        begin, end = text.index("double mean("), text.index("}  // namespace")
        (self.new / SUMS).write_text(text[:begin] + text[end:])
        replace(self.new / PRODUCTS, "}  // namespace", text[begin:end] + "}  // namespace")
        write_body(self.tree, "ex-01.3", "return total(values);")
        self.update()
        self.assertEqual(strip.exercises_of_tree(self.tree)["ex-01.3"].path, PRODUCTS)
        self.assertEqual((reference_body(self.tree, "ex-01.3"), self.asides()), ("return total(values);\n", {}))

    def test_what_both_changed_goes_aside_by_name(self):
        test = "tests/01_first/graded_sums.cpp"
        replace(self.new / SUMS, "double mean(", "/// New words.\ndouble mean(")
        replace(self.new / test, "total({}), 0", "total({}), 0.0")
        (self.new / "chapters/02_second/main.cpp").unlink()
        write_body(self.tree, "ex-01.1", MINE)
        replace(self.tree / SUMS, "namespace caustic {", "// mine\nnamespace caustic {")
        (self.tree / test).write_text("// my test\n")
        (self.tree / "chapters/02_second/main.cpp").write_text("// my main\n")
        mine = (self.tree / SUMS).read_text()
        said = self.update()
        for part in (f"{SUMS}: changed by you and by the course outside of bodies", f"{test}: changed by you and by the course;",
                     "chapters/02_second/main.cpp: changed by you, and the course has it no more"):
            self.assertIn(part, said)
        self.assertEqual(self.asides(), {SUMS: mine, test: "// my test\n", "chapters/02_second/main.cpp": "// my main\n"})
        self.assertEqual(reference_body(self.tree, "ex-01.1"), MINE + "\n", "Does the body stay where the file is the course's?")
        self.assertNotIn("// mine", (self.tree / SUMS).read_text())
        self.assertEqual((self.tree / test).read_bytes(), (self.new / test).read_bytes())
        self.assertFalse((self.tree / "chapters/02_second").exists())

    def test_what_the_student_alone_changed_stays(self):
        replace(self.new / PRODUCTS, "return total", "return 1 * total")  # a body: none of what is given out
        (self.tree / "notes.txt").write_text("to do\n")
        write_body(self.tree, "ex-01.1", MINE)
        replace(self.tree / SUMS, "namespace caustic {", "// mine\nnamespace caustic {")
        replace(self.tree / CLAMP, "    //! [ex-01.4]\n    throw", "    throw")  # a marker is lost
        (self.tree / "tests/01_first/graded_sums.cpp").write_text("// my test\n")
        (self.tree / "chapters/02_second/main.cpp").unlink()
        before = snapshot(self.tree)
        self.update()
        self.assertEqual(snapshot(self.tree), before)

    def test_broken_markers_in_a_file_that_changes_put_all_of_it_aside(self):
        self.change_much()
        write_body(self.tree, "ex-01.1", MINE)
        replace(self.tree / SUMS, MARKER.format(3) + "    throw", "    throw")
        mine = (self.tree / SUMS).read_text()
        self.assertIn(f"aside    {SUMS}: ", self.update())
        self.assertEqual(self.asides()[SUMS], mine)
        self.assertIn('throw NotImplemented("ex-01.1")', reference_body(self.tree, "ex-01.1"))

    def test_a_dry_run_tells_all_and_changes_nothing(self):
        self.change_much()
        write_body(self.tree, "ex-01.2", "return values.back();")
        before = snapshot(self.tree)
        said = self.update("--dry-run")
        for part in ("new      chapters/03_third/main.cpp", f"changed  {SUMS}", "removed  chapters/02_second/main.cpp",
                     "ex-01.2.cpp: its function has changed; yours would go to .course/aside/", "to write ex-02.2"):
            self.assertIn(part, said)
        self.assertEqual(snapshot(self.tree), before)

    def test_the_updated_tree_works_with_the_new_tools(self):
        self.change_much()
        solve(self.tree, self.toy, "ex-01.1")
        self.update()
        overview = course(self.tree).stdout
        self.assertIn("fresh", overview)
        self.assertIn("of now: ", overview)
        self.assertNotIn("  bench ", overview)
        self.assertIn("ex-01.1", course(self.tree, "diff", "01").stdout)
        self.assertEqual(course(self.tree, "submit", "01").returncode, 0)

    def test_it_comes_from_a_repository_too(self):
        self.change_much()
        git = ["git", "-C", self.new, "-c", "user.name=a", "-c", "user.email=a@b"]
        for words in (["init", "-q", "-b", "main"], ["add", "-A"], ["commit", "-q", "-m", "new"]):
            subprocess.run([*git, *words], check=True)
        bare = self.top / "bare.git"
        subprocess.run(["git", "clone", "-q", "--bare", self.new, bare], check=True)
        self.addCleanup(shutil.rmtree, bare)
        commit = subprocess.run([*git, "rev-parse", "HEAD"], stdout=subprocess.PIPE, text=True).stdout.strip()
        write_body(self.tree, "ex-01.1", MINE)
        for source in (bare.as_uri(), bare):
            said = self.update(source=source)
        self.assertIn("This tree is as new as that.", said)
        self.assertEqual(json.loads((self.tree / student.STUDENT).read_text()), {"firstChapter": 1, "course": commit})
        self.assertEqual(reference_body(self.tree, "ex-01.1"), MINE + "\n")

    def test_it_comes_from_a_students_tree_too(self):
        self.change_much()
        publisher = self.top / "publisher"
        shutil.rmtree(publisher, ignore_errors=True)
        self.assertEqual(course(self.new, "start", publisher).returncode, 0)
        write_body(publisher, "ex-01.1", "return 1;")  # none of what is given out
        self.update(source=publisher)
        self.assertEqual({**snapshot(self.tree, ".course/student.json")},
                         {**snapshot(self.as_started(), ".course/student.json")})

    def test_chapters_that_were_solved_stay_solved(self):
        later = self.top / "later"
        shutil.rmtree(later, ignore_errors=True)
        self.assertEqual(course(self.toy, "start", later, "--chapter", "2").returncode, 0)
        self.change_much()
        self.assertEqual(course(later, "update", "--from", self.new).returncode, 0)
        self.assertEqual((later / SUMS).read_bytes(), (self.new / SUMS).read_bytes())
        self.assertIn('throw NotImplemented("ex-02.1")', (later / PRODUCTS).read_text())
        self.assertIn("starts with an earlier chapter than 02", course(later, "update", "--from", self.tree).stderr)

    def test_errors_are_one_line_and_change_nothing(self):
        before = snapshot(self.tree)
        empty = self.top / "empty"
        empty.mkdir(exist_ok=True)
        (self.new / "tests/damaged").mkdir()
        for source, reason in (("nowhere", "there is no folder nowhere"), (empty, "has no course; give the folder in which"),
                               (self.tree, "--from names this very tree"),
                               ((self.top / "none.git").as_uri(), "none.git cannot be fetched: fatal: ")):
            said = self.update(source=source, code=1)
            self.assertIn(reason, said)
            self.assertEqual(said.count("\n"), 1, said)
        replace(self.new / SUMS, MARKER.format(2) + "    double most", "    double most")
        self.assertIn(f"{SUMS}:23: ex-01.3 is nested in ex-01.2", self.update(code=1))
        self.assertIn("say where the course is", course(self.tree, "update").stderr)
        self.assertIn("not a student's", course(self.toy, "update", "--from", self.new).stderr)
        self.assertEqual(snapshot(self.tree), before)


if __name__ == "__main__":
    unittest.main()
