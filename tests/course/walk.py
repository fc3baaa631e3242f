"""A student's way through the whole course, from start to the last point, as a script.

Each exercise in its order: `next` names it, the reference's body is written, and the chapter's points rise by what
grading.json gives for it. In the middle an endless loop is interrupted, and the course changes and is updated.
./course test --walk takes the way through the real course; test_walk.py through the toy course.

By hand: python3 -B tests/course/walk.py [NN of the first chapter; those before it are solved]
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "tools"))

import strip
from course_lib.chapters import all_chapters
from course_lib.terminal import say
from exercises.catalog import catalog_path, read_catalog
from exercises.student import FOLDER
from exercises.trees import remove_tree, source_files

ENDLESS = "for (volatile int i = 0;; i = i + 1) {\n    }\n"
INTERRUPTED = 128 + signal.SIGINT
POINTS = re.compile(r"^(\w+): (\d+) of (\d+) points\.?$", re.MULTILINE)
NEWS = "Of the next edition."


class Lost(Exception):
    """Where the student is not where the course says."""


class Walk:
    """@param course  the reference's tree; @param top  a folder for the student's tree and the next edition"""

    def __init__(self, course, top, first="01"):
        self.course, self.tree, self.edition = course, top / "student", top / "edition"
        self.first = first
        self.exercises = {id: e for id, e in strip.exercises_of_tree(course).items() if e.chapter >= first}
        self.catalogs = [read_catalog(chapter, course) for chapter in all_chapters(course)
                         if catalog_path(chapter, course).exists() and chapter[:2] >= first]
        self.steps = [(catalog, id) for catalog in self.catalogs for id in catalog.exercises]
        self.done = 0

    def run(self):
        """@throws Lost"""
        said = self.ask("start", self.tree, "--chapter", int(self.first))
        self.expect(f"{len(self.exercises)} exercises to write" in said, "start", said)
        self.expect(self.ask("status").count("not checked yet") >= len(self.catalogs), "status", "Is nothing known yet?")
        for catalog in self.catalogs:
            self.check(catalog, 0)
            for number, id in enumerate(catalog.exercises, start=1):
                self.expect_next(id)
                if self.done == len(self.steps) // 2:
                    self.get_stuck(catalog, id)
                self.solve(id)
                self.done += 1
                self.check(catalog, number)
                if self.done == len(self.steps) // 2 + 1:
                    self.follow_the_course(catalog, number)
        self.finish()

    def solve(self, id):
        found = self.exercises[id]
        self.write(id, strip.body(strip.read_source(self.course / found.path), found))

    def write(self, id, body):
        found = strip.exercises_of_tree(self.tree)[id]
        path = self.tree / found.path
        strip.write_source(path, strip.with_body(strip.read_source(path), found, body))

    def check(self, catalog, number):
        """Checks without saying which chapter; the first `number` exercises are done."""
        known = list(catalog.exercises)[:number]
        stated = sum(test.points for test in catalog.tests if test.exercise in known)
        begin = time.monotonic()
        said = self.ask("check", "--no-pictures", code=None)
        points = [(chapter, int(points)) for chapter, points, _ in POINTS.findall(said)]
        waiting = re.findall(r"^note: (ex-\S+) is written, and its tests wait for (ex-\S+)$", said, re.MULTILINE)
        self.expect(all(id in known and other not in known for id, other in waiting), "what waits", said)
        due = stated - sum(test.points for test in catalog.tests if test.exercise in dict(waiting))
        again = [(other.chapter, other.points) for other in self.catalogs if other.number < catalog.number]
        self.expect(points[-1:] == [(catalog.chapter, due)] and set(points[:-1]) <= set(again), f"{due} points of {catalog.chapter}", said)
        say(f"  {catalog.chapter}: {known[-1] if known else 'starter'}: {due} points, checked in {time.monotonic() - begin:.0f} s")

    def expect_next(self, id):
        said = self.ask("next")
        self.expect(said.startswith(f"{id}  "), f"next is {id}", said)

    def get_stuck(self, catalog, id):
        """A loop without an end, interrupted: nothing is lost, and nothing is known of it."""
        before = self.ask("status")
        self.write(id, ENDLESS)
        asked = subprocess.Popen(self.command("check", catalog.number, "--no-pictures"), cwd=self.tree, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
                                 preexec_fn=can_be_interrupted)
        time.sleep(3)  # it takes 10 s at the least, for that is a test's time limit
        os.killpg(asked.pid, signal.SIGINT)
        said, _ = asked.communicate()
        self.expect(asked.returncode == INTERRUPTED and said.endswith("course: interrupted\n"), "an interrupted check", said)
        points = re.compile(r"\d+/\d+")
        self.expect(points.findall(self.ask("status")) == points.findall(before), "status after an interruption", before)
        say(f"  {id}: an endless loop, interrupted")

    def follow_the_course(self, catalog, number):
        """An update in the middle of a chapter: words change in files of exercises, done or not, and in what `next` says."""
        ahead = self.steps[self.done][1] if self.done < len(self.steps) else None
        changed = self.make_edition(ahead)
        said = self.ask("update", "--from", self.edition)
        self.expect("what you wrote stays" in said and "aside" not in said, "an update", said)
        for path in changed:
            self.expect(NEWS in (self.tree / path).read_text(encoding="utf-8"), f"{path} of the new edition", said)
        self.expect("as new as that" in self.ask("update", "--from", self.edition), "a second update", said)
        if number < len(catalog.exercises):
            self.check(catalog, number)
            self.expect(NEWS in self.ask("next"), "the title by the new edition", said)
        say(f"  {len(changed)} files updated")

    def make_edition(self, ahead):
        """The course as it is some time later; returns the files that differ."""
        for name in source_files(self.course):
            (self.edition / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(self.course / name, self.edition / name)
        files = [self.exercises[id].path for _, id in self.steps[:self.done]] + ([self.exercises[ahead].path] if ahead else [])
        changed = list(dict.fromkeys([files[0], *files[-3:]]))
        for path in changed:
            text = strip.read_source(self.edition / path)
            strip.write_source(self.edition / path, text.replace("namespace caustic {", f"// {NEWS}\nnamespace caustic {{", 1))
        for catalog in self.catalogs if ahead else ():
            path = catalog_path(catalog.chapter, self.edition)
            data = json.loads(path.read_text(encoding="utf-8"))
            if ahead in data["exercises"]:
                data["exercises"][ahead]["title"] = NEWS
            path.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
        return changed

    def finish(self):
        """All chapters once more, each in the end's tree; then they are handed in."""
        said = self.ask("check", "--no-pictures", *(catalog.number for catalog in self.catalogs))
        points = [int(points) for _, points, _ in POINTS.findall(said)]
        total = sum(catalog.points for catalog in self.catalogs)
        self.expect(sum(points) == total and len(points) == len(self.catalogs), f"{total} points", said)
        self.expect("Every exercise is done." in self.ask("next"), "next at the end", said)
        packed = self.ask("submit", self.catalogs[-1].number)
        self.expect("gave it 100 of 100 points" in packed and "note:" not in packed, "submit", packed)
        say(f"  {sum(points)} of {total} points in {len(self.catalogs)} chapters")

    def ask(self, *words, code=0):
        """What ./course says in the student's tree; in the course's own until there is one."""
        where = self.tree if (self.tree / FOLDER).exists() else self.course
        asked = subprocess.run(self.command(*words, tree=where), cwd=where, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace")
        self.expect(code is None or asked.returncode == code, f"exit code {code} of {words[0]}", asked.stdout)
        return asked.stdout

    def command(self, *words, tree=None):
        return [sys.executable, "-B", str((tree or self.tree) / "tools" / "course.py"), *map(str, words)]

    def expect(self, holds, what, said):
        if not holds:
            raise Lost(f"after {self.done} of {len(self.steps)} exercises: not as it should be: {what}. It said:\n{said}")


def can_be_interrupted():
    """What runs in the background has its interrupts ignored, and so has all that it starts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def main(arguments):
    top = ROOT / "build" / "walk"
    remove_tree(top)
    top.mkdir(parents=True)
    walk = Walk(ROOT, top, *arguments[:1])
    try:
        walk.run()
    except Lost as lost:
        print(f"{lost}\n{walk.done} passed, 1 failed", flush=True)
        return 1
    print(f"{walk.done} passed, 0 failed", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
