"""Checks that every link, picture, script and style sheet of a folder of HTML files is there."""

import html
import os
import re
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlsplit

# In HTML as Doxygen writes it: a quotation mark that belongs to the text is an entity.
ATTRIBUTE = re.compile(r'\s(href|src|xlink:href|id|name)="([^"]+)"')
SEARCH_TARGET = re.compile(r"'\.\./([^'#]+)(?:#([^']*))?'")
ELSEWHERE = ("http", "https", "mailto", "javascript", "data")


@dataclass
class Page:
    """What a page links to and what it offers."""

    text: str
    links: list  # (place in the text, target)
    anchors: set


def parse(path):
    text = path.read_text(encoding="utf-8")
    page = Page(text, [], set())
    for matched in ATTRIBUTE.finditer(text):
        value = html.unescape(matched[2])
        if matched[1] in ("id", "name"):
            page.anchors.add(value)
        else:
            page.links.append((matched.start(), value))
    return page


def dead_links(folder):
    """One line for each dead link in the folder's HTML files and in Doxygen's search data."""
    return LinkChecker(Path(folder)).dead()


class LinkChecker:
    """The links of all pages in a folder."""

    def __init__(self, folder):
        self._folder = os.path.realpath(folder)
        self._files = {os.path.join(at, name) for at, _, names in os.walk(self._folder) for name in names}
        self._pages = {path: parse(Path(path)) for path in sorted(self._files) if path.endswith(".html")}

    def dead(self):
        dead = []
        for path, page in self._pages.items():
            for start, target in page.links:
                reason = self._why_dead(target, path)
                if reason:
                    line = page.text.count("\n", 0, start) + 1
                    dead.append(f"{os.path.relpath(path, self._folder)}:{line}: {target}: {reason}")
        return dead + self._dead_in_search()

    def _dead_in_search(self):
        """The search finds what these files list, relative to their own folder."""
        front = os.path.join(self._folder, "index.html")
        dead = []
        for path in sorted(path for path in self._files if re.search(r"/search/[^/]+\.js$", path)):
            targets = set(SEARCH_TARGET.findall(Path(path).read_text(encoding="utf-8")))
            for target in sorted(file + ("#" + anchor if anchor else "") for file, anchor in targets):
                reason = self._why_dead(target, front)
                if reason:
                    dead.append(f"{os.path.relpath(path, self._folder)}:1: {target}: {reason}")
        return dead

    def _why_dead(self, target, path):
        """Nothing for a target that is there, or on another site."""
        if target.startswith("#"):
            return None if unquote(target[1:]) in self._pages[path].anchors | {""} else "there is no such anchor"
        parts = urlsplit(target)
        if parts.scheme in ELSEWHERE:
            return None
        if parts.scheme or parts.netloc:
            return f"unknown scheme {parts.scheme}"
        file = os.path.normpath(os.path.join(os.path.dirname(path), unquote(parts.path)))
        if not file.startswith(self._folder + os.sep):
            return "leads out of the site"
        if file not in self._files:
            return "there is no such file"
        if parts.fragment and file in self._pages and unquote(parts.fragment) not in self._pages[file].anchors:
            return "there is no such anchor"
        return None
