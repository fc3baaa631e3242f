"""The page of all figures: each picture in full size at a click, its data, the command that draws it, the code that does."""

import html
import json
import re

from docs.markdown import RAW_HTML, image_html

# A row of a chapter's table of figures, {"methods", shared(drawMethods)}, and the functions that such a row may call.
ROW = re.compile(r'^ *\{"(\w+)",(.*)$', re.MULTILINE)
DRAWS = re.compile(r"\b((?:draw|chart|tabulate)[A-Z]\w*)")


class Gallery:
    """The pictures of figures/, chapter by chapter, in the lessons' order."""

    def __init__(self, tree):
        self._tree = tree

    def page(self):
        """All of them, as a part of a page."""
        sections = [self._section(folder, page) for folder, page in self._tree.figure_folders().items()]
        return RAW_HTML.format("\n".join(sections)) if sections else "Nothing is drawn yet."

    def pictures(self):
        """Paths of the pictures below the tree's top."""
        return [picture.relative_to(self._tree.root).as_posix() for folder in self._tree.figure_folders()
                for picture in (self._tree.root / folder).glob("*.png")]

    def _section(self, folder, page):
        chapter = self._tree.chapter_of(page)
        captions, makers = self._captions(page), Makers(self._tree.root, chapter)
        order = list(captions)  # as the lesson shows them; others follow
        pictures = sorted((self._tree.root / folder).glob("*.png"),
                          key=lambda path: (order.index(path.name) if path.name in order else len(order), path.name))
        cells = "".join(self._cell(picture, captions, makers) for picture in pictures)
        return (f'<h2 id="{folder.replace("/", "-")}"><a href="{page.url}">{html.escape(page.title)}</a></h2>\n'
                f'<div class="gallery">{cells}</div>')

    def _cell(self, picture, captions, makers):
        path = picture.relative_to(self._tree.root).as_posix()
        caption = captions.get(picture.name, picture.stem.replace("_", " "))
        inner = image_html(path, caption).replace("\\htmlonly", "").replace("\\endhtmlonly", "")
        return (f"<figure>{inner}<figcaption>{html.escape(caption)}"
                f'<span class="made">{makers.links(picture.name)}</span></figcaption></figure>')

    def _captions(self, page):
        """What the lesson calls its pictures: file name -> alternative text."""
        text = (self._tree.root / page.path).read_text(encoding="utf-8")
        return {path.rsplit("/", 1)[-1]: " ".join(alt.split()) for alt, path in re.findall(r"!\[([^\]]+)\]\(([^)\s]+)\)", text)}


class Makers:
    """What makes a chapter's pictures: the record beside them, the table of its main.cpp, the functions that this names."""

    def __init__(self, root, chapter):
        self._root = root
        self._chapter = chapter
        record = root / "figures" / chapter / "provenance.json"
        self._figures = json.loads(record.read_text(encoding="utf-8"))["figures"] if record.exists() else {}
        main = root / "chapters" / chapter / "main.cpp"
        rows = ROW.findall(main.read_text(encoding="utf-8")) if main.exists() else []
        self._functions = {name: DRAWS.findall(rest) for name, rest in rows}

    def links(self, picture):
        """Data, code and command of a picture, as HTML; nothing for one that no record names."""
        name = next((name for name, entry in self._figures.items() if picture in entry["files"]), None)
        if name is None:
            return ""
        tables = [file for file in self._figures[name]["files"] if file.endswith(".csv")]
        parts = [f'<a href="tree:/figures/{self._chapter}/{file}">{file}</a>' for file in tables]
        place = self.code(name)
        if place:
            parts.append(f'<a href="tree:/{place[0]}#L{place[1]}">code</a>')
        parts.append(f"<code>./course figures {self._chapter[:2]} --only {name}</code>")
        return " ".join(parts)

    def code(self, name):
        """Where the function that draws a figure is defined: (path below the tree's top, line); None when it isn't found."""
        for function in self._functions.get(name, []):
            definition = re.compile(rf"^void {function}\([^;{{]*\{{", re.MULTILINE)
            for path in sorted((self._root / "chapters" / self._chapter).rglob("*.cpp")):
                text = path.read_text(encoding="utf-8")
                found = definition.search(text)
                if found:
                    return path.relative_to(self._root).as_posix(), text.count("\n", 0, found.start()) + 1
        return None
