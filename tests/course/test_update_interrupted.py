"""./course update, stopped before each of its steps and gone on with."""

import os
import shutil
import subprocess
import unittest
from unittest import mock

from exercises import journal, student
from exercises.updating import planned
from toy_course import course, reference_body, write_body
from updated_course import MINE, SUMS, Updating, replace, snapshot


class Interrupted(Updating):
    """The same tree after an update that was stopped before each of its steps, and gone on with."""

    def solved(self):
        self.change_much()
        write_body(self.tree, "ex-01.1", MINE)
        write_body(self.tree, "ex-01.2", "return values.back();")
        replace(self.tree / "chapters/02_second/main.cpp", "int main", "int  main")

    def prepare(self):
        new = journal.begin(self.tree)
        student.make(new, 1, self.new)
        journal.prepare(self.tree, planned(self.tree, new), f"{student.ASIDE}/then")

    def test_stopped_before_any_step_it_comes_to_the_same_end(self):
        self.solved()
        self.prepare()
        waiting, end = self.top / "waiting", None
        shutil.rmtree(waiting, ignore_errors=True)
        shutil.copytree(self.tree, waiting)
        steps, exchange = 0, journal.os.replace
        while True:
            shutil.rmtree(self.tree)
            shutil.copytree(waiting, self.tree, copy_function=os.link)  # files are exchanged, none is written to
            calls = iter(range(steps))

            def stopping(source, target):
                if next(calls, None) is None:
                    raise KeyboardInterrupt
                exchange(source, target)

            try:
                with mock.patch.object(journal.os, "replace", stopping):
                    journal.finish(self.tree)
                break
            except KeyboardInterrupt:
                steps += 1
            if (self.tree / "tools").exists():
                journal.finish(self.tree)
            else:  # between the two steps that exchange it; only ./course itself can still do something
                subprocess.run(["sh", self.tree / "course", "update"], cwd=self.tree, check=True, stdout=subprocess.DEVNULL)
            end = end or snapshot(self.tree)
            self.assertEqual(snapshot(self.tree), end, f"stopped before step {steps}")
        self.assertGreater(steps, 10)
        self.assertEqual(snapshot(self.tree), end)
        self.assertEqual(reference_body(self.tree, "ex-01.1"), MINE + "\n")
        self.assertEqual(set(self.asides()), {"ex-01.2.cpp", "chapters/02_second/main.cpp"})

    def test_before_all_is_laid_ready_nothing_has_changed(self):
        self.solved()
        before = snapshot(self.tree)
        new = journal.begin(self.tree)
        student.make(new, 1, self.new)
        with mock.patch.object(journal.os, "replace", side_effect=KeyboardInterrupt), self.assertRaises(KeyboardInterrupt):
            journal.prepare(self.tree, planned(self.tree, new), f"{student.ASIDE}/then")
        self.assertEqual(snapshot(self.tree, student.UPDATE), before)
        self.assertIn("Done.", self.update())

    def test_what_is_written_while_it_waits_goes_aside(self):
        self.solved()
        self.prepare()
        write_body(self.tree, "ex-01.1", "return 7;")
        written = (self.tree / SUMS).read_text()
        for words in (("check", "01"), ("next",), ("update", "--from", self.new, "--dry-run")):
            self.assertIn("an update was interrupted, and a half of the tree is new; ./course update finishes it",
                          course(self.tree, *words).stderr)
        said = course(self.tree, "update").stdout
        self.assertIn(f"aside    {student.ASIDE}/then/{SUMS}: changed while the update waited to be finished", said)
        self.assertIn("The update that was interrupted is done.", said)
        self.assertEqual((self.tree / student.ASIDE / "then" / SUMS).read_text(), written)


if __name__ == "__main__":
    unittest.main()
