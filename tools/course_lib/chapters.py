"""Which chapters there are, and which of them the user means."""

from course_lib.errors import CourseError
from course_lib.paths import ROOT


def all_chapters(root=ROOT):
    """Names of all chapters that stand, in order: ["01_bezier_curves", ...]."""
    return sorted(main.parent.name for main in (root / "chapters").glob("[0-9][0-9]_*/main.cpp"))


def choose_chapters(words, root=ROOT):
    """The chapters that `words` name, in order and each once; all when there are no words.

    A chapter is named by its number (1 or 01) or in full (01_bezier_curves), never by a part of its name.
    """
    known = all_chapters(root)
    if not words:
        return known
    chosen = set()
    for word in words:
        number = word.zfill(2)
        matches = [name for name in known if word == name or number == name[:2]]
        if not matches:
            raise CourseError(f"there is no chapter '{word}'; there are {', '.join(known)}")
        chosen.update(matches)
    return sorted(chosen)


def add_chapters_argument(parser, what="all"):
    parser.add_argument("chapters", nargs="*", metavar="NN", help=f"chapters, by number or name (default: {what})")
