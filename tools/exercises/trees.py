"""Copies of the course: grading trees, the mutants' tree, a student's tree."""

import contextlib
import fcntl
import filecmp
import os
import shutil
import subprocess
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import BUILD, ROOT
from strip import exercises_of_tree, read_source, strip

# What a tree that is only built from does without.
NOT_BUILT_FROM = ("docs/", "figures/")
LEFT_OUT_WITHOUT_GIT = ("build", ".git", "__pycache__", "compile_commands.json")


def source_files(root=ROOT):
    """The tree's files, relative to its top: what git tracks or would track; without git, all but what was built."""
    if (root / ".git").exists() and shutil.which("git"):
        command = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        listed = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout.decode("utf-8", "surrogateescape")
        names = sorted(set(listed.split("\0")) - {""})
        return [name for name in names if os.path.lexists(root / name)]
    names = []
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if name not in LEFT_OUT_WITHOUT_GIT]
        top = Path(folder).relative_to(root)
        names += [(top / name).as_posix() for name in files if name not in LEFT_OUT_WITHOUT_GIT]
    return sorted(names)


def files_to_build(root=ROOT):
    """The files that a grading tree needs."""
    return [name for name in source_files(root)
            if not name.startswith(NOT_BUILT_FROM) and not name.startswith("tests/course/")
            and "/mistakes/" not in name and "/alternatives/" not in name]


def starter_overlay(root=ROOT, chosen=lambda exercise: True):
    """Path -> bytes of every file with a chosen exercise, these exercises stripped."""
    overlay = {}
    for path in sorted({exercise.path for exercise in exercises_of_tree(root).values() if chosen(exercise)}):
        text = strip(read_source(root / path), path, chosen)
        overlay[path] = text.encode("utf-8", "surrogateescape")
    return overlay


def lay_out(folder, names, overlay, root=ROOT):
    """Makes `folder` hold these files of `root` with the overlay's contents in place of theirs, and nothing else but build/.

    A file that is already as it should be is not touched, so that a build there stays up to date.
    """
    wanted = set(names) | set(overlay)
    if folder.exists():
        for old in source_files_of_copy(folder):
            if old not in wanted:
                (folder / old).unlink()
    for name in sorted(wanted):
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if name in overlay:
            if not target.is_file() or target.read_bytes() != overlay[name]:
                target.write_bytes(overlay[name])
        elif not target.is_file() or not filecmp.cmp(root / name, target, shallow=False):
            shutil.copy2(root / name, target)
            os.utime(target)  # newer than what an earlier content was built into


def source_files_of_copy(folder):
    for parent, folders, files in os.walk(folder):
        if Path(parent) == folder:
            folders[:] = [name for name in folders if name != "build"]
        for name in files:
            yield (Path(parent) / name).relative_to(folder).as_posix()


def remove_tree(folder):
    """Removes a folder, also one in which somebody else's code took rights away; what resists stays."""
    for parent, folders, _ in os.walk(folder):
        for name in folders:
            path = Path(parent) / name
            if not path.is_symlink():
                path.chmod(0o700)  # before os.walk looks into it
    shutil.rmtree(folder, ignore_errors=True)


@contextlib.contextmanager
def work_folder(kind, keep=False):
    """A folder build/<kind>/<n> that no other run uses meanwhile; empty at the start unless `keep`."""
    parent = BUILD / kind
    parent.mkdir(parents=True, exist_ok=True)
    for number in range(1, 1000):
        lock = open(parent / f"{number}.lock", "w")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            break
        except OSError:
            lock.close()
    else:
        raise CourseError(f"{parent} is in use by too many runs; wait for them")
    folder = parent / str(number)
    try:
        if not keep:
            remove_tree(folder)
        folder.mkdir(exist_ok=True)
        yield folder
    finally:
        lock.close()
