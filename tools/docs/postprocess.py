"""What Doxygen leaves open in its HTML: links to files of the tree, and links from code to the API pages."""

import html
import re
import shutil
import xml.etree.ElementTree as ElementTree

from docs.markdown import FILES_FOLDER

TREE_LINK = re.compile(r'href="tree:/([^"#]*)(?:#L?([^"]*))?"')
# The names at a page's foot that lead from the tree's top to it.
NAVIGATION_PATH = re.compile(r'<li class="navelem">.*?>([^<]+)</(?:a|b)>')
# Markdown has no tables without a head; those whose head is empty lose it.
EMPTY_TABLE_HEAD = re.compile(r'<tr class="markdownTableHead">\s*(<th class="[^"]*">\s*</th>)+</tr>')
# Doxygen offers to jump to a class's nested classes even if all of them are private, and so not listed.
NESTED_CLASSES = '<a href="#nested-classes">Classes</a> &#124;'
# Doxygen takes functions of one name in two programs for one, and then mixes up in which file which line is.
LINE_ANCHOR = re.compile(r'(?:id|name)="(l\d{5})"')
SOURCE_LINE = re.compile(r'href="((\w+_source\.html)#(l\d{5}))"')
ON_THIS_PAGE = {"en": "On this page", "zh": "本页内容"}
HTML_TAG = re.compile(r'<html xmlns="[^"]*">')
CODE_SPAN = re.compile(r"<code>([^<]+)</code>(?!</a>)")
FRAGMENT = re.compile(r'<div class="fragment">.*?</div><!-- fragment -->', re.DOTALL)
FRAGMENT_WORD = re.compile(r"(<[^>]*>)|\b([A-Z]\w+)\b")


class Symbols:
    """Where Doxygen documents what: declarations from its tag file, files and folders from the pages themselves."""

    def __init__(self, tag_file, html_folder):
        self.pages = {}  # path of a file or folder below the tree's top -> page
        self.api = {}  # "BezierCurve", "BezierCurve::position", "runChapter" -> page and anchor
        for page in sorted([*html_folder.glob("*_source.html"), *html_folder.glob("dir_*.html")]):
            self.pages["/".join(NAVIGATION_PATH.findall(page.read_text(encoding="utf-8")))] = page.name
        for compound in ElementTree.parse(tag_file).getroot():
            read = {"class": self._read_class, "struct": self._read_class,
                    "namespace": self._read_members}.get(compound.get("kind"))
            if read:
                read(compound)

    def _read_class(self, compound):
        name = unqualified(compound.findtext("name"))
        self.api.setdefault(name, compound.findtext("filename"))
        self._read_members(compound, name + "::")

    def _read_members(self, compound, prefix=""):
        for member in compound.findall("member"):
            target = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
            self.api.setdefault(prefix + member.findtext("name"), target)


def unqualified(name):
    return name[len("caustic::"):] if name.startswith("caustic::") else name


class Finisher:
    """Finishes the HTML pages in a folder."""

    def __init__(self, root, folder, symbols):
        self._root = root
        self._folder = folder
        self._symbols = symbols
        self._fragment_names = {name for name in symbols.api if "::" not in name and name[0].isupper()}

    def finish(self, pages):
        """All pages; in `pages`, those from Markdown with their languages, names in code become links too."""
        lines = {page.name: set(LINE_ANCHOR.findall(page.read_text(encoding="utf-8")))
                 for page in self._folder.glob("*_source.html")}
        for path in sorted(self._folder.glob("*.html")):
            text = before = path.read_text(encoding="utf-8")
            text = SOURCE_LINE.sub(lambda link: source_link(link, lines), text)
            text = TREE_LINK.sub(self._tree_link, text)
            if 'name="nested-classes"' not in text:
                text = text.replace(NESTED_CLASSES, "")
            text = EMPTY_TABLE_HEAD.sub("", text)
            language = pages.get(path.name, "en")
            text = text.replace("<h3>Table of Contents</h3>", f"<h3>{ON_THIS_PAGE[language]}</h3>")
            text = HTML_TAG.sub(lambda tag: f'{tag[0][:-1]} lang="{language}">', text)  # for what reads pages aloud
            if path.name in pages:
                text = CODE_SPAN.sub(self._code_span, text)
                text = FRAGMENT.sub(self._fragment, text)
            if text != before:
                path.write_text(text, encoding="utf-8")

    def _tree_link(self, matched):
        path, anchor = html.unescape(matched[1]), matched[2]
        page = self._symbols.pages.get(path)
        if page:
            line = f"#l{int(anchor):05}" if anchor and anchor.isdigit() else ""
            return f'href="{page}{line}"'
        if (self._root / path).is_file():
            copy_file(self._root, path, self._folder)
            return f'href="{FILES_FOLDER}/{html.escape(served_name(path))}"'
        return 'class="folder"'  # a folder without a page: its name without a link

    def _code_span(self, matched):
        text = html.unescape(matched[1])
        target = self._symbols.api.get(unqualified(re.sub(r"\(.*\)$", "", text)))
        return f'<a class="code-link" href="{target}">{matched[0]}</a>' if target else matched[0]

    def _fragment(self, matched):
        inside_link = False

        def link(token):
            nonlocal inside_link
            tag, word = token[1], token[2]
            if tag:
                inside_link = tag.startswith("<a ") or (inside_link and tag != "</a>")
                return tag
            if inside_link or word not in self._fragment_names:
                return word
            return f'<a class="code" href="{self._symbols.api[word]}">{word}</a>'

        return FRAGMENT_WORD.sub(link, matched[0])


def source_link(link, lines):
    """A link to a line of a source page; to the page alone when it has no such line."""
    page, line = link[2], link[3]
    return link[0] if line in lines.get(page, ()) else f'href="{page}"'


def served_name(path):
    """Browsers show text files whose type they know; others they would offer to save."""
    name = path.rsplit("/", 1)[-1]
    shown = ("png", "jpg", "jpeg", "gif", "svg", "txt", "json", "pdf", "html")
    return path if name.rsplit(".", 1)[-1] in shown and "." in name else path + ".txt"


def copy_file(root, path, folder):
    target = folder / FILES_FOLDER / served_name(path)
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(root / path, target)
