"""A student's way through the toy course: start, check, status, next, hint, edit, diff, reset, submit, grade."""

import json
import shutil
import subprocess
import unittest
import zipfile

import strip
from toy_course import ToyCase, course, outcomes, reference_body, solve, where, write_body

SUMS = "common/math/sums.cpp"
BODIES = ("sum += value", "most = value > most", "total(values) / static_cast", "return value > high", "*= weights[i]")


class Loop(ToyCase):
    """Trees are shared: each test starts from the files and memory of the untouched one, with its build."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.draw_reference_figures()
        cls.tree = cls.top / "student"
        cls.started = course(cls.toy, "start", cls.tree)
        assert cls.started.returncode == 0, cls.started.stderr

    @classmethod
    def draw_reference_figures(cls):
        """What ./course figures commits."""
        built = course(cls.toy, "build", "--preset", "student", "--target", "01_first")
        assert built.returncode == 0, built.stderr
        program = cls.toy / "build/student/bin/01_first"
        subprocess.run([program, "--quality", "report"], cwd=cls.toy, check=True)

    def setUp(self):
        for path in (self.tree / ".course/starter").rglob("*.*"):
            place = self.tree / path.relative_to(self.tree / ".course/starter")
            if place.read_bytes() != path.read_bytes():
                place.write_bytes(path.read_bytes())
        (self.tree / ".course/state.json").unlink(missing_ok=True)
        shutil.rmtree(self.tree / ".course/undo", ignore_errors=True)

    def run_course(self, *words, code=0):
        ended = course(self.tree, *words)
        self.assertEqual(ended.returncode, code, ended.stdout + ended.stderr)
        return ended.stdout

    def test_start_makes_a_tree_of_its_own_without_solutions(self):
        self.assertIn("5 exercises to write", self.started.stdout)
        for part in ("course", "tools/course.py", "CMakeLists.txt", "tests/01_first/grading.json", SUMS):
            self.assertTrue((self.tree / part).exists(), part)
        for folder in ("mistakes", "alternatives"):
            self.assertFalse((self.tree / "tests/01_first" / folder).exists(), "Do patches show the solution?")
        for path in self.tree.rglob("*"):
            if path.is_file() and ".git" not in path.parts and "build" not in path.parts:
                text = path.read_bytes().decode("utf-8", "replace")
                self.assertFalse([body for body in BODIES if body in text], path)

    def test_start_commits_the_starter(self):
        log = subprocess.run(["git", "-C", self.tree, "log", "--format=%s"], stdout=subprocess.PIPE, text=True).stdout
        self.assertEqual(log, "The starter\n")
        status = subprocess.run(["git", "-C", self.tree, "status", "--porcelain"], stdout=subprocess.PIPE, text=True).stdout
        self.assertEqual(status, "", "Is everything committed, and what is built or remembered ignored?")

    def test_start_with_a_later_chapter_solves_those_before(self):
        tree = self.top / "from_second"
        ended = course(self.toy, "start", tree, "--chapter", "2")
        self.assertIn("1 exercise to write", ended.stdout)
        self.assertEqual((tree / SUMS).read_bytes(), (self.toy / SUMS).read_bytes())
        self.assertIn("NotImplemented(\"ex-02.1\")", (tree / "common/math/products.cpp").read_text())
        self.assertTrue((tree / "tests/01_first/mistakes").exists())
        status = course(tree, "status").stdout
        self.assertIn("02_second", status)
        self.assertNotIn("01_first", status)
        for words, reason in ((("hint", "ex-01.1"), "there is no exercise 'ex-01.1' to write; there are ex-02.1"),
                              (("diff", "01"), "chapter 01_first was solved when this tree was made"),
                              (("submit", "01"), "chapter 01 was solved when this tree was made")):
            self.assertIn(reason, course(tree, *words).stderr)

    def test_start_refuses_what_it_would_spoil(self):
        full = self.top / "full"
        full.mkdir()
        (full / "thesis.txt").write_text("mine")
        for words, reason in (((full,), "is not empty"), ((full / "thesis.txt",), "is a file"),
                              ((self.toy / "common/student",), "lies in the course's own tree"),
                              ((self.top / "x", "--chapter", "9"), "--chapter can be 1, 2")):
            ended = course(self.toy, "start", *words)
            self.assertEqual(ended.returncode, 1)
            self.assertIn(reason, ended.stderr)
            self.assertEqual(ended.stderr.count("\n"), 1)
        self.assertIn("student's tree already", course(self.tree, "start", self.top / "y").stderr)
        self.assertEqual((full / "thesis.txt").read_text(), "mine")

    def test_the_way_through_the_first_chapter(self):
        self.assertIn("not checked yet: ./course check 01", self.run_course("status"))
        untouched = self.run_course("next")
        self.assertNotIn("build", untouched, "What is there to try before a line is written?")
        self.assertIn("Sums.TotalAddsAllValues (40 points): not run", untouched)

        first = self.run_course("check", "01", code=1)
        self.assertNotIn("warning", first)
        self.assertIn("01_first: 0 of 100 points", first)
        self.assertIn(f"4 of 4 exercises to do; start with ex-01.1 in {SUMS}:8: A sum", first)
        for test, exercise in (("Sums.TotalAddsAllValues", "ex-01.1"), ("Clamp.StaysWithinBounds", "ex-01.4")):
            self.assertRegex(first, rf"{test} +{exercise} +0/\d+ +not implemented")

        upcoming = self.run_course("next")
        self.assertNotIn("build", upcoming, "Is it built again although nothing has changed?")
        for part in ("ex-01.1  A sum (about 5 minutes)", f"{SUMS}:8", "Sums.TotalAddsAllValues (40 points)",
                     "./course hint ex-01.1 (2 hints left)"):
            self.assertIn(part, upcoming)
        for said in (first, upcoming):
            self.assertNotIn("Which values are added.", said, "What to look at is for who has tried.")
            self.assertIn("chapters/01_first/README.md", said)

        write_body(self.tree, "ex-01.1", "double sum = 0;\nfor (double v : values) sum += v > 0 ? v : 0;\nreturn sum;")
        self.assertIn("changed since", self.run_course("status"))
        wrong = self.run_course("next")
        self.assertIn("Does every value count, whatever its sign?", wrong)
        self.assertIn("Which values are added.", wrong)

        solve(self.tree, self.toy, "ex-01.1")
        third = self.run_course("check", code=1)
        self.assertIn("01_first: 40 of 100 points", third)
        self.assertIn("3 of 4 exercises to do; start with ex-01.2", third)
        self.assertRegex(third, r"bars\.png +the same as the reference +build/check/01/bars\.png")
        self.assertRegex(third, r"mean +waits for ex-01\.3")
        self.assertTrue((self.tree / "build/check/01/bars.png").read_bytes().startswith(b"\x89PNG"))
        self.assertRegex(self.run_course("status"), r"ex-01\.1 +A sum +40/40 +done")
        again = self.run_course("check", code=1)
        self.assertNotIn("draw 01_first", again)
        self.assertIn("./course check 01 --pictures draws them again", again)
        self.assertIn("draw 01_first", self.run_course("check", "--pictures", code=1))

        solve(self.tree, self.toy, "ex-01.2", "ex-01.3", "ex-01.4")
        done = self.run_course("check", "01")
        self.assertIn("01_first: 100 of 100 points", done)
        self.assertIn("All 4 exercises done", done)
        self.assertIn("ex-02.1  A weighted sum", self.run_course("next"))
        self.assertIn("02_second: 0 of 100", self.run_course("check", code=1), "Does check go on to the unfinished chapter?")
        solve(self.tree, self.toy, "ex-02.1")
        self.assertNotIn("changed since", self.run_course("status", "01"), "A later chapter's file changes nothing in an earlier one.")

        packed = self.run_course("submit", "01")
        self.assertIn("The last check gave it 100 of 100 points.", packed)
        ended = course(self.toy, "grade", "01", "--submission", self.tree / "build/submission_01.zip", *where())
        self.assertIn("01_first: 100 of 100 points", ended.stdout)

    def test_what_is_written_and_waits_for_a_later_exercise_does_not_hold_the_student_up(self):
        write_body(self.tree, "ex-01.1", "return mean(values) * static_cast<double>(values.size() + 0 * values.capacity());")
        checked = self.run_course("check", "01", "--no-pictures", code=1)
        self.assertIn("note: ex-01.1 is written, and its tests wait for ex-01.3\n", checked)
        self.assertIn("start with ex-01.2", checked)
        self.assertTrue(self.run_course("next").startswith("ex-01.2 "))
        self.assertRegex(self.run_course("status"), r"ex-01\.1 +A sum +0/40 +waits for ex-01\.3 ")
        for id in ("ex-01.2", "ex-01.4", "ex-02.1"):
            solve(self.tree, self.toy, id)
        self.assertRegex(self.run_course("next"), r"(?m)^ex-01\.3  ", "Is it what the other one waits for?")

    def test_results_come_back_with_an_earlier_state_of_the_files(self):
        self.run_course("check", "01", "--no-pictures", code=1)
        solve(self.tree, self.toy, "ex-01.1")
        self.run_course("check", "01", "--no-pictures", code=1)
        solve(self.tree, self.toy, "ex-02.1")
        self.assertNotIn("changed since", self.run_course("status"), "Does a later chapter change an earlier one's results?")
        self.run_course("reset", "1.1")
        status = self.run_course("status")
        self.assertNotIn("changed since", status)
        self.assertRegex(status, r"ex-01\.1 +A sum +0/40 +not implemented")

    def test_a_compile_error_is_shown_with_its_place(self):
        solve(self.tree, self.toy, "ex-01.1")
        write_body(self.tree, "ex-01.2", "return nothing;")
        broken = self.run_course("check", "01", code=1)
        line = strip.exercises_of_tree(self.tree)["ex-01.2"].first + 1
        self.assertIn(f"01_first does not build: {SUMS}:{line}:12: error: 'nothing' was not declared", broken)
        self.assertEqual(broken.count("error: "), 1, broken)
        self.assertRegex(broken, r"Sums\.LargestIsTheLargest +ex-01\.2 +0/30 +did not build")
        self.assertRegex(broken, r"Sums\.TotalAddsAllValues +ex-01\.1 +40/40 +passed")
        self.assertIn("Make it compile", broken)
        self.assertIn("did not build", self.run_course("status"))
        self.assertIn("make it compile", self.run_course("next"))

    def test_what_does_not_count_is_said_at_once_and_is_not_counted(self):
        solve(self.tree, self.toy, "ex-01.1", "ex-01.2")
        path = self.tree / SUMS
        path.write_text("static double helped(double x) { return x; }\n" + path.read_text().replace("sum += value", "sum += helped(value)")
                        .replace("double most", "EXPECT_EQ(1, 1);\n    double most"))
        outside = f"note: {SUMS}:1: changed outside of an exercise's body, which does not count"
        for words, code, refusal in ((("check", "01", "--no-pictures"), 1, "is refused"), (("submit", "01"), 0, "will be refused")):
            said = self.run_course(*words, code=code)
            self.assertIn(outside, said)
            self.assertIn(f"note: ex-01.2 {refusal}: {SUMS}:18: 'EXPECT_EQ' is of the test kit", said)
        self.assertIn("0 of 100 points", said)
        ended = course(self.toy, "grade", "01", "--submission", self.tree / "build/submission_01.zip", *where())
        for part in (outside, f"note: ex-01.2 is refused: {SUMS}:18", "01_first: 0 of 100 points", "'helped' was not declared"):
            self.assertIn(part, ended.stdout)

    def test_a_crash_and_an_endless_loop_are_told_apart(self):
        write_body(self.tree, "ex-01.1", "volatile int* nowhere = nullptr;\nreturn *nowhere;")
        write_body(self.tree, "ex-01.4", "for (volatile int i = 0;; i = i + 1) {\n}\nreturn value + low + high;")
        solve(self.tree, self.toy, "ex-01.2")
        checked = self.run_course("check", "01", "--time-limit", "2", "--no-pictures", code=1)
        self.assertRegex(checked, r"Sums\.TotalAddsAllValues .* crashed +segmentation fault")
        self.assertRegex(checked, r"Sums\.LargestIsTheLargest .* 30/30 +passed")
        self.assertRegex(checked, r"Clamp\.StaysWithinBounds .* timed out +was still running after 2 s")

    def test_a_wrong_picture_shows_its_difference(self):
        write_body(self.tree, "ex-01.1", "return values.empty() ? 0 : values[1];")
        solve(self.tree, self.toy, "ex-01.2")
        checked = self.run_course("check", "01", code=1)
        self.assertRegex(checked, r"bars\.png +not right: 10 % of the pixels differ, around \d+,\d+ by \d+ of 255 on average"
                                  r" +build/check/01/bars\.png", "41 x 40 of 160 x 100 pixels should differ")

    def test_a_finished_chapter_is_checked_again_when_its_files_have_changed(self):
        solve(self.tree, self.toy, "ex-01.1", "ex-01.2", "ex-01.3", "ex-01.4")
        self.run_course("check", "--no-pictures")
        write_body(self.tree, "ex-01.1", reference_body(self.toy, "ex-01.1").replace("sum;", "values.size() == 3 && values[0] == 10 ? 9 : sum;"))
        right = self.run_course("check", code=1)
        self.assertIn("01_first was finished, but its files have changed since", right)
        self.assertRegex(right, "(?s)01_first: 100 of 100 points.*02_second: 0 of 100 points")
        self.assertIn("All tests pass, but when the pictures were drawn last, bars.png differed from the reference", right)
        write_body(self.tree, "ex-01.4", "return value > high ? high : value > low ? value : value;")
        wrong = self.run_course("check", code=1)
        self.assertIn("01_first: 90 of 100 points", wrong)
        self.assertEqual(wrong.count("graded_sums.cpp:"), 2, "One line is in a loop: its first failure is enough.")
        self.assertIn("(the first of 50 failures on this line)", wrong)
        self.assertNotIn("02_second", wrong, "What is red comes first.")

    def test_all_that_is_built_in_a_students_tree_is_built_by_one_rule(self):
        write_body(self.tree, "ex-01.1", "const int unused = 3.7;\nreturn values.front();")
        self.run_course("build", "--target", "caustic_math_01")
        self.assertRegex(self.run_course("check", "01", "--no-pictures", code=1), rf"note: {SUMS}:9:\d+: warning: .*3\.7")

    def test_hints_come_one_by_one(self):
        self.assertIn("hint 1 of 2: Start with 0.", self.run_course("hint", "ex-01.1"))
        self.assertIn("hint 2 of 2: Then add each value.", self.run_course("hint", "1.1"))
        again = self.run_course("hint", "01.1")
        self.assertIn("1 of 2: Start with 0.", again)
        self.assertIn("2 of 2: Then add each value.", again)
        self.assertIn("there is no exercise 'ex-01.5'", course(self.tree, "hint", "ex-01.5").stderr)

    def test_diff_shows_what_is_changed(self):
        self.assertIn("nothing is changed yet", self.run_course("diff", "01"))
        solve(self.tree, self.toy, "ex-01.3")
        changes = self.run_course("diff", "1")
        self.assertIn('-    throw NotImplemented("ex-01.3");', changes)
        self.assertIn("+    return total(values)", changes)
        self.assertIn("nothing is changed yet", self.run_course("diff", "02"))

    def test_reset_puts_one_exercise_back_and_keeps_what_was_there(self):
        solve(self.tree, self.toy, "ex-01.1", "ex-01.3")
        kept = self.run_course("reset", "ex-01.1").split()[-1]
        self.assertEqual((self.tree / kept).read_text().strip().splitlines()[0].strip(),
                         reference_body(self.toy, "ex-01.1").splitlines()[0])
        text = (self.tree / SUMS).read_text()
        self.assertIn('throw NotImplemented("ex-01.1")', text)
        self.assertNotIn('throw NotImplemented("ex-01.3")', text)
        self.assertIn("already", self.run_course("reset", "ex-01.1"))

    def test_broken_markers_are_explained_and_can_be_put_right(self):
        path = self.tree / SUMS
        path.write_text(path.read_text().replace("//! [ex-01.2]", "", 1))
        ended = course(self.tree, "reset", "ex-01.2")
        self.assertEqual(ended.returncode, 1)
        self.assertIn("./course reset ex-01.2 --whole-file", ended.stderr)
        self.run_course("reset", "ex-01.2", "--whole-file")
        self.assertEqual(path.read_bytes(), (self.tree / ".course/starter" / SUMS).read_bytes())

    def test_submit_packs_the_exercise_files_and_nothing_else(self):
        solve(self.tree, self.toy, "ex-01.1")
        self.assertIn("Not checked as it is now", self.run_course("submit", "02"))
        archive = self.tree / "build/submission_02.zip"
        first = archive.read_bytes()
        with zipfile.ZipFile(archive) as packed:
            names = sorted(packed.namelist())
            self.assertEqual(packed.read(SUMS), (self.tree / SUMS).read_bytes())
            manifest = json.loads(packed.read("manifest.json"))
        self.assertEqual(names, ["common/math/clamp.h", "common/math/products.cpp", SUMS, "manifest.json"])
        self.assertEqual(manifest["chapter"], "02_second")
        self.run_course("submit", "02")
        self.assertEqual(archive.read_bytes(), first, "Do the same files make the same archive?")

    def test_the_students_tree_is_a_grader_too(self):
        report = self.top / "own.json"
        self.run_course("grade", "01", "--submission", self.toy, "--json", report, *where())
        self.assertEqual(set(outcomes(json.loads(report.read_text())["chapters"][0]).values()), {"passed"})
        self.assertIn("needs the reference", course(self.tree, "grade", "02", "--submission", self.toy, "--on-reference").stderr)

    def test_the_references_own_tree_is_no_students(self):
        for words in (("diff", "01"), ("reset", "ex-01.1"), ("submit", "01")):
            ended = course(self.toy, *words)
            self.assertEqual((ended.returncode, ended.stderr.count("\n")), (1, 1))
            self.assertIn("make one: ./course start ../student", ended.stderr)
        self.assertIn("mistakes belong to the course's own", course(self.tree, "mutants").stderr)


if __name__ == "__main__":
    unittest.main()
