"""Packs your exercise files of a chapter, and of those before it, into build/submission_NN.zip to hand in."""

import hashlib
import json
import zipfile

from course_lib.chapters import choose_chapters
from course_lib.errors import CourseError
from course_lib.paths import BUILD, ROOT, shown
from course_lib.terminal import count, say
from exercises import loop, student
from exercises.catalog import read_catalog
from exercises.submission import MANIFEST, MOST_BYTES

HELP = "pack a chapter to hand it in"
EPOCH = (1980, 1, 1, 0, 0, 0)  # of every entry: the same files make the same archive


def add_arguments(parser):
    parser.add_argument("chapter", metavar="NN", help="chapter, by number or name")


def run(args):
    catalog = read_catalog(choose_chapters([args.chapter])[0])
    files = {path: content_of(path) for path in paths_upto(catalog.number)}
    archive = BUILD / f"submission_{catalog.number}.zip"
    archive.parent.mkdir(exist_ok=True)
    manifest = {"chapter": catalog.chapter, "course": course_commit(),
                "files": {path: hashlib.sha256(content).hexdigest() for path, content in files.items()}}
    temporary = archive.with_suffix(".tmp")
    with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as packed:
        add(packed, MANIFEST, (json.dumps(manifest, indent=2) + "\n").encode())
        for path, content in files.items():
            add(packed, path, content)
    temporary.replace(archive)
    say(f"{shown(archive)}: {count(len(files), 'file')}")
    for path in files:
        say(f"  {path}")
    for line in not_counting(loop.own_bodies(catalog.number)):
        say(line)
    say(standing(catalog))
    return 0


def paths_upto(number):
    if not any(exercise.chapter == number for exercise in student.starter_exercises().values()):
        raise CourseError(f"chapter {number} was solved when this tree was made, so there is nothing of yours to hand in")
    return loop.paths_upto(number)


def not_counting(spliced):
    """What of the files the grader will not take."""
    return [f"note: {id} will be refused: {reason}" for id, reason in spliced.refused.items()] + [
        f"note: {note}" for note in spliced.notes]


def content_of(path):
    try:
        content = (ROOT / path).read_bytes()
    except OSError:
        raise CourseError(f"{path} is gone; bring it back: cp {student.STARTER}/{path} {path}") from None
    if len(content) > MOST_BYTES:
        raise CourseError(f"{path} is larger than {MOST_BYTES >> 20} MiB, which the grader refuses; make it smaller")
    return content


def course_commit():
    return json.loads((ROOT / student.STUDENT).read_text()).get("course", "")


def add(packed, name, content):
    entry = zipfile.ZipInfo(name, EPOCH)
    entry.external_attr = 0o644 << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    packed.writestr(entry, content)


def standing(catalog):
    """What the last check said of what is packed."""
    results = student.recall(catalog)
    if results is None or not results.fresh:
        return f"Not checked as it is now; ./course check {catalog.number} tells what it is worth."
    return f"The last check gave it {loop.points_of(catalog, results.passed)} of {catalog.points} points."
