"""Grades a folder of hand-ins, a few at a time, each as if it were alone."""

import concurrent.futures
import queue
import stat
from dataclasses import dataclass, field
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT, cores
from course_lib.terminal import Step, printable
from exercises.building import PRESET, build_tree
from exercises.grading import grade_spliced, worthless
from exercises.submission import Refused
from exercises.trees import files_to_build, lay_out, starter_overlay, work_folder
from exercises.verdicts import REFUSED

TOP = "common"  # what the top of a student's tree has
MOST_WRAPPINGS = 4


@dataclass
class HandIn:
    """What one entry of the folder is worth."""

    name: str
    grades: list = field(default_factory=list)  # of ChapterGrade, in the order of the chapters
    error: str = ""  # why it could not be graded, which is no fault of its author's

    @property
    def points(self):
        return sum(grade.points for grade in self.grades)


def entries(folder):
    """The hand-ins of a folder: every folder and ZIP file in it that is not hidden; and the names of what is neither.

    @throws CourseError when there is no such folder, or nothing in it
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise CourseError(f"there is no folder {folder}; give one that holds students' trees, or ZIP files of ./course submit")
    seen = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    found = [path for path in seen if is_hand_in(path)]
    if not found:
        raise CourseError(f"{folder} holds neither a folder nor a ZIP file; give one that holds students' hand-ins")
    return found, [path.name for path in seen if path not in found]


def is_hand_in(path):
    """A link is none: it would show whatever the grader may read."""
    mode = path.lstat().st_mode
    return stat.S_ISDIR(mode) or (stat.S_ISREG(mode) and path.suffix.lower() == ".zip")


def unwrapped(path):
    """A hand-in without the folders that a learning platform, or a student, put around it: a folder in which there is
    nothing but a ZIP file or one more folder."""
    for _ in range(MOST_WRAPPINGS):
        if not path.is_dir():
            break
        inside = [place for place in path.iterdir() if not place.name.startswith(".")]
        if len(inside) != 1 or inside[0].name == TOP or not is_hand_in(inside[0]):
            break
        path = inside[0]
    return path


def grade_all(paths, catalogs, read, conditions, root=ROOT):
    """Grades each hand-in on its own: [HandIn], in the order of `paths`.

    One worker's trees are used again and again, so that only what differs is compiled.
    @param read  (path, catalog) -> Spliced
    """
    workers = min(cores(), len(paths))
    with work_folder("grade") as top, Step(f"grade {len(paths)} hand-ins") as step:
        places = queue.SimpleQueue()
        for number in range(workers):
            places.put(top / str(number))

        def grade_one(path):
            place = places.get()
            try:
                return graded(path, catalogs, read, place, conditions, root)
            finally:
                places.put(place)

        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            waiting = {pool.submit(grade_one, path): path for path in paths}
            found = {}
            for finished in concurrent.futures.as_completed(waiting):
                found[waiting[finished]] = finished.result()
                step.progress(len(found), len(paths))
    return [found[path] for path in paths]


def graded(path, catalogs, read, place, conditions, root):
    hand_in = HandIn(printable(path.name))
    try:
        for catalog in catalogs:
            hand_in.grades.append(grade_chapter(unwrapped(path), catalog, read, place / catalog.chapter, conditions, root))
    except (CourseError, OSError) as error:
        hand_in.grades, hand_in.error = [], printable(str(error))
    return hand_in


def grade_chapter(path, catalog, read, folder, conditions, root):
    try:
        spliced = read(path, catalog)
    except Refused as refusal:
        return worthless(catalog, REFUSED, printable(str(refusal)))
    prepare(catalog, folder / "tree", conditions, root)
    return grade_spliced(catalog, spliced, folder, conditions, root)


def prepare(catalog, tree, conditions, root):
    """Builds a chapter with stubs where it is not built yet, so that no hand-in's time is spent on what is ours.

    @throws CourseError when that does not build, which is no student's fault
    """
    if (tree / "build" / PRESET).exists():
        return
    lay_out(tree, files_to_build(root), {**starter_overlay(root), **catalog.files}, root)
    built = build_tree(tree, [catalog.target], "", sandboxed=conditions.sandboxed, jobs=conditions.jobs)
    if built.error:
        raise CourseError(f"{catalog.chapter} does not build with stubs: {built.error}")
