"""Reads a submission: a folder or a ZIP file that somebody else made. Nothing of it is unpacked.

Only the files that hold exercises are looked at, and of these only the bodies between the markers are taken (splicing.py).
"""

import hashlib
import json
import stat
import zipfile
from pathlib import Path, PurePosixPath

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from exercises.splicing import Spliced
from strip import exercises_of_tree, read_source, strip

MOST_BYTES = 1 << 20  # of one source file
MOST_ENTRIES = 10_000
MANIFEST = "manifest.json"


class Refused(CourseError):
    """A hand-in that cannot be taken as it is. It is worth nothing, and its author should know why."""


def read_submission(source, chapters, root=ROOT):
    """The bodies of some chapters' exercises ("01", ...) from a folder or a ZIP file, in our files.

    A file that is missing counts as the starter's.
    @throws CourseError when there is no such submission; Refused when it is none, or made to do harm
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
        raise Refused(f"{source} holds no exercise file ({paths[0]} and so on); give the top of a student's tree, or the "
                      "ZIP file of ./course submit")
    spliced = Spliced(notes=manifest_notes(found.pop(MANIFEST, None), found))
    for path in paths:
        spliced.add(path, strip(read_source(root / path), path), found.get(path))
    return spliced


def read_folder(top, paths):
    found = {}
    for path in [*paths, MANIFEST]:
        place = top
        for part in PurePosixPath(path).parts:
            place = place / part
            if place.is_symlink():
                raise Refused(f"{place} is a symbolic link; a submission holds plain files only")
        if place.is_file():
            if place.stat().st_size > MOST_BYTES:
                raise Refused(f"{place} is larger than {MOST_BYTES >> 20} MiB; no exercise needs that")
            found[path] = place.read_bytes()
    return found


def read_zip(archive, paths):
    try:
        with zipfile.ZipFile(archive) as opened:
            return read_entries(opened, archive, paths)
    except (zipfile.BadZipFile, zipfile.LargeZipFile, NotImplementedError, RuntimeError, EOFError, OSError, ValueError) as error:
        raise Refused(f"{archive} cannot be read as a ZIP file: {error}") from None


def read_entries(opened, archive, paths):
    entries = opened.infolist()
    if len(entries) > MOST_ENTRIES:
        raise Refused(f"{archive} has {len(entries)} entries; hand in what ./course submit makes")
    names = set()
    for entry in entries:
        check_entry(entry, archive)
        if entry.filename in names:
            raise Refused(f"{archive} holds {entry.filename} twice; hand in what ./course submit makes")
        names.add(entry.filename)
    prefix = common_prefix(names, paths)
    found = {}
    for path in [*paths, MANIFEST]:
        if prefix + path not in names:
            continue
        with opened.open(prefix + path) as stream:
            content = stream.read(MOST_BYTES + 1)
        if len(content) > MOST_BYTES:
            raise Refused(f"{archive}: {path} is larger than {MOST_BYTES >> 20} MiB; no exercise needs that")
        found[path] = content
    return found


def check_entry(entry, archive):
    name = entry.filename
    if "\\" in name:
        raise Refused(f"{archive}: entry '{name}' has backslashes, as some tools of Windows write them; pack it with ./course "
                      "submit, or with Windows' own 'compressed folder'")
    if name.startswith("/") or ":" in name or ".." in PurePosixPath(name).parts:
        raise Refused(f"{archive}: entry '{name}' points out of the archive; hand in what ./course submit makes")
    if stat.S_ISLNK(entry.external_attr >> 16):
        raise Refused(f"{archive}: entry '{name}' is a symbolic link; a submission holds plain files only")


def common_prefix(names, paths):
    """The folder inside the archive that is the top of the tree: none, or one when a whole folder was packed."""
    if any(path in names for path in paths):
        return ""
    prefixes = {name[:-len(path)] for name in names for path in paths if name.endswith("/" + path)}
    if len(prefixes) > 1:
        raise Refused(f"the archive holds several trees ({', '.join(sorted(prefixes))}); hand in one")
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

