"""./course grade on the toy course: points, reports that fit their schemas, whose chapters are graded, clear errors."""

import json
import os
import unittest
from unittest import mock

from exercises.reports import write_file
from exercises.trees import starter_overlay
from schema_check import json_errors, read, xml_errors
from toy_course import ToyCase, course, grade, outcomes, where, write_body

SUMS, CLAMP, PRODUCTS = "common/math/sums.cpp", "common/math/clamp.h", "common/math/products.cpp"


class Grade(ToyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.starter = starter_overlay(cls.toy)

    def submission(self, name, files):
        top = self.top / name
        for path, content in files.items():
            (top / path).parent.mkdir(parents=True, exist_ok=True)
            (top / path).write_bytes(content)
        return top

    def reference_files(self, *paths):
        return {path: (self.toy / path).read_bytes() for path in paths}

    def grade_with_reports(self, *words):
        """Runs grade, checks each report against its schema, returns all three with what was printed."""
        paths = {kind: self.top / f"report.{kind}" for kind in ("json", "gradescope", "junit")}
        submitted = where() if "--submission" in words else ()
        ended = course(self.toy, "grade", *words, *submitted, *(word for kind, path in paths.items() for word in (f"--{kind}", path)))
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertEqual(json_errors(paths["json"], "grades.schema.json"), [])
        self.assertEqual(json_errors(paths["gradescope"], "gradescope.schema.json"), [])
        self.assertEqual(xml_errors(paths["junit"], "junit.xsd"), [])
        return read(paths["json"]), read(paths["gradescope"]), paths["junit"].read_text(), ended.stdout

    def test_the_reference_earns_all_points_of_all_chapters(self):
        grades, gradescope, junit, printed = self.grade_with_reports()
        self.assertEqual((grades["points"], grades["maxPoints"]), (200, 200))
        self.assertEqual((gradescope["score"], sum(test["max_score"] for test in gradescope["tests"])), (200, 200))
        self.assertEqual(junit.count("<testcase"), 5)
        self.assertNotIn("<failure", junit)
        self.assertIn("01_first: 100 of 100 points\n", printed)
        self.assertIn("02_second: 100 of 100 points\n", printed)

    def test_each_failing_test_costs_its_points_and_says_why(self):
        files = {**self.starter, **self.reference_files(CLAMP)}
        top = self.submission("partly", files)
        write_body(top, "ex-01.1", "double sum = 0;\nfor (double value : values) sum += value > 0 ? value : 0;\nreturn sum;")
        write_body(top, "ex-01.3", "return total(values) / static_cast<double>(values.size());")
        grades, gradescope, junit, printed = self.grade_with_reports("1", "--submission", top)
        graded = grades["chapters"][0]
        self.assertEqual(outcomes(graded), {
            "Sums.TotalAddsAllValues": "failed", "Sums.LargestIsTheLargest": "not implemented",
            "Sums.MeanIsTotalOverCount": "passed", "Clamp.StaysWithinBounds": "passed"})
        self.assertEqual(grades["points"], 30)
        self.assertEqual(graded["exercises"]["ex-01.1"], {"points": 0, "maxPoints": 40})
        self.assertEqual([test["score"] for test in gradescope["tests"]], [0, 0, 20, 10])
        self.assertEqual([test["number"] for test in gradescope["tests"]], ["1.1", "1.2", "1.3", "1.4"])
        self.assertIn("Does every value count, whatever its sign?", gradescope["tests"][0]["output"])
        self.assertIn("Look at: Which values are added.", gradescope["tests"][0]["output"])
        self.assertIn('failures="2" errors="0"', junit)
        self.assertRegex(printed, r"Sums\.TotalAddsAllValues +ex-01\.1 +0/40 +failed +Does every value count")

    def test_what_does_not_compile_costs_its_own_points_with_the_first_error(self):
        files = self.reference_files(CLAMP)
        files[SUMS] = (self.toy / SUMS).read_bytes().replace(b"double sum = 0;", b"double sum = zero;").replace(
            b"values.front();", b"values.front()")
        top = self.submission("broken", files)
        grades, gradescope, junit, printed = self.grade_with_reports("1", "--submission", top)
        error = f"{SUMS}:9:18: error: 'zero' was not declared in this scope"
        graded = grades["chapters"][0]
        self.assertEqual((graded["points"], graded["built"], graded["error"]), (10, False, error))
        self.assertEqual({test["name"]: (test["outcome"], test["reason"]) for test in graded["tests"]}, {
            "Sums.TotalAddsAllValues": ("did not build", error),
            "Sums.LargestIsTheLargest": ("did not build", f"{SUMS}:18:5: error: expected ',' or ';' before 'for'"),
            "Sums.MeanIsTotalOverCount": ("not implemented", "needs ex-01.1, which did not build"),
            "Clamp.StaysWithinBounds": ("passed", "")})
        self.assertIn(error, gradescope["output"])
        self.assertEqual((junit.count("<error"), junit.count("<failure")), (2, 1))
        self.assertIn(f"did not build: {error}", printed)

    def test_a_broken_template_costs_its_own_points(self):
        files = self.reference_files(SUMS)
        files[CLAMP] = (self.toy / CLAMP).read_bytes().replace(b"return low;", b"return low.least();")
        graded = grade(self.toy, "01", self.submission("template", files))
        self.assertEqual(graded["points"], 90)
        self.assertRegex(graded["error"], rf"{CLAMP}:11:\d+: error: request for member 'least'")

    def test_what_the_linker_misses_costs_its_own_file(self):
        files = self.reference_files(SUMS, CLAMP)
        files[SUMS] = files[SUMS].replace(b"return total(values) /", b"double helper(double);\n    return helper(1) * total(values) /")
        graded = grade(self.toy, "01", self.submission("linker", files))
        self.assertEqual(outcomes(graded)["Clamp.StaysWithinBounds"], "passed")
        self.assertIn("undefined reference", graded["error"])

    def test_a_chapter_can_be_graded_on_the_references_earlier_ones(self):
        top = self.submission("second_only", {**self.starter, **self.reference_files(PRODUCTS)})
        self.assertEqual(outcomes(grade(self.toy, "02", top)), {"Products.WeightsMultiplyValues": "not implemented"})
        on_reference = grade(self.toy, "02", top, "--on-reference")
        self.assertEqual(outcomes(on_reference), {"Products.WeightsMultiplyValues": "passed"})
        self.assertEqual(on_reference["notes"], [])

    def test_earlier_files_that_are_missing_are_noted(self):
        graded = grade(self.toy, "02", self.submission("without_first", self.reference_files(PRODUCTS)))
        self.assertEqual(graded["points"], 0)
        self.assertIn(f"{SUMS} is missing; its exercises count as not done", graded["notes"])

    def test_what_is_refused_costs_its_own_points_and_says_why(self):
        files = self.reference_files(SUMS, CLAMP)
        files[SUMS] = files[SUMS].replace(b"double most", b'#include "/etc/passwd"\n    double most')
        grades, gradescope, junit, printed = self.grade_with_reports("1", "--submission", self.submission("includes", files))
        reason = f"{SUMS}:17: this is a preprocessor line"
        self.assertEqual((grades["points"], outcomes(grades["chapters"][0])["Sums.LargestIsTheLargest"]), (70, "refused"))
        self.assertIn(f"ex-01.2: refused: {reason}", gradescope["tests"][1]["output"])
        self.assertIn(f"note: ex-01.2 is refused: {reason}", printed)
        self.assertNotIn("root:", json.dumps([grades, gradescope, junit, printed]))

    def test_a_warning_costs_nothing(self):
        files = self.reference_files(SUMS, CLAMP)
        files[SUMS] = files[SUMS].replace(b"double sum = 0;", b"double sum = 0;\n    int i = 2.5f;")
        self.assertEqual(grade(self.toy, "01", self.submission("warning", files))["points"], 100)

    def test_a_report_into_a_pipe_does_not_replace_it(self):
        pipe = self.top / "pipe"
        os.mkfifo(pipe)
        reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        write_file(pipe, b"points")
        self.assertTrue(pipe.is_fifo())
        self.assertEqual(os.read(reader, 100), b"points")

    def test_a_wrong_command_leaves_no_report_of_an_earlier_run(self):
        paths = [self.top / name for name in ("old.json", "old_gradescope.json", "old.xml")]
        for words in (("--submission", "none"), ("--time-limit", "0"), ("07",)):
            for path in paths:
                path.write_text("100 points")
            json_file, gradescope, junit = paths
            ended = course(self.toy, "grade", *words, *where(), "--json", json_file, "--gradescope", gradescope, "--junit", junit)
            self.assertEqual(ended.returncode, 1)
            self.assertEqual([path for path in paths if path.exists()], [], words)

    def test_a_refused_hand_in_gets_a_zero_with_the_reason(self):
        handed_in = self.submission("nothing", {"notes.txt": b""})
        paths = {kind: self.top / f"refused.{kind}" for kind in ("json", "gradescope", "junit")}
        paths["json"].write_text("100 points")
        ended = course(self.toy, "grade", "01", "--submission", handed_in, *where(),
                       *(word for kind, path in paths.items() for word in (f"--{kind}", path)))
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (1, 1))
        self.assertEqual(json_errors(paths["json"], "grades.schema.json"), [])
        self.assertEqual(json_errors(paths["gradescope"], "gradescope.schema.json"), [])
        self.assertEqual(xml_errors(paths["junit"], "junit.xsd"), [])
        grades, gradescope = read(paths["json"]), read(paths["gradescope"])
        self.assertEqual((grades["points"], gradescope["score"]), (0, 0))
        self.assertEqual(set(outcomes(grades["chapters"][0]).values()), {"refused"})
        for text in (grades["chapters"][0]["error"], gradescope["output"], paths["junit"].read_text(), ended.stderr):
            self.assertIn("holds no exercise file", text)
        self.assertIn("refused: ", gradescope["output"])

    def test_a_chapter_that_is_not_handed_in_costs_its_own_points(self):
        files = self.reference_files(SUMS, CLAMP)
        report = self.top / "one_chapter.json"
        ended = course(self.toy, "grade", "--submission", self.submission("one_chapter", files), "--on-reference", "--json", report,
                       *where())
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (1, 1))
        self.assertEqual([chapter["points"] for chapter in read(report)["chapters"]], [100, 0])

    def test_every_report_says_where_it_was_graded(self):
        files = self.reference_files(SUMS, CLAMP)
        top = self.submission("where", files)
        expected = "none: graded with --unsandboxed" if where() else "bubblewrap"
        for words, place in ((("--submission", top), expected), (("--submission", top, "--unsandboxed"), "none: graded with --unsandboxed")):
            grades, gradescope, junit, printed = self.grade_with_reports("1", *words)
            self.assertEqual((grades["sandbox"], grades["points"]), (place, 100))
            for text in (gradescope["output"], printed):
                self.assertIn(f"sandbox: {place}", text)
            self.assertIn(f'name="sandbox" value="{place}"', junit)

    def test_without_a_sandbox_grading_asks_for_leave(self):
        wanting = self.top / "bin"
        wanting.mkdir()
        (wanting / "bwrap").write_text("#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n")
        (wanting / "bwrap").chmod(0o755)
        with mock.patch.dict(os.environ, PATH=f"{wanting}:{os.environ['PATH']}"):
            ended = course(self.toy, "grade", "1", "--submission", self.submission("asks", self.reference_files(SUMS, CLAMP)))
        self.assertEqual(ended.returncode, 3)
        self.assertIn("No permissions to create new namespace", ended.stderr)
        self.assertIn("--unsandboxed", ended.stderr)

    def test_terminal_escapes_are_spelt_out(self):
        files = self.reference_files(SUMS, CLAMP)
        files[SUMS] = files[SUMS].replace(b"double most", b'throw std::runtime_error("\\033[2J\\033]0;mine\\007 red");\n    double most')
        files[SUMS] = files[SUMS].replace(b"double sum = 0;", b'double sum = 0; // \xe2\x80\xae\x1b[31m\n    zero;')
        grades, gradescope, junit, printed = self.grade_with_reports("1", "--submission", self.submission("escapes", files))
        for text in (json.dumps([grades, gradescope], ensure_ascii=False), junit, printed):
            self.assertNotRegex(text, "[\x1b\x07\u202e]")
        self.assertIn("\\x1b[2J", printed)

    def test_an_endless_body_has_a_limit_for_all_tests(self):
        files = self.reference_files(CLAMP)
        files[SUMS] = (self.toy / SUMS).read_bytes().replace(b"double sum = 0;", b"volatile bool on = true;\n    while (on) {}\n    double sum = 0;")
        graded = grade(self.toy, "01", self.submission("endless", files), "--time-limit", "1", "--test-time", "0.001")
        self.assertEqual(set(outcomes(graded).values()) - {"passed"}, {"timed out"})
        self.assertIn("was not begun: the tests before it took 0.001 s, which is all that a hand-in gets",
                      {test["reason"] for test in graded["tests"]})

    def test_a_body_that_takes_the_compiler_for_ever_has_a_limit(self):
        files = self.reference_files(CLAMP)
        slow = b"""constexpr long slow = [] {
        long sum = 0;
        for (long i = 0; i < 2000; ++i)
            for (long j = 0; j < 2000; ++j) sum += j;
        return sum;
    }();
    double sum = 0 * slow;"""
        files[SUMS] = (self.toy / SUMS).read_bytes().replace(b"double sum = 0;", slow)
        graded = grade(self.toy, "01", self.submission("slow", files), "--build-time", "1")
        self.assertEqual((graded["points"], graded["error"]), (0, "the build took longer than a hand-in gets"))

    def test_errors_are_one_line(self):
        wrong = {
            ("grade", "07"): "there is no chapter '07'; there are 01_first, 02_second",
            ("grade", "--submission", "none"): "there is no submission none",
            ("grade", "--on-reference"): "--on-reference needs --submission or --all",
            ("grade", "--all", "none"): "there is no folder none",
            ("grade", "--all", "tools/course.py"): "there is no folder tools/course.py",
            ("grade", "--all", ".", "--submission", "."): "--all writes --csv and --html",
            ("grade", "--all", ".", "--json", "x"): "--all writes --csv and --html",
            ("grade", "--csv", "x"): "--csv and --html are of --all",
            ("grade", "--time-limit", "0"): "--time-limit must be more than 0",
            ("grade", "--submission", "a", "--submission", "b"): "--submission is given twice",
            ("grade", "--json", "a", "--json", "b"): "--json is given twice",
        }
        for words, reason in wrong.items():
            ended = course(self.toy, *words, *where())
            self.assertNotEqual(ended.returncode, 0, words)
            self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)
            self.assertIn(reason, ended.stderr)

    def test_damaged_data_is_named(self):
        path = self.toy / "tests/02_second/grading.json"
        good = path.read_text()
        self.addCleanup(path.write_text, good)
        data = json.loads(good)
        for change, reason in (({"chapter": "02"}, "'chapter' must be '02_second'"), ({"tests": []}, "has no test"),
                               ({"exercises": {}}, "'exercise' of Products.WeightsMultiplyValues must be one of those above")):
            path.write_text(json.dumps({**data, **change}))
            self.assertIn("tests/02_second/grading.json: ", course(self.toy, "grade", "02").stderr)
            self.assertIn(reason, course(self.toy, "grade", "02").stderr)
        data["tests"][0]["points"] = 99
        path.write_text(json.dumps(data))
        self.assertIn("sum to 99, not to 100", course(self.toy, "grade", "02").stderr)
        path.write_text("{")
        self.assertIn("tests/02_second/grading.json: ", course(self.toy, "grade", "02").stderr)


if __name__ == "__main__":
    unittest.main()
