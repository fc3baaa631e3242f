"""./course bench: what the benchmarks say of themselves, and that each can write what it measured."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from commands.bench import benchmarks, listing
from course_lib.benchmarks import option_parser, save_quantities
from course_lib.packages import read_packages
from course_lib.paths import BUILD, FIGURES, ROOT


class Benchmarks(unittest.TestCase):
    def test_each_states_what_it_does_its_cases_and_what_it_needs(self):
        packages = {package.name for package in read_packages()}
        known = benchmarks()
        self.assertGreaterEqual(len(known), 8)
        for benchmark in known.values():
            with self.subTest(benchmark.name):
                self.assertTrue(benchmark.what and benchmark.cases)
                for need in benchmark.needs:
                    self.assertTrue(need in packages or " " in need, f"{need} is not in packages.txt")

    def test_help_lists_them(self):
        text = listing(benchmarks())
        for name in benchmarks():
            self.assertIn(f"\n  {name} ", text)
        self.assertIn("needs: povray\n", text)

    def test_each_takes_csv_and_keeps_its_table_only_by_record(self):
        environment = {**os.environ, "PYTHONPATH": str(ROOT / "tools")}
        for name in benchmarks():
            with self.subTest(name):
                script = ROOT / "tests" / "benchmarks" / name / "run.py"
                shown = subprocess.run([sys.executable, "-B", script, "--help"], env=environment, capture_output=True, text=True)
                self.assertEqual(shown.returncode, 0, shown.stderr)
                self.assertIn("--csv FILE", shown.stdout)
                text = script.read_text()
                self.assertEqual("FIGURES" in text, "--record" in shown.stdout, "Is a kept table written unasked?")
                self.assertLessEqual(text.count("TABLE"), 2, "The table is where the options say; TABLE is for them alone.")

    def test_a_kept_table_is_written_only_when_that_is_asked_for(self):
        kept = FIGURES / "04_kd_tree" / "rays.csv"
        parser = option_parser("rays", "Rays.", kept)
        self.assertEqual(parser.parse_args([]).table, BUILD / "bench" / "rays.csv")
        self.assertEqual(parser.parse_args(["--record"]).table, kept)

    def test_what_was_measured_is_written_as_quantities(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "new" / "rays.csv"
            save_quantities(path, [("8-wide BVH", "bunny, primary: ratio to Embree", 0.92, "1", "Embree")])
            self.assertEqual(path.read_text(), "method,case,value,unit,reference\n"
                                               '8-wide BVH,"bunny, primary: ratio to Embree",0.92,1,Embree\n')
            save_quantities(None, [])


if __name__ == "__main__":
    unittest.main()
