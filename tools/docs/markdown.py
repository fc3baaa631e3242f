r"""Turns Markdown as GitHub reads it into Markdown as Doxygen 1.9.4 reads it.

Formulas: $...$ becomes \f$...\f$, and $$...$$ becomes \f[...\f]. A line that is nothing but a link
[code: ex-01.1](../../common/curve/bezier_curve.cpp) becomes the code between those markers. Links between Markdown files
become links between pages; links to other files of the tree get the scheme tree:, which postprocess.py resolves once
Doxygen has named its pages. Code, in fences or between backticks, stays as it is.
"""

import html
import os
import re
from dataclasses import dataclass
from pathlib import PurePosixPath
from urllib.parse import unquote

from docs.tree import FENCE, HEADING

SNIPPET_LINE = re.compile(r"^(\s*)\[code: (ex-\d\d\.\d+|[a-z][a-z0-9_-]*)\]\(([^)\s]+)\)\s*$")
RAW_SNIPPET = re.compile(r"^\s*[\\@]snippet\b")
# A comment <!-- name --> on a line of its own is replaced by what the site's generator of that name draws.
GENERATED = re.compile(r"^<!-- site: ([a-z]+) -->\s*$")
# Two pictures of one size, a border between them that the reader moves: each a picture of the tree, or a panel of one
# ("bunnies.png#3", counted from 1), and what it is called.
SLIDER = re.compile(r'^<!-- site: slider (\S+) "([^"]+)" (\S+) "([^"]+)" -->\s*$')
# Below a table's first row.
TABLE_RULE = re.compile(r"^\|[\s:|-]+\|$")
# Doxygen would give each paragraph within <details> a box of its own.
DETAILS = re.compile(r"^\s*(</?details.*|<summary>.*)$")
# Where the site keeps files of the tree that it shows or links to and that are no page.
FILES_FOLDER = "files"
# Where it keeps panels of figures: panels/figures/04_kd_tree/bunnies-3.png.
PANELS_FOLDER = "panels"
RAW_HTML = "\\htmlonly[block]\n{}\n\\endhtmlonly"
# The page with <!-- site: gallery -->.
FIGURES_PAGE = "docs/figures.md"
# From this many headings on, a page has a table of contents beside its text.
MANY_HEADINGS = 4
# Fences in other languages are set without colours: Doxygen would take them for C++.
DOXYGEN_LANGUAGES = {"cpp": ".cpp", "c++": ".cpp", "python": ".py", "py": ".py"}

INLINE = re.compile(r"""
    (?P<code>   (?P<ticks>`+) (?!`) .+? (?<!`) (?P=ticks) (?!`) )
  | (?P<comment> <!-- .*? --> )
  | (?P<escaped> \\\$ )
  | \$\$ (?P<display> .+? ) \$\$
  | (?<![\w$]) \$ (?P<formula> (?=\S) [^$]+? (?<=\S) ) \$ (?![\w$]) (?P<gap> [ ] (?=[，。；：、！？）》”]) )?
  | (?<!\*) \*\* (?P<strong> (?=\S) [^*]+? (?<=\S) ) \*\* (?!\*)
  | (?<!\*) \* (?P<emphasis> (?=\S) [^*]+? (?<=\S) ) \* (?!\*)
  | !\[ (?P<alt> [^\]]* ) \] \( (?P<image> [^)\s]+ ) (?:\s+"[^"]*")? \)
  | (?<!!)\[ (?P<text> (?: [^\[\]] | !?\[[^\]]*\] )* ) \] \( (?P<target> [^)\s]+ ) (?:\s+"[^"]*")? \)
""", re.VERBOSE | re.DOTALL)


@dataclass(frozen=True)
class Problem:
    """Something in a Markdown file that would be broken on the site."""

    path: object  # below the tree's top
    line: int
    text: str

    def __str__(self):
        return f"{self.path}:{self.line}: {self.text}"


