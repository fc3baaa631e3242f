"""Begins a chapter: writes a small one that passes every gate, to be filled with the chapter's own subject.

What is still to be filled says FILL. The chapter's name is its number and a few words: 12_name.
"""

import re

from course_lib.chapters import all_chapters
from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.terminal import count, say
from exercises import student

HELP = "begin a chapter that passes every gate"
TEMPLATE = ROOT / "tools" / "templates" / "chapter"
ENDING = ".in"
NAME = re.compile(r"(\d\d)_([a-z][a-z0-9]*(?:_[a-z0-9]+)*)")
# A row of the front page's table of chapters.
ROW = r"^\| \d\d \| \[.*$"
FRONT_PAGES = {"README.md": "| {nn} | [{title}](chapters/{chapter}/README.md) | FILL | [figures](figures/{chapter}) |",
               "README.zh.md": "| {nn} | [{title}](chapters/{chapter}/README.md) | FILL | [图片](figures/{chapter}) |"}


def add_arguments(parser):
    parser.add_argument("chapter", metavar="NN_name", help="the next number and a name, as in 12_name")
    parser.add_argument("--topic", default="math", help="the topic of the library that it adds to (default: math)")


def run(args):
    if student.is_student_tree():
        raise CourseError("this is a student's tree; a chapter is added to the course's own")
    words = chosen_words(args.chapter, args.topic)
    changes = {**template_files(words), **declarations(words)}
    for path, text in changes.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    say(f"chapters/{args.chapter}, tests/{args.chapter} and common/{args.topic}/{words['NAME']} are there: "
        f"{count(len(changes), 'file')} written or changed.")
    say(f"Next: ./course test {words['NN']}; then ./course figures {words['NN']}, and what says FILL. "
        "CONTRIBUTING.md tells the rest.")
    return 0


def chosen_words(chapter, topic):
    """What the template's words stand for.

    @throws CourseError for a name or a topic that can't be
    """
    matched = NAME.fullmatch(chapter)
    if not matched:
        raise CourseError(f"'{chapter}' is no chapter's name; write two digits and small letters, as in 12_name")
    following = max((int(name[:2]) for name in all_chapters()), default=0) + 1
    if int(matched[1]) != following:
        raise CourseError(f"the next chapter is {following:02}, not {matched[1]}; write {following:02}_{matched[2]}")
    topics = sorted(path.parent.name for path in (ROOT / "common").glob("*/CMakeLists.txt"))
    if topic not in topics:
        raise CourseError(f"there is no topic '{topic}'; there are {', '.join(topics)}")
    words = {"CHAPTER": chapter, "NN": matched[1], "N": str(following), "NAME": matched[2], "TOPIC": topic,
             "TITLE": matched[2].replace("_", " ").capitalize()}
    taken = [path for path in template_files(words) if path.exists()]
    if taken:
        raise CourseError(f"{taken[0].relative_to(ROOT)} is there already; choose another name")
    return words


def template_files(words):
    """Path -> text of the files that the template makes."""
    files = {}
    for path in sorted(TEMPLATE.rglob(f"*{ENDING}")):
        name = filled(path.relative_to(TEMPLATE).as_posix()[:-len(ENDING)], words)
        files[ROOT / name] = filled(path.read_text(encoding="utf-8"), words)
    return files


def filled(text, words):
    """The text with its words replaced, and the lines that include our headers in order, as clang-format has them."""
    text = re.sub(r"@([A-Z]+)@", lambda word: words[word[1]], text)
    return re.sub(r'(?:^#include "[^\n]*\n)+', lambda lines: "".join(sorted(lines[0].splitlines(True))), text, flags=re.MULTILINE)


def declarations(words):
    """Path -> new text of the files that list chapters: those of CMake, and the front pages."""
    chapter, nn = words["CHAPTER"], words["NN"]
    topic = ROOT / "common" / words["TOPIC"] / "CMakeLists.txt"
    chapters, tests = ROOT / "chapters" / "CMakeLists.txt", ROOT / "tests" / "CMakeLists.txt"
    figures = "order.png speed_accuracy.png failure.png"
    changes = {topic: with_files(topic, f"CHAPTER {words['N']} {words['NAME']}.h {words['NAME']}.cpp"),
               chapters: after_last(chapters, r"^caustic_chapter\([^)]*\)$", f"caustic_chapter({chapter} FIGURES {figures})"),
               tests: after_last(tests, r"^caustic_tests\([^)]*\)$", f"caustic_tests({chapter})")}
    for name, row in FRONT_PAGES.items():
        page = ROOT / name
        if page.exists():
            changes[page] = after_last(page, ROW, row.format(nn=nn, chapter=chapter, title=words["TITLE"]))
    return changes


def with_files(path, line):
    """A topic's CMakeLists.txt with another line of files."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"(caustic_topic\([^)]*)\)", lambda call: f"{call[1]}\n  {line})", text, count=1)


def after_last(path, pattern, line):
    """A file's text with a line behind the last place that a pattern finds.

    @throws CourseError when it finds none
    """
    text = path.read_text(encoding="utf-8")
    places = list(re.finditer(pattern, text, re.MULTILINE))
    if not places:
        raise CourseError(f"{path.relative_to(ROOT)}: there is no line like the one that is to be added, {line}")
    end = places[-1].end()
    return f"{text[:end]}\n{line}{text[end:]}"
