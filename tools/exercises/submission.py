"""Reads a submission: a folder or a ZIP file that somebody else made. Nothing of it is unpacked.

Only the files that hold exercises are looked at; of a header only the bodies between the markers. Everything else in the
submission is left alone.
"""

import hashlib
import json
import stat
import zipfile
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from strip import body, exercises_of_tree, find_exercises, read_source, strip, with_body

MOST_BYTES = 1 << 20  # of one source file
MOST_ENTRIES = 10_000
MANIFEST = "manifest.json"
# Anything that a preprocessor could take for a directive: it could give the tests' own macros another meaning.
DIRECTIVES = ("#", "%:", "??=", "_Pragma")


@dataclass
class Submission:
    """What was handed in."""

    overlay: dict  # path -> bytes, for every file with an exercise of the chapters asked for
    notes: list = field(default_factory=list)


def read_submission(source, chapters, root=ROOT):
    """The exercise files of some chapters ("01", ...) from a folder or a ZIP file.

    A file that is missing counts as the starter's.
    @throws CourseError when there is no such submission, or it is made to do harm
    """
    exercises = [e for e in exercises_of_tree(root).values() if e.chapter in chapters]
    paths = sorted({exercise.path for exercise in exercises})
    source = Path(source)
    if source.is_dir():
        found = read_folder(source, paths)
    elif source.is_file():
        found = read_zip(source, paths)
    else:
        raise CourseError(f"there is no submission {source}; give a student's tree, or the ZIP file of ./course submit")
    if not any(path in found for path in paths):
        raise CourseError(f"{source} holds no exercise file ({paths[0]} and so on); give the top of a student's tree, or the "
                          "ZIP file of ./course submit")
    submission = Submission({}, manifest_notes(found.pop(MANIFEST, None), found))
    for path in paths:
        starter = strip(read_source(root / path), path)
        if path not in found:
            submission.notes.append(f"{path} is missing; its exercises count as not done")
            submission.overlay[path] = starter.encode("utf-8", "surrogateescape")
        elif path.endswith(".h"):
            submission.overlay[path] = bodies_into(starter, path, found[path], submission.notes)
        else:
            submission.overlay[path] = found[path]
    return submission


def read_folder(top, paths):
    found = {}
    for path in [*paths, MANIFEST]:
        place = top
        for part in PurePosixPath(path).parts:
            place = place / part
            if place.is_symlink():
                raise CourseError(f"{place} is a symbolic link; a submission holds plain files only")
        if place.is_file():
            if place.stat().st_size > MOST_BYTES:
                raise CourseError(f"{place} is larger than {MOST_BYTES >> 20} MiB; no exercise needs that")
            found[path] = place.read_bytes()
    return found


def read_zip(archive, paths):
    try:
        with zipfile.ZipFile(archive) as opened:
            return read_entries(opened, archive, paths)
    except (zipfile.BadZipFile, zipfile.LargeZipFile, NotImplementedError, RuntimeError, EOFError, OSError, ValueError) as error:
        raise CourseError(f"{archive} cannot be read as a ZIP file: {error}") from None


def read_entries(opened, archive, paths):
    entries = opened.infolist()
    if len(entries) > MOST_ENTRIES:
        raise CourseError(f"{archive} has {len(entries)} entries; hand in what ./course submit makes")
    names = set()
    for entry in entries:
        check_entry(entry, archive)
        if entry.filename in names:
            raise CourseError(f"{archive} holds {entry.filename} twice; hand in what ./course submit makes")
        names.add(entry.filename)
    prefix = common_prefix(names, paths)
    found = {}
    for path in [*paths, MANIFEST]:
        if prefix + path not in names:
            continue
        with opened.open(prefix + path) as stream:
            content = stream.read(MOST_BYTES + 1)
        if len(content) > MOST_BYTES:
            raise CourseError(f"{archive}: {path} is larger than {MOST_BYTES >> 20} MiB; no exercise needs that")
        found[path] = content
    return found


def check_entry(entry, archive):
    name = entry.filename
    if name.startswith("/") or "\\" in name or ":" in name or ".." in PurePosixPath(name).parts:
        raise CourseError(f"{archive}: entry '{name}' points out of the archive; this is no honest submission")
    if stat.S_ISLNK(entry.external_attr >> 16):
        raise CourseError(f"{archive}: entry '{name}' is a symbolic link; a submission holds plain files only")


def common_prefix(names, paths):
    """The folder inside the archive that is the top of the tree: none, or one when a whole folder was packed."""
    if any(path in names for path in paths):
        return ""
    prefixes = {name[:-len(path)] for name in names for path in paths if name.endswith("/" + path)}
    if len(prefixes) > 1:
        raise CourseError(f"the archive holds several trees ({', '.join(sorted(prefixes))}); hand in one")
    return prefixes.pop() if prefixes else ""


def manifest_notes(manifest, found):
    """What the manifest of ./course submit says that is not so. A folder, or an archive made by hand, has none."""
    if manifest is None:
        return []
    try:
        files = json.loads(manifest)["files"]
        return [f"{path} was changed after ./course submit packed it" for path in sorted(found)
                if path in files and files[path] != hashlib.sha256(found[path]).hexdigest()]
    except (ValueError, KeyError, TypeError):
        return [f"{MANIFEST} cannot be read"]


def bodies_into(starter, path, submitted, notes):
    """The starter's header with the submitted bodies in it."""
    text = starter
    try:
        theirs_text = submitted.decode("utf-8", "surrogateescape")
        theirs = {exercise.id: body(theirs_text, exercise) for exercise in find_exercises(theirs_text, path)}
    except CourseError as error:
        notes.append(f"{error}; its exercises count as not done")
        return starter.encode("utf-8", "surrogateescape")
    for exercise in reversed(find_exercises(starter, path)):
        if exercise.id not in theirs:
            notes.append(f"{path}: {exercise.id} is missing; it counts as not done")
        elif any(directive in theirs[exercise.id] for directive in DIRECTIVES):
            notes.append(f"{path}: {exercise.id} holds a preprocessor directive, which a header's exercise must not; it counts "
                         "as not done")
        else:
            text = with_body(text, exercise, theirs[exercise.id])
    return text.encode("utf-8", "surrogateescape")
