"""Where things are."""

import json
import os
from pathlib import Path

from course_lib.errors import CourseError

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build"
FIGURES = ROOT / "figures"
DRAFT_FIGURES = BUILD / "figures"


def build_dir(preset="release"):
    return BUILD / preset


def program(name, preset="release"):
    """An executable of ours, as built by that preset."""
    return build_dir(preset) / "bin" / name


def declarations(preset="release"):
    """What CMake knows of topics, files and chapters (cmake/Caustic.cmake writes it)."""
    path = build_dir(preset) / "declarations.json"
    if not path.exists():
        raise CourseError(f"{shown(path)} is missing; run ./course build --preset {preset}")
    return json.loads(path.read_text())


def shown(path):
    """A path as a person wants to read it: relative to the tree when it is inside."""
    path = Path(path)
    try:
        return str(path.resolve().relative_to(ROOT))
    except ValueError:
        return str(path)


def cores():
    """How many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on macOS
        return os.cpu_count() or 1
