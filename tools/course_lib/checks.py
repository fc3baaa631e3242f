"""What can change the outcome of each check of ./course test, as one hash (course_lib/green.py).

A check that is not named here depends on the whole tree. One that is says what it depends on, and rather too much than too
little: a check that is tried once more costs seconds, one that is not tried costs trust.
"""

import re
from pathlib import Path

from course_lib import green
from course_lib.paths import ROOT, declarations, program
from exercises.trees import files_to_build, source_files

OF_A_CHAPTER = re.compile(r"^(?:chapters|tests)/(\d\d)_")
OF_ONE_CHAPTER = re.compile(r"^course\.(gates|chapters)_(\d\d)$")
CPP_CHECK = re.compile(r"^(\d\d)\.\w+$")
ALONE = "alone.py"  # runs tests of the tools that need no chapter of this course, but the toy course's at most
OF_THE_TOY = ("tools/", "tests/course/", "tests/support/", "common/core/", "common/figure/", "cmake/", "CMakePresets.json",
              "packages.txt", ".gitignore", "course")
READ_BY_NOBODY = re.compile(r"\.md$|^(docs|figures|\.devcontainer)/|^(LICENSE|\.gitignore|\.clang-format)$")


def inputs_of(entries, preset="release"):
    """The inputs of a check, given what ctest has of it."""
    check = entries[0].check
    commands = {Path(word) for entry in entries for word in entry.command if Path(word).is_absolute()}
    alone = any(path.name == ALONE for path in commands)
    words = [green.toolchain(), *sorted(path for path in commands if path.is_file())]
    return green.digest([*words, green.files_digest(seen_alone() if alone else files_of(check)), *programs_of(check, preset)])


def seen_alone():
    """All that is there for a test that alone.py runs: the tools and what the toy course is made of."""
    return [name for name in source_files() if name.startswith(OF_THE_TOY)]


def files_of(check):
    """The names of the tree's files that a check depends on, besides the programs that it runs."""
    one_chapter = OF_ONE_CHAPTER.match(check)
    if one_chapter and one_chapter[1] == "gates":
        return [*known_files(int(one_chapter[2])), *tool_tests()]
    if one_chapter:
        return [*read_by_programs(one_chapter[2]), *tools(), *tool_tests()]
    if CPP_CHECK.match(check):
        return read_by_programs(check[:2])
    return source_files()


def programs_of(check, preset):
    """The chapter's executables, which its tests run; the gates build one of their own."""
    matched = OF_ONE_CHAPTER.match(check) or CPP_CHECK.match(check)
    if not matched or matched[1] == "gates":
        return []
    number = matched[matched.lastindex]
    programs = declarations(preset)["programs"]
    return [program(name, preset) for chapter in sorted(programs) if chapter[:2] == number for name in programs[chapter]]


def known_files(chapter, root=ROOT):
    """What a tree is built from that ends with this chapter: its files, those of earlier ones, and those of none."""
    tags = {name: tag["chapter"] for name, tag in declarations()["files"].items()}
    return [name for name in files_to_build(root) if chapter_of(name, tags) <= chapter and not READ_BY_NOBODY.search(name)]


def chapter_of(name, tags):
    """The number of the chapter that a file came with; 0 when it belongs to none."""
    matched = OF_A_CHAPTER.match(name)
    return int(matched[1]) if matched else tags.get(name, 0)


def read_by_programs(number):
    """What a chapter's programs may open when they run; what they were compiled from is in themselves."""
    own = re.compile(rf"^(assets|common|tests/support|(chapters|tests)/{number}_\w+)/")
    return [name for name in source_files()
            if own.match(name) and not name.endswith((".cpp", ".h")) and not READ_BY_NOBODY.search(name)]


def tools():
    return [name for name in source_files() if name.startswith("tools/")]


def tool_tests():
    return [name for name in source_files() if name.startswith("tests/course/")]