class Converter:
    """Converts one page; collects its problems and which snippets it shows."""

    def __init__(self, tree, page, snippets, generators):
        """generators: name -> function of the page that returns Markdown for Doxygen, for <!-- site: name --> lines."""
        self._tree = tree
        self._page = page
        self._snippets = snippets
        self._generators = generators
        self._line = 0
        self._headings = -1  # the title isn't counted
        self.problems = []
        self.shown = []

    def convert(self):
        """The page's text for Doxygen."""
        lines = (self._tree.root / self._page.path).read_text(encoding="utf-8").splitlines()
        out = []
        index = 0
        while index < len(lines):
            self._line = index + 1
            fence = FENCE.match(lines[index])
            end = index + 1
            if fence:
                while end < len(lines) and not self._closes(lines[end], fence[1]):
                    end += 1
                end = min(end + 1, len(lines))
                out += self._fenced(lines[index:end])
            elif self._is_alone(lines[index]):
                out += self._alone(lines[index])
            else:
                while end < len(lines) and lines[end].strip() and not FENCE.match(lines[end]) \
                        and not self._is_alone(lines[end]):
                    end += 1
                self._check_table(lines[index:end])
                out.append(self._inline("\n".join(lines[index:end])))
            index = end
        return "\n".join(out) + "\n"

    # Blocks

    @staticmethod
    def _closes(line, fence):
        return line.strip().startswith(fence) and not line.strip().strip(fence[0])

    @staticmethod
    def _is_alone(line):
        """Whether the line is a block of its own: heading, snippet, generated part, details."""
        return any(pattern.match(line) for pattern in (HEADING, SNIPPET_LINE, RAW_SNIPPET, GENERATED, SLIDER, DETAILS))

    def _fenced(self, lines):
        matched = FENCE.match(lines[0])
        language = matched[2].strip().split(" ")[0]
        head = lines[0][:matched.start(2)] + "{" + DOXYGEN_LANGUAGES.get(language, ".unparsed") + "}"
        return [head] + lines[1:]

    def _alone(self, line):
        if HEADING.match(line):
            return [self._heading(HEADING.match(line))]
        if SNIPPET_LINE.match(line):
            return self._snippet(*SNIPPET_LINE.match(line).groups())
        if DETAILS.match(line):
            return ["", RAW_HTML.format(line.strip()), ""]
        if SLIDER.match(line):
            return self._slider(*SLIDER.match(line).groups())
        if GENERATED.match(line):
            return self._generated(GENERATED.match(line)[1])
        self._complain(r"GitHub shows \snippet as it stands; write [code: ex-NN.k](path/of/the/file.cpp)")
        return []

    def _heading(self, matched):
        self._headings += 1
        hashes, text = matched[1], self._inline(matched[2])
        if self._headings == 0:
            text = self._page.title
            label = "mainpage" if self._page.name == "index" else self._page.name
            contents = ["", "[TOC]", ""] if len(self._page.anchors) >= MANY_HEADINGS else []
            return "\n".join([f"{hashes} {text} {{#{label}}}", *contents])
        label = self._page.label(self._page.anchors[self._headings - 1])
        return f"{hashes} {text} {{#{label}}}"

    def _snippet(self, indent, marker, target):
        snippet = self._snippets.get(marker)
        path = self._resolve(target)
        if snippet is None:
            return self._complain(f"there is no code marked //! [{marker}]")
        if snippet.path != path:
            return self._complain(f"{marker} is not in {path} but in {snippet.path}")
        self.shown.append(marker)
        head = (f'<div class="snippet-head"><span class="snippet-marker">{marker}</span> '
                f'<a href="tree:/{path}#L{snippet.line}">{path}:{snippet.line}</a></div>')
        return [indent + line for line in ["", head, "", "~~~~{.cpp}", *snippet.code.splitlines(), "~~~~", ""]]

    def _generated(self, name):
        if name not in self._generators:
            return self._complain(f"the site generates no '{name}'; it generates {', '.join(sorted(self._generators))}")
        return [self._generators[name](self._page)]

    def _slider(self, before, before_name, after, after_name):
        pictures = [self._slider_picture(target, name) for target, name in ((before, before_name), (after, after_name))]
        label = html.escape(f"How much of the picture is {before_name}, the rest being {after_name}")
        return ["", RAW_HTML.format(
            f'<figure class="slider"><div class="slider-frame">{pictures[1]}{pictures[0].replace("<img", "<img class=before", 1)}'
            f'<input type="range" min="0" max="100" value="50" aria-label="{label}"></div>'
            f"<figcaption><span>{html.escape(before_name)}</span><span>{html.escape(after_name)}</span></figcaption></figure>"), ""]

    def _slider_picture(self, target, name):
        file, _, panel = target.partition("#")
        path = self._resolve(file)
        if not (self._tree.root / path).is_file() or (panel and not panel.isdigit()):
            self._complain(f"there is no picture {path}{'#' + panel if panel else ''}")
        url = f"{PANELS_FOLDER}/{path[:-len('.png')]}-{panel}.png" if panel else f"{FILES_FOLDER}/{path}"
        return f'<img src="{html.escape(url)}" alt="{html.escape(name)}" />'

    def _check_table(self, lines):
        """An empty line ends a table; what comes below it would be shown as it stands."""
        first = 0 if lines[0].strip() else 1  # of a paragraph, the empty line above it aside
        if lines[first:] and lines[first].startswith("|") and not TABLE_RULE.match("".join(lines[first + 1:first + 2])):
            self._line += first
            self._complain("a table's row without a head above it; is there an empty line within the table?")

    # Inside a paragraph

    def _inline(self, text):
        start = self._line

        def convert(matched):
            self._line = start + matched.string.count("\n", 0, matched.start())
            return self._converted(matched)

        result = INLINE.sub(convert, text)
        self._line = start
        return result

    def _converted(self, matched):
        if matched["display"] is not None:
            return r"\f[ " + one_line(matched["display"]) + r" \f]"
        if matched["formula"] is not None:
            if "|" in matched["formula"] and self._in_table(matched):
                self._complain(r"a bar ends the table's cell, in a formula too; write \lvert and \rvert")
            # GitHub asks for a space between a formula and Chinese punctuation; set, there is to be none.
            return r"\f$" + one_line(matched["formula"]) + r"\f$"
        for kind, mark in (("strong", "**"), ("emphasis", "*")):
            if matched[kind] is not None:
                return self._emphasised(kind, mark, INLINE.sub(self._converted, matched[kind]))
        if matched["image"] is not None:
            return self._image(matched["alt"], matched["image"])
        if matched["target"] is not None:
            return self._link(matched["text"], matched["target"])
        if matched["comment"] is not None:
            return ""
        return matched[0]

    def _emphasised(self, kind, mark, inner):
        """Doxygen wants a space before a star, which Chinese has not."""
        tag = {"strong": "b", "emphasis": "em"}[kind]
        return f"<{tag}>{inner}</{tag}>" if self._page.language == "zh" else mark + inner + mark

    @staticmethod
    def _in_table(matched):
        start = matched.string.rfind("\n", 0, matched.start()) + 1
        return matched.string.startswith("|", start)

    def _image(self, alt, target):
        if is_external(target):
            self._complain(f"the site works without a network, so {target} must be a file of the tree")
            return ""
        path = self._resolve(target)
        if not (self._tree.root / path).is_file():
            self._complain(f"there is no picture {path}")
        return image_html(path, alt)

    def _link(self, text, target):
        inner = INLINE.sub(self._converted, text)
        if is_external(target):
            return f"[{inner}]({target})"
        file, _, anchor = target.partition("#")
        path = self._resolve(file) if file else str(self._page.path)
        if (self._tree.root / path).is_dir() and f"{path}/README.md" in self._tree.pages:
            path = f"{path}/README.md"
        page = self._tree.pages.get(path)
        if page is not None:
            return f'<a href="{page.url}{self._page_anchor(page, anchor)}">{inner}</a>'
        if self._tree.leaves_out(path):
            return inner
        if path in self._tree.figure_folders():
            return f'<a href="{self._figures_page()}#{path.replace("/", "-")}">{inner}</a>'
        if not (self._tree.root / path).exists():
            self._complain(f"dead link: there is no {path}")
        return f'<a href="tree:/{path}{"#" + anchor if anchor else ""}">{inner}</a>'

    def _figures_page(self):
        """The page that shows all figures."""
        page = self._tree.pages.get(FIGURES_PAGE)
        if page is None:
            self._complain(f"there is no {FIGURES_PAGE}, which shows the figures of this folder")
        return page.url if page else ""

    def _page_anchor(self, page, anchor):
        if not anchor or anchor == page.own_anchor:
            return ""
        if unquote(anchor) not in page.anchors:
            self._complain(f"dead link: {page.path} has no heading #{anchor}")
        return "#" + page.label(unquote(anchor))

    def _resolve(self, target):
        """A target relative to this page -> path below the tree's top."""
        path = os.path.normpath(os.path.join(self._page.path.parent, unquote(target)))
        return PurePosixPath(path).as_posix()

    def _complain(self, text):
        self.problems.append(Problem(self._page.path, self._line, text))
        return []


def one_line(formula):
    """A line of a formula that starts with + or - would be taken for a list."""
    return " ".join(formula.split())


def is_external(target):
    return re.match(r"[a-z][a-z0-9+.-]*:", target) is not None


def image_html(path, alt):
    """A picture of the tree, linked to itself in full size."""
    url = f"{FILES_FOLDER}/{path}"
    return (f'\\htmlonly<a class="figure" href="{url}"><img src="{url}" alt="{html.escape(alt)}" loading="lazy"/></a>'
            r'\endhtmlonly')
