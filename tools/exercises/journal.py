"""Carries out an update so that it can be interrupted anywhere: .course/update/ holds every file that is to come, and
plan.json, which is written last, says where each goes. From then on the update is only finished, never begun anew.

tools/ is exchanged last, as a whole: what is half of one version and half of another may not even start. Should that be
interrupted too, ./course itself puts it right.
"""

import json
import os
import shutil

from exercises import student
from exercises.trees import remove_tree

SOURCE = f"{student.UPDATE}/source"  # the course, where it was fetched
NEW = f"{student.UPDATE}/new"  # the course as a student gets it now
FILES = f"{student.UPDATE}/files"  # what comes into the tree, each under its own path
TOOLS = f"{student.UPDATE}/tools"
OLD_TOOLS = f"{student.UPDATE}/old_tools"
PLAN = f"{student.UPDATE}/plan.json"


def is_under_way(root):
    return (root / PLAN).exists()


def begin(root):
    """An empty folder for the course as it is now."""
    clear(root)
    (root / NEW).mkdir(parents=True)
    return root / NEW


def clear(root):
    """Removes what an attempt left that came to nothing."""
    if not is_under_way(root):
        remove_tree(root / student.UPDATE)


def prepare(root, plan, aside):
    """Lays all files ready. Nothing in the tree has changed yet; when this is through, the update will be.

    @param aside  the folder, below the tree's top, for what is put aside
    """
    with_tools = any(path.startswith("tools/") for path in [*plan.write, *plan.remove])
    if with_tools:
        shutil.copytree(root / "tools", root / TOOLS, ignore=shutil.ignore_patterns("__pycache__"), symlinks=True)
    for path, content in plan.write.items():
        lay_ready(root, path, content, TOOLS[:-len("tools")] if path.startswith("tools/") else FILES)
    for path in own_files(root / NEW):
        lay_ready(root, path, None, FILES)
    for name, (content, _) in plan.aside.items():
        put(root / FILES / aside / name, content)
    gone = [path for path in own_files(root) if not (root / NEW / path).exists()]
    for path in plan.remove:
        if path.startswith("tools/"):
            (root / TOOLS[:-len("tools")] / path).unlink(missing_ok=True)
    remove = [path for path in plan.remove if not path.startswith("tools/")] + gone
    temporary = root / (PLAN + ".tmp")
    found = {path: student.file_hash(root / path) for path in [*plan.write, *plan.remove] if (root / path).is_file()}
    temporary.write_text(json.dumps({"remove": remove, "aside": aside, "found": found}))
    os.replace(temporary, root / PLAN)


def lay_ready(root, path, content, folder):
    """A file as it will be, with the rights that it has in the course."""
    target, source = root / folder / path, root / NEW / path
    put(target, source.read_bytes() if content is None else content)
    shutil.copymode(source, target)


def put(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def own_files(top):
    """What student.make writes beside the course's files."""
    starter = [path.relative_to(top).as_posix() for path in (top / student.STARTER).rglob("*") if path.is_file()]
    return [student.STUDENT, student.FILES, f"{student.FOLDER}/.gitignore", *sorted(starter)]


def finish(root):
    """Brings the files to their places; the same again after an interruption.

    What was changed since then, between the interruption and this, goes aside; returns the names of that.
    """
    plan = json.loads((root / PLAN).read_text())
    changed = []
    for path in plan["remove"]:
        changed += keep_changed(root, path, plan)
        (root / path).unlink(missing_ok=True)
        remove_empty(root, (root / path).parent)
    top = root / FILES
    for source in sorted(path for path in top.rglob("*") if path.is_file()):
        path = source.relative_to(top).as_posix()
        changed += keep_changed(root, path, plan, student.file_hash(source))
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        os.utime(source)  # newer than what an earlier content was built into
        os.replace(source, root / path)
    if (root / TOOLS).exists():
        exchange_tools(root)
    (root / PLAN).unlink()
    remove_tree(root / student.UPDATE)
    return changed


def keep_changed(root, path, plan, coming=None):
    """Puts a file aside that is neither what was found when the update was planned nor what comes."""
    place = root / path
    if path.startswith(f"{student.FOLDER}/") or not place.is_file():
        return []
    if student.file_hash(place) in (plan["found"].get(path), coming):
        return []
    name = f"{plan['aside']}/{path}"
    put(root / name, place.read_bytes())
    return [name]


def exchange_tools(root):
    remove_tree(root / OLD_TOOLS)
    os.replace(root / "tools", root / OLD_TOOLS)
    os.replace(root / TOOLS, root / "tools")


def remove_empty(root, folder):
    while folder != root and folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
        folder = folder.parent
