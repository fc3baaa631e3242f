"""The parts of pages that are drawn from the tree and from CMake's declarations, never typed in."""

import html
import json
import re
import subprocess

from docs.markdown import RAW_HTML, image_html

# What stands at the start of a line is declared in the namespace itself.
CLASS = re.compile(r"^(?:class|struct|enum class) (\w+)\b(?!;)", re.MULTILINE)
ALIAS = re.compile(r"^using (\w+) =", re.MULTILINE)
FUNCTION = re.compile(r"^(?!using |class |struct |enum |template|namespace )\w[\w:<>,&* ]* [&*]?(\w+)\(", re.MULTILINE)


class Parts:
    """Generates what pages ask for by <!-- site: name --> lines, and what stands at the end of some pages."""

    def __init__(self, tree, declarations):
        self._tree = tree
        self._topics = declarations["topics"]
        self._files = declarations["files"]

    def generators(self):
        return {"topics": lambda page: self.topics_graph(), "library": lambda page: self.library()}

    # The front page

    def gallery(self):
        """Every picture of figures/, chapter by chapter."""
        sections = []
        for folder, page in self._tree.figure_folders().items():
            captions = self._captions(page)
            order = list(captions)  # as the lesson shows them; others follow
            pictures = sorted((self._tree.root / folder).glob("*.png"),
                              key=lambda path: (order.index(path.name) if path.name in order else len(order), path.name))
            cells = "".join(self._thumbnail(picture, captions) for picture in pictures)
            sections.append(f'<h3 id="{folder.replace("/", "-")}"><a href="{page.url}">{html.escape(page.title)}</a></h3>\n'
                            f'<div class="gallery">{cells}</div>')
        if not sections:
            return ""
        return "\n## All figures {#index-all-figures}\n\n" + RAW_HTML.format("\n".join(sections))

    def pictures(self):
        """Paths of the gallery's pictures below the tree's top."""
        return [picture.relative_to(self._tree.root).as_posix() for folder in self._tree.figure_folders()
                for picture in (self._tree.root / folder).glob("*.png")]

    def _thumbnail(self, picture, captions):
        path = picture.relative_to(self._tree.root).as_posix()
        caption = captions.get(picture.name, picture.stem.replace("_", " "))
        inner = image_html(path, caption).replace("\\htmlonly", "").replace("\\endhtmlonly", "")
        return f"<figure>{inner}<figcaption>{html.escape(caption)}</figcaption></figure>"

    def _captions(self, page):
        """What the lesson calls its pictures: file name -> alternative text."""
        text = (self._tree.root / page.path).read_text(encoding="utf-8")
        return {path.rsplit("/", 1)[-1]: " ".join(alt.split()) for alt, path in re.findall(r"!\[([^\]]+)\]\(([^)\s]+)\)", text)}

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
        return f"\n## What this chapter adds to the library {{#{page.name}-library}}\n\n" + self._table(headers)

    def _lesson_links(self, page):
        lessons = self._tree.chapters()
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
            sections.append(f"\n### {topic} {{#topic-{topic}}}\n\n{uses}\n\n{self._table(headers, chapters=True)}")
        return "\n".join(sections)

    def _table(self, headers, chapters=False):
        """What headers declare; `chapters` says which chapter brought each, too."""
        rows = ["| header | declares | chapter |", "| :-- | :-- | :-- |"] if chapters else \
            ["| header | declares |", "| :-- | :-- |"]
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

    def topics_graph(self):
        """The topics' graph as an SVG: an arrow leads from a topic to those that may use it."""
        topics = {topic for topic, _ in self._topics.items()
                  if any(tag["topic"] == topic and path.startswith("common/") for path, tag in self._files.items())}
        uses = {topic: [used for used in self._topics[topic] if used in topics] for topic in topics}
        return RAW_HTML.format(f'<div class="topics">{draw(dot_source(reduced(uses)))}</div>')


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


def reaches(uses, start, goal):
    return goal in uses[start] or any(reaches(uses, used, goal) for used in uses[start])


def reduced(uses):
    """The same graph without the arrows that follow from others."""
    return {topic: [used for used in direct if not any(reaches(uses, other, used) for other in direct if other != used)]
            for topic, direct in uses.items()}


def dot_source(uses):
    lines = ["digraph topics {", "rankdir=LR; nodesep=0.25; ranksep=0.6; bgcolor=transparent;",
             'node [shape=box, style=rounded, fontname="DejaVu Sans", fontsize=12, height=0.4, margin="0.18,0.06"];',
             "edge [arrowsize=0.7];"]
    for topic in sorted(uses):
        lines.append(f'"{topic}" [URL="#topic-{topic}", tooltip={json.dumps(topic)}];')
        lines += [f'"{used}" -> "{topic}";' for used in sorted(uses[topic])]
    return "\n".join(lines + ["}"])


def draw(source):
    """Graphviz's SVG of a graph, as an element to put into a page."""
    svg = subprocess.run(["dot", "-Tsvg"], input=source, stdout=subprocess.PIPE, check=True, text=True).stdout
    svg = re.sub(r"<!--.*?-->\n?", "", svg, flags=re.DOTALL)
    return svg[svg.index("<svg"):].strip()
