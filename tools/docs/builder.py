"""Builds the site: checks the lessons, runs Doxygen, finishes its HTML, checks every link."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from course_lib.errors import CourseError
from docs.doxygen_warnings import relevant_warnings
from docs.filter import page_text
from docs.links import dead_links
from docs.markdown import FILES_FOLDER, PANELS_FOLDER, Converter, Problem
from docs.panels import Sheet
from docs.parts import Parts
from docs.postprocess import Finisher, Symbols, copy_file
from docs.search import put_lessons_first
from docs.snippets import all_snippets
from docs.tree import LESSONS, MAIN_PAGE, SKIPPED_FOLDERS, Tree

THEME = "docs/theme"
AWESOME = Path("/usr/share/doxygen-awesome-css")
MATHJAX = Path("/usr/share/javascript/mathjax")
# What MathJax loads for formulas in TeX, set as SVG: 3 MB of 24.
MATHJAX_PARTS = ("MathJax.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG/autoload",
                 "jax/output/SVG/config.js", "jax/output/SVG/jax.js", "jax/output/SVG/fonts/TeX")


class Builder:
    """Builds the site of a source tree into <out>/html."""

    def __init__(self, root, out, declarations_file, declarations):
        self._root = Path(root).resolve()
        self._out = Path(out).resolve()
        self._declarations_file = Path(declarations_file).resolve()
        self._tree = Tree(self._root)
        self._parts = Parts(self._tree, declarations)
        self._snippets = all_snippets(self._root)

    @property
    def html(self):
        return self._out / "html"

    def lesson_problems(self):
        """What is broken in the Markdown files themselves: dead links, pictures and snippets, markers not shown."""
        problems, shown = [], {}
        if MAIN_PAGE not in self._tree.pages:
            problems.append(Problem(MAIN_PAGE, 1, "it is missing, and it is the site's front page"))
        for page in self._tree.pages.values():
            converter = Converter(self._tree, page, self._snippets, self._parts.generators())
            page_text(converter, page, self._parts)
            problems += converter.problems
            for marker in converter.shown:
                shown.setdefault(marker, []).append(page)
        return [str(problem) for problem in problems + self._marker_problems(shown)]

    def _marker_problems(self, shown):
        """Each exercise of a chapter that stands is to be shown once, by its own chapter's lesson; other code, somewhere."""
        problems = []
        standing = {folder.name[:2] for folder in self._chapter_folders()}
        for marker, snippet in self._snippets.items():
            if not snippet.chapter and marker not in shown:
                problems.append(Problem(snippet.path, snippet.line, f"no page shows {marker}; take the marker away"))
            if snippet.chapter not in standing:
                continue
            own = [page for page in shown.get(marker, []) if (self._tree.chapter_of(page) or "")[:2] == snippet.chapter]
            lessons = [page for page in own if page.language == "en"]
            others = [page for page in shown.get(marker, []) if page not in own]
            if len(lessons) != 1:
                problems.append(Problem(snippet.path, snippet.line, f"the lesson of chapter {snippet.chapter} shows "
                                        f"{marker} {len(lessons)} times instead of once"))
            problems += [Problem(page.path, 1, f"it shows {marker}, which is another chapter's") for page in others]
        return problems

    def _chapter_folders(self):
        return (self._root / "chapters").glob("[0-9][0-9]_*")

    def build(self):
        """Runs Doxygen and finishes what it wrote.

        @return all problems, one a line; none when the site is good
        """
        shutil.rmtree(self._out, ignore_errors=True)
        self.html.mkdir(parents=True)
        self._write_header()
        self._write_layout()
        warnings = self._run_doxygen()
        missing = [page.url for page in self._tree.pages.values() if not (self.html / page.url).exists()]
        if missing:
            return warnings + [f"Doxygen wrote no {', '.join(missing)}"]
        self._copy_mathjax()
        self._copy_pictures()
        self._parts.draw_charts(self.html)
        problems = warnings + self._cut_panels()
        put_lessons_first(self._tree, self.html)
        Finisher(self._root, self.html, Symbols(self._out / "symbols.xml", self.html)).finish(
            {page.url: page.language for page in self._tree.pages.values()})
        return problems + dead_links(self.html)

    def _write_header(self):
        """Doxygen's own header, with our scripts."""
        doxygen("-w", "html", self._out / "header.html", self._out / "unused_footer.html", self._out / "unused.css")
        header = (self._out / "header.html").read_text(encoding="utf-8")
        ours = (self._root / THEME / "head.html").read_text(encoding="utf-8")
        (self._out / "header.html").write_text(header.replace("</head>", ours + "</head>"), encoding="utf-8")

    def _write_layout(self):
        """Doxygen's own layout, with the course's navigation."""
        doxygen("-l", self._out / "layout.xml")
        layout = (self._out / "layout.xml").read_text(encoding="utf-8")
        ours = (self._root / THEME / "navigation.xml").read_text(encoding="utf-8")
        lessons = "\n".join(tab(page) for page in self._tree.chapters())
        shown = {"index", *re.findall(r'url="(?:@ref )?(\w+)(?:\.html)?"', ours)}
        others = "\n".join(tab(page) for page in self._tree.pages.values()
                           if page.name not in shown and not page.name.startswith(LESSONS) and page.language == "en")
        chinese = "\n".join(tab(page) for page in self._tree.chinese())
        group = f'<tab type="usergroup" url="[none]" title="中文">\n{chinese}\n    </tab>' if chinese else ""
        for name, tabs in (("lessons", lessons), ("others", others), ("chinese", group)):
            ours = ours.replace(f"<!-- {name} -->", tabs)
        layout = re.sub(r"<navindex>.*?</navindex>", lambda _: ours, layout, flags=re.DOTALL)
        (self._out / "layout.xml").write_text(layout, encoding="utf-8")

    def _run_doxygen(self):
        """Doxygen's warnings."""
        chapters = sorted(folder.relative_to(self._root).as_posix() for folder in self._chapter_folders())
        environment = dict(os.environ, CAUSTIC_OUT=str(self._out), CAUSTIC_AWESOME=str(installed(AWESOME)),
                           CAUSTIC_DECLARATIONS=str(self._declarations_file), CAUSTIC_CHAPTER_FOLDERS=" ".join(chapters),
                           CAUSTIC_INPUT=" ".join(self._input()))
        doxygen("docs/Doxyfile", cwd=self._root, env=environment)
        return relevant_warnings((self._out / "warnings.txt").read_text(encoding="utf-8"), self._root)

    def _input(self):
        """What Doxygen reads of the top folder: pages and folders, none that is built."""
        return sorted(path.name for path in self._root.iterdir()
                      if path.suffix == ".md" or (path.is_dir() and path.name not in SKIPPED_FOLDERS and path.name[0] != "."))

    def _copy_mathjax(self):
        for part in MATHJAX_PARTS:
            source, target = installed(MATHJAX) / part, self.html / "mathjax" / part
            target.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, target)
            else:
                shutil.copyfile(source, target)

    def _copy_pictures(self):
        """Those that pages show, at their paths below the tree's top."""
        shown = set(self._parts.pictures())
        for page in self._tree.pages.values():
            text = (self.html / page.url).read_text(encoding="utf-8")
            shown.update(re.findall(rf'src="{FILES_FOLDER}/([^"]+)"', text))
        for path in sorted(shown):
            copy_file(self._root, path, self.html)

    def _cut_panels(self):
        """The panels of figures that pages show alone; what is wrong with them."""
        wanted = {}  # the figure's path below the tree's top, without .png -> numbers of panels
        for page in self._tree.pages.values():
            for path, number in re.findall(rf'src="{PANELS_FOLDER}/([^"]+)-(\d+)\.png"',
                                           (self.html / page.url).read_text(encoding="utf-8")):
                wanted.setdefault(path, set()).add(int(number))
        problems = []
        for path, numbers in sorted(wanted.items()):
            sheet = Sheet(self._root / f"{path}.png")
            problems += [f"{path}.png: it has {len(sheet.panels())} panels, and a page shows number {number}" for number in
                         sorted(numbers) if not sheet.save_panel(number, self.html / PANELS_FOLDER / f"{path}-{number}.png")]
        return problems


def tab(page):
    title = page.title.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")
    return f'      <tab type="user" url="{page.url}" title="{title}"/>'


def installed(folder):
    if not folder.is_dir():
        raise CourseError(f"{folder} is missing; ./course setup --group docs installs what the site needs")
    return folder


def doxygen(*arguments, cwd=None, env=None):
    command = ["doxygen", *map(str, arguments)]
    try:
        finished = subprocess.run(command, cwd=cwd, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    except FileNotFoundError:
        raise CourseError("there is no program 'doxygen'; ./course setup --group docs installs it") from None
    if finished.returncode != 0:
        last = (finished.stdout.strip().splitlines() or ["it says nothing"])[-1]
        raise CourseError(f"doxygen failed: {last}")
