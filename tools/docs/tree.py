"""What the site is made from: the Markdown files of the tree, and which page each becomes."""

import os
import re
import unicodedata
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from exercises.student import LEFT_OUT, is_student_tree

FENCE = re.compile(r"^ {0,3}(?:[-*]\s+|\d+\.\s+)?\s*(```+|~~~+)(.*)$")
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*\s*$")
MAIN_PAGE = "README.md"
# Chinese pages stand beside the English ones: README.zh.md beside README.md.
CHINESE = ".zh.md"
LESSONS = ("chapter_", "zh_chapter_")  # what names of lessons begin with
# Folders whose Markdown is no page of the course.
SKIPPED_FOLDERS = {"build", "node_modules", "mistakes", "__pycache__"}


@dataclass
class Page:
    """One Markdown file and the HTML page that it becomes."""

    path: PurePosixPath  # below the tree's top
    name: str  # of the HTML file, without .html
    title: str  # with the chapter's number in front, if it is a lesson
    own_anchor: str  # of its title, as GitHub names it
    anchors: list = field(default_factory=list)  # of its headings below the title, as GitHub names them, in order
    language: str = "en"  # or "zh"

    @property
    def url(self):
        return f"{self.name}.html"

    def label(self, anchor):
        """Doxygen's label of a heading: unlike GitHub's anchor it has to be unique in the whole site, and ASCII."""
        if self.language == "zh" and anchor in self.anchors:
            return f"{self.name}-{self.anchors.index(anchor) + 1}"
        return f"{self.name}-{ascii_only(anchor)}"


def ascii_only(text):
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9_-]", "", plain)


def page_name(path):
    """chapters/01_bezier_curves/README.md -> chapter_01_bezier_curves, docs/grading.md -> grading, README.md -> index.

    A Chinese page has the name of the English one with zh_ before it.
    """
    path = PurePosixPath(path)
    if path.name.endswith(CHINESE):
        return "zh_" + page_name(english(path))
    if str(path) == MAIN_PAGE:
        return "index"
    if path.name != "README.md":
        return path.stem.lower()
    folders = path.parts[:-1]
    return f"chapter_{folders[1]}" if folders[0] == "chapters" else "about_" + "_".join(folders)


def english(path):
    """README.zh.md -> README.md"""
    return path.with_name(path.name[:-len(CHINESE)] + ".md")


def github_anchor(heading):
    """The anchor that GitHub gives to a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)  # of links and images, their text
    text = re.sub(r"[`*]", "", text).strip().lower()
    text = re.sub(r"[^\w\- ]", "", text)
    return text.replace(" ", "-")


def headings(text):
    """(level, text) of all headings outside of code."""
    fence = None
    for line in text.splitlines():
        matched = FENCE.match(line)
        if matched and fence is None:
            fence = matched[1]
        elif matched and fence and matched[1].startswith(fence) and not matched[2].strip():
            fence = None
        elif fence is None and HEADING.match(line):
            yield len(HEADING.match(line)[1]), HEADING.match(line)[2]


def read_page(root, path):
    text = (root / path).read_text(encoding="utf-8")
    found = list(headings(text))
    heading = found[0][1] if found and found[0][0] == 1 else path.stem
    name = page_name(path)
    number = f"{path.parts[1][:2]} " if name.startswith(LESSONS) else ""
    title = re.sub(r"[`*]", "", heading)
    page = Page(path, name, title if title.startswith(number) else number + title, github_anchor(heading),
                language="zh" if path.name.endswith(CHINESE) else "en")
    seen = {}
    for _, heading in found[1:]:
        anchor = github_anchor(heading)
        times = seen.get(anchor, 0)
        seen[anchor] = times + 1
        page.anchors.append(f"{anchor}-{times}" if times else anchor)
    return page


class Tree:
    """The Markdown pages of a source tree."""

    def __init__(self, root):
        self.root = Path(root).resolve()
        self.pages = {str(path): read_page(self.root, path) for path in sorted(self._markdown_files())}

    def _markdown_files(self):
        for folder, folders, files in os.walk(self.root):
            folders[:] = sorted(name for name in folders if name not in SKIPPED_FOLDERS and not name.startswith("."))
            for name in files:
                if name.endswith(".md"):
                    yield PurePosixPath(Path(folder, name).relative_to(self.root).as_posix())

    def leaves_out(self, path):
        """Whether this is a student's tree, which has no such file on purpose."""
        if not is_student_tree(self.root) or (self.root / path).exists():
            return False
        return f"{path}/".startswith(LEFT_OUT) or "mistakes" in PurePosixPath(path).parts

    def chapters(self, language="en"):
        """Pages of the lessons in a language, in order."""
        return [page for page in self.pages.values() if page.name.startswith(LESSONS) and page.language == language]

    def chinese(self):
        """The Chinese pages, the front page first."""
        pages = [page for page in self.pages.values() if page.language == "zh"]
        return sorted(pages, key=lambda page: (page.name != "zh_index", page.name))

    def figure_folders(self):
        """Folders with a lesson's pictures, lessons in order: path below the tree's top -> the lesson's page."""
        folders = {f"figures/{self.chapter_of(page)}": page for page in self.chapters()}
        return {path: page for path, page in folders.items() if any((self.root / path).glob("*.png"))}

    def chapter_of(self, page):
        """"01_bezier_curves" of a lesson's page, None of any other."""
        return page.path.parts[1] if page.name.startswith(LESSONS) else None
