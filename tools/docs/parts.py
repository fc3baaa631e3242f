"""The parts of pages that are drawn from the tree and from CMake's declarations, never typed in."""

import html
import re

from docs.exercise_table import ExerciseTable
from docs.figure_gallery import Gallery
from docs.integrators import Integrators
from docs.markdown import RAW_HTML
from docs.mistake_table import MistakeTable
from docs.topic_map import TopicMap

# What stands at the start of a line is declared in the namespace itself.
CLASS = re.compile(r"^(?:class|struct|enum class) (\w+)\b(?!;)", re.MULTILINE)
ALIAS = re.compile(r"^using (\w+) =", re.MULTILINE)
FUNCTION = re.compile(r"^(?!using |class |struct |enum |template|namespace )\w[\w:<>,&* ]* [&*]?(\w+)\(", re.MULTILINE)

# What lessons' ends say, in each language.
WORDS = {"en": {"library": "What this chapter adds to the library", "header": "header", "declares": "declares"},
         "zh": {"library": "本章为库增添的内容", "header": "头文件", "declares": "声明"}}


class Parts:
    """Generates what pages ask for by <!-- site: name --> lines, and what stands at the end of some pages."""

    def __init__(self, tree, declarations):
        self._tree = tree
        self._topics = declarations["topics"]
        self._files = declarations["files"]
        self._gallery = Gallery(tree)
        self._integrators = Integrators(tree.root)
        self._map = TopicMap(tree, declarations)

    def generators(self):
        return {"topics": lambda page: self._map.graph(), "places": lambda page: self._map.places(),
                "library": lambda page: self.library(), "gallery": lambda page: self._gallery.page(),
                "exercises": lambda page: ExerciseTable(self._tree).page(),
                "mistakes": lambda page: MistakeTable(self._tree).page(),
                "integrators": lambda page: self._integrators.page()}

    def pictures(self):
        """Paths of the gallery's pictures below the tree's top."""
        return self._gallery.pictures()

    def draw_charts(self, html_folder):
        """Draws the charts that pages show into the site."""
        self._integrators.draw(html_folder)

    # A lesson's end

    def lesson_end(self, page):
        return self._lesson_files(page) + self._lesson_links(page)

    def _lesson_files(self, page):
        """What the chapter adds to the library."""
        number = int(self._tree.chapter_of(page)[:2])
        headers = [path for path, tag in self._files.items()
                   if tag["chapter"] == number and path.startswith("common/") and path.endswith(".h")]
        if not headers:
            return ""
        words = WORDS[page.language]
        return f"\n## {words['library']} {{#{page.name}-library}}\n\n" + self._table(headers, words)

    def _lesson_links(self, page):
        lessons = self._tree.chapters(page.language)
        place = lessons.index(page)
        links = []
        if place > 0:
            before = lessons[place - 1]
            links.append(f'<a class="previous" href="{before.url}">← {html.escape(before.title)}</a>')
        if place + 1 < len(lessons):
            after = lessons[place + 1]
            links.append(f'<a class="next" href="{after.url}">{html.escape(after.title)} →</a>')
        return "\n" + RAW_HTML.format(f'<nav class="lessons">{"".join(links)}</nav>') if links else ""

    # The library

    def library(self):
        """Every header of the library, topic by topic."""
        sections = []
        for topic, used in self._topics.items():
            headers = [path for path, tag in self._files.items()
                       if tag["topic"] == topic and path.startswith("common/") and path.endswith(".h")]
            if not headers:
                continue
            uses = f"Uses {', '.join(used)}." if used else "Uses nothing of ours."
            table = self._table(headers, WORDS["en"], chapters=True)
            sections.append(f"\n### {topic} {{#topic-{topic}}}\n\n{uses}\n\n{table}")
        return "\n".join(sections)

    def _table(self, headers, words, chapters=False):
        """What headers declare; `chapters` says which chapter brought each, too."""
        rows = ["| header | declares | chapter |", "| :-- | :-- | :-- |"] if chapters else \
            [f"| {words['header']} | {words['declares']} |", "| :-- | :-- |"]
        for path in headers:
            names = ", ".join(f"`{name}`" for name in declared_names((self._tree.root / path).read_text(encoding="utf-8")))
            short = path[len("common/"):]
            chapter = f' {self._chapter_link(self._files[path]["chapter"])} |' if chapters else ""
            rows.append(f'| <a href="tree:/{path}">{short}</a> | {names} |{chapter}')
        return "\n".join(rows) + "\n"

    def _chapter_link(self, number):
        for page in self._tree.chapters():
            if int(self._tree.chapter_of(page)[:2]) == number:
                return f'<a href="{page.url}">{number:02}</a>'
        return f"{number:02}"


def declared_names(header):
    """What a header declares in the namespace itself, in order: classes, aliases, functions."""
    code = re.sub(r"//[^\n]*", "", header)
    code = re.sub(r"namespace detail \{.*?\n\}", "", code, flags=re.DOTALL)
    found = [(matched.start(), matched[1]) for pattern in (CLASS, ALIAS, FUNCTION) for matched in pattern.finditer(code)]
    names = []
    for _, name in sorted(found):
        if name not in names and not name.startswith("operator"):
            names.append(name)
    return names
