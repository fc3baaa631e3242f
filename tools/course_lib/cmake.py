"""Configures and builds with CMake's presets."""

import json
import os
import re
import sys
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.paths import ROOT, build_dir, cores
from course_lib.process import run
from course_lib.terminal import say

# Errors are looked for in English; and ccache, which minds the language, shares what any of our builds compiled.
ENGLISH = {**os.environ, "LC_ALL": "C"}
# What a build folder was configured from beside the CMakeLists that ninja minds: the presets, and the packages that were
# installed then. CMake leaves out what needs a package that isn't there, such as 09's program for several machines.
CONFIGURED_FROM = (ROOT / "CMakePresets.json", Path("/var/lib/dpkg/status"))
FIRST_ERROR = re.compile(r"^(.*?(?:\berror:|undefined reference).*)$", re.MULTILINE)


def preset_names():
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    return [preset["name"] for preset in presets if not preset.get("hidden")]


def cached(preset, variable):
    """A variable of the preset's CMake cache; None when there is no such."""
    cache = build_dir(preset) / "CMakeCache.txt"
    if not cache.exists():
        return None
    found = re.search(rf"^{re.escape(variable)}:\w+=(.*)$", cache.read_text(), re.MULTILINE)
    return found[1] if found else None


def configured_after(ninja):
    """Whether that file is there, and newer than what a build folder is configured from."""
    if not ninja.exists():
        return False
    return all(ninja.stat().st_mtime > path.stat().st_mtime for path in CONFIGURED_FROM if path.exists())


def configure(preset="release", variables=None):
    """Configures a preset unless that is done and nothing asks for it again (ninja notices changed CMakeLists)."""
    variables = variables or {}
    folder = build_dir(preset)
    ninja = folder / "build.ninja"
    home = cached(preset, "CMAKE_HOME_DIRECTORY")
    if preset not in preset_names():
        raise CourseError(f"there is no preset '{preset}'; there are {', '.join(preset_names())}")
    if (configured_after(ninja) and home == str(ROOT)
            and all(cached(preset, name) == value for name, value in variables.items())):
        return
    # Python by its own path: CMake looks for it long, and may find a script before it that costs each call a tenth of a second.
    command = ["cmake", "--preset", preset, f"-DPython3_EXECUTABLE={sys.executable}", *(f"-D{name}={value}" for name, value in variables.items())]
    if home not in (None, str(ROOT)):
        command.append("--fresh")  # the tree was copied or moved together with its build folder
    finished = run(command, f"configure {preset}", env=ENGLISH)
    if finished.code != 0:
        say(finished.output)
        first = re.search(r"CMake Error.*?\n\s*(\S.*)", finished.output)
        reason = first[1] if first else "see CMake's output above"
        raise CourseError(f"configuring preset {preset} failed: {reason}; ./course setup installs what is missing")
    os.utime(ninja)  # CMake leaves it alone when it would be the same


def build(preset="release", targets=(), title=None):
    """Configures when needed, then builds the targets (all by default)."""
    configure(preset)
    command = ["cmake", "--build", build_dir(preset), "-j", cores()]
    if targets:
        command += ["--target", *targets]
    finished = run(command, title or f"build {preset}", env=ENGLISH)
    if finished.code == 0:
        return finished
    say(failures(finished.output))
    first = FIRST_ERROR.search(finished.output)
    reason = first[1].strip() if first else "see the output above"
    raise CourseError(f"building preset {preset} failed: {reason.replace(str(ROOT) + '/', '')}")


def failures(output):
    """Ninja's output without the steps that went well."""
    return "".join(line + "\n" for line in output.splitlines() if not re.match(r"^\[\d+/\d+\]", line))
