"""Brings a student's tree up to date with the course: its lessons, tests, points, tools and new exercises.

What you wrote between markers stays as it is, hints and results too. All else becomes what the course has now. What you
changed besides stays where the course did not change it; where both did, and where an exercise's function is not the same any
more, yours is put into .course/aside/, under a name that is told. An update that was interrupted is finished by ./course
update.
"""

import os
import re
import shutil
import subprocess
import time
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import count, printable, say
from exercises import journal, student
from exercises.updating import planned
from strip import exercises_of_tree

HELP = "bring a student's tree up to date with the course"
URL = re.compile(r"^\w[\w+.-]*://|^[\w.-]+@[\w.-]+:")
# What every version of the course has.
LANDMARKS = ("course", "tools/course.py", "tools/strip.py", "common", "tests")


def add_arguments(parser):
    parser.add_argument("--from", dest="source", metavar="DIR|URL",
                        help="the course: a folder, or the address of its git repository")
    parser.add_argument("--dry-run", action="store_true", help="say what would change, and change nothing")


def run(args):
    student.require_student_tree()
    first = int(student.first_chapter())
    if journal.is_under_way(ROOT):
        return go_on(args)
    if not args.source:
        raise CourseError("say where the course is: ./course update --from DIR|URL")
    try:
        prepare(args, first)
    except OSError as error:
        raise CourseError(f"{error.filename} cannot be copied: {error.strerror}; nothing is changed") from None
    finally:
        journal.clear(ROOT)
    if journal.is_under_way(ROOT):
        finish()
        say("Done. ./course next says what to do next")
    return 0


def prepare(args, first):
    """Finds out what changes, says it, and lays it ready, unless it is but asked for."""
    new = journal.begin(ROOT)
    course = fetched(args.source)
    require_course(course, first)
    student.make(new, first, course)
    plan = planned(ROOT, new)
    aside = free_folder()
    tell(plan, aside, args.dry_run)
    if not args.dry_run and (plan.is_something or plan.is_remembered_otherwise):
        journal.prepare(ROOT, plan, aside)


def go_on(args):
    """Finishes what was interrupted. What was planned then is all on this disk."""
    if args.dry_run:
        raise CourseError("an update was interrupted, and a half of the tree is new; ./course update finishes it")
    finish()
    say("The update that was interrupted is done." + (" Now run it again for what is newer." if args.source else ""))
    return 0


def finish():
    try:
        for name in journal.finish(ROOT):
            say(f"  aside    {name}: changed while the update waited to be finished")
    except OSError as error:
        raise CourseError(f"{error.filename} cannot be written: {error.strerror}; put that right, then ./course update goes "
                          "on") from None


def fetched(source):
    """The folder that holds the course."""
    if URL.match(source) or is_bare(Path(source)):
        fetch(source, ROOT / journal.SOURCE)
        return ROOT / journal.SOURCE
    if not Path(source).is_dir():
        raise CourseError(f"there is no folder {source}; give the course's folder, or its address such as https://...")
    return Path(source).resolve()


def is_bare(folder):
    return (folder / "HEAD").is_file() and (folder / "objects").is_dir()


def fetch(source, folder):
    if not shutil.which("git"):
        raise CourseError("git is missing, which fetches the course from an address; install it, or give a folder")
    say(f"fetching {printable(source)}")
    command = ["git", "clone", "--quiet", "--depth", "1", "--", str(source), str(folder)]
    env = {**os.environ, "GIT_TERMINAL_PROMPT": "0"}
    ended = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                           errors="replace", env=env)
    if ended.returncode != 0:
        lines = printable(ended.stdout).strip().splitlines() or [f"exit code {ended.returncode}"]
        reason = next((line for line in lines if line.startswith("fatal:")), lines[-1])
        raise CourseError(f"{printable(source)} cannot be fetched: {reason}; nothing is changed")


def require_course(course, first):
    """@throws CourseError when a folder holds no course that this tree can come from"""
    missing = [name for name in LANDMARKS if not (course / name).exists()]
    if missing:
        raise CourseError(f"{course} is no tree of the course: it has no {missing[0]}; give the folder in which ./course is")
    if course == ROOT.resolve():
        raise CourseError("--from names this very tree; give the course's folder, or its address")
    if student.is_student_tree(course) and int(student.first_chapter(course)) < first:
        raise CourseError(f"{course} is a student's tree that starts with an earlier chapter than {first:02}, which is where "
                          "this one starts; give the course's own folder")
    exercises_of_tree(course)  # broken markers are said before anything else


def free_folder():
    """The name of a folder for what is put aside."""
    name = base = f"{student.ASIDE}/{time.strftime('%Y%m%d-%H%M%S')}"
    number = 1
    while (ROOT / name).exists():
        number += 1
        name = f"{base}-{number}"
    return name


def tell(plan, aside, dry):
    if not plan.is_something:
        say("This tree is as new as that.")
        return
    changed = sorted(set(plan.write) - set(plan.added))
    say(f"{count(len(plan.added), 'new file')}, {len(changed)} changed, {len(plan.remove)} removed")
    for sign, paths in (("new", plan.added), ("changed", changed), ("removed", plan.remove)):
        for path in paths if dry else ():
            say(f"  {sign:<8} {path}")
    if plan.kept:
        say(f"  yours    {', '.join(plan.kept)}: what you wrote stays, in files that change around it")
    if plan.new:
        say(f"  to write {', '.join(plan.new)}")
    for name, (_, why) in plan.aside.items():
        say(f"  aside    {name}: {why}; yours {'would go' if dry else 'goes'} to {aside}/{name}")
