"""One page with every committed figure: picture, caption, data, and what made it. Nothing is drawn for it.

The page is one file: pictures and tables are in it, so that it can be sent. Chromium prints it as PDF.
"""

import base64
import csv
import html
import re
import webbrowser

from course_lib import provenance
from course_lib.errors import CourseError
from course_lib.paths import BUILD, FIGURES, ROOT, build_dir, declarations, shown
from course_lib.terminal import Step, count, format_duration, say
from docs import browser
from docs.figure_gallery import Makers
from exercises import student
from exercises.reports import write_file

CAPTION = re.compile(r"!\[([^\]]+)\]\(\S*?figures/(\w+)/([\w.]+\.png)\)")
TITLE = re.compile(r"^# (.+)$", re.MULTILINE)
FOLDER = BUILD / "report"
PRINTING = 300  # seconds that the browser may take
MOST_ROWS = 60  # of a table that are shown; a longer one shows its beginning, and is whole behind its link
BEGINNING = 12
PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Caustic: report of all figures</title>
<style>
body {{ font: 15px/1.5 sans-serif; max-width: 1000px; margin: 2em auto; padding: 0 1em; color: #222; background: #fff }}
h2 {{ margin-top: 2.5em; border-bottom: 1px solid #ccc }}
h3 {{ font-family: monospace; margin-bottom: .3em }}
figure {{ margin: 1em 0 }}
img {{ max-width: 100%; border: 1px solid #ddd }}
figcaption {{ color: #333 }}
.table {{ overflow-x: auto }}
table {{ border-collapse: collapse; font-size: 80%; line-height: 1.3 }}
th, td {{ border: 1px solid #ddd; padding: .1em .5em; text-align: left }}
td.number {{ text-align: right; font-variant-numeric: tabular-nums }}
.made {{ font-size: 80%; color: #555; overflow-wrap: anywhere }}
.stale {{ color: #a00 }}
@media print {{
  body {{ font-size: 10pt; max-width: none; margin: 0 }}
  h2 + h3, h2 {{ break-after: avoid }}
  h2:not(:first-of-type) {{ break-before: page }}
  h3, caption {{ break-after: avoid }}
  figure, tr, .made {{ break-inside: avoid }}
  img {{ max-height: 20cm }}
  thead {{ display: table-header-group }}
}}
@page {{ size: A4; margin: 15mm }}
</style>
<h1>Caustic: report of all figures</h1>
<p>{summary}</p>
<ul>
{contents}</ul>
{chapters}</html>
"""


def report(chapters, reasons_of, version="", root=ROOT):
    """The page as HTML.

    @param chapters  names of those to show, in order
    @param reasons_of  (chapter, entry) -> why a figure isn't what the sources make; None when that isn't known
    @param version  the course's commit
    """
    parts = [Chapter(chapter, reasons_of, root) for chapter in chapters]
    figures, pictures = (sum(getattr(part, what) for part in parts) for what in ("figures", "pictures"))
    words = [count(figures, "figure"), count(pictures, "picture"), *([f"commit {version}"] if version else [])]
    return PAGE.format(summary=html.escape(", ".join(words)),
                       contents="".join(f'<li><a href="#{part.name}">{html.escape(part.title)}</a>\n' for part in parts),
                       chapters="".join(part.html for part in parts))


class Chapter:
    """A chapter's part of the page."""

    def __init__(self, name, reasons_of, root):
        self.name = name
        self._root, self._reasons_of = root, reasons_of
        self._folder = root / FIGURES.relative_to(ROOT) / name
        lesson = (root / "chapters" / name / "README.md").read_text(encoding="utf-8")
        title = TITLE.search(lesson)
        self.title = f"{name[:2]} {title[1]}" if title else name
        self._captions = {file: " ".join(text.split()) for text, folder, file in CAPTION.findall(lesson) if folder == name}
        self._makers = Makers(root, name)
        entries = provenance.read(self._folder)
        self.figures = len(entries)
        self.pictures = sum(file.endswith(".png") for entry in entries.values() for file in entry["files"])
        parts = "".join(self._figure(figure, entry) for figure, entry in entries.items()) or "<p>Nothing is committed.</p>\n"
        self.html = f'<h2 id="{name}">{html.escape(self.title)}</h2>\n{parts}'

    def _figure(self, name, entry):
        """One figure: pictures, tables, and what made them."""
        parts = [f'<h3 id="{self.name}-{name}">{name}</h3>\n']
        for file in sorted(entry["files"], key=lambda file: not file.endswith(".png")):
            path = self._folder / file
            if not path.is_file():
                parts.append(f'<p class="stale">{html.escape(file)} is missing.</p>\n')
            elif file.endswith(".png"):
                parts.append(self._picture(path))
            elif file.endswith(".csv"):
                parts.append(table(path))
        return "".join(parts) + self._made(name, entry)

    def _picture(self, path):
        caption = html.escape(self._captions.get(path.name, path.stem.replace("_", " ")))
        return (f'<figure><img src="{data_url(path, "image/png")}" alt="{caption}">\n'
                f"<figcaption>{caption} <small>({path.name})</small></figcaption></figure>\n")

    def _made(self, name, entry):
        """Where a figure is from, in a few lines."""
        place = self._makers.code(name)
        lines = [f"<code>./course figures {self.name[:2]} --only {name}</code>" +
                 (f", drawn by <code>{place[0]}:{place[1]}</code>" if place else "")]
        lines.append(f"{entry.get('quality')} quality, seed {entry.get('seed')}, {count(entry.get('threads', 1), 'thread')}, "
                     f"{format_duration(entry.get('seconds', 0))}, at most {entry.get('peak_mib', 0):.0f} MiB; "
                     + ("shows measured times" if entry.get("timed") else "the same bits each time"))
        lines.append("made from " + ", ".join(f"{html.escape(file)} <code>{digest[:12]}</code>"
                                              for file, digest in entry.get("inputs", {}).items()))
        reasons = self._reasons_of(self.name, entry)
        if reasons:
            lines.append(f'<span class="stale">not what the sources make now: {html.escape("; ".join(reasons))}</span>')
        elif reasons is not None:
            lines.append("this is what the sources make")
        return f'<p class="made">{"<br>".join(lines)}</p>\n'


def data_url(path, kind):
    return f"data:{kind};base64,{base64.b64encode(path.read_bytes()).decode()}"


def table(path):
    """A CSV file as a table; of a long one the beginning."""
    with open(path, encoding="utf-8", newline="") as opened:
        head, *rows = list(csv.reader(opened)) or [[]]
    first = rows if len(rows) <= MOST_ROWS else rows[:BEGINNING]
    more = f"<p>{len(rows) - len(first)} more rows in the file.</p>\n" if len(first) < len(rows) else ""
    link = f'<a download="{path.name}" href="{data_url(path, "text/csv")}">{path.name}</a>, {count(len(rows), "row")}'
    return (f'<p>{link}</p>\n<div class="table"><table>\n<thead><tr>{"".join(f"<th>{html.escape(cell)}" for cell in head)}</thead>\n'
            + "".join(f"<tr>{''.join(map(cell_html, row))}\n" for row in first) + f"</table></div>\n{more}")


def cell_html(text):
    """A number with as many digits as anybody compares; the file has them all."""
    try:
        number = float(text)
    except ValueError:
        return f"<td>{html.escape(text)}"
    short = f"{number:.6g}"
    return f'<td class="number">{short if len(short) < len(text) else html.escape(text)}'


# The command: ./course figures --report


def write(chapters, args):
    """Writes the page, and prints it where there is a Chromium; returns the exit code."""
    if args.check or args.only or args.force:
        raise CourseError("--report shows all that is committed of a chapter; it goes with no --check, --only or --force")
    page = FOLDER / "figures.html"
    page.parent.mkdir(parents=True, exist_ok=True)
    write_file(page, report(chapters, reasons_now(), student.commit(ROOT)).encode())
    say(f"{shown(page)}: {page.stat().st_size / 1e6:.0f} MB")
    if browser.installed():
        printed = page.with_suffix(".pdf")
        with Step(f"print {shown(printed)}"), browser.Browser(timeout=PRINTING) as opened:
            opened.open(page)
            opened.pdf(printed)
        say(f"{shown(printed)}: {printed.stat().st_size / 1e6:.0f} MB")
    else:
        say("No PDF, as there is no Chromium; ./course setup --group test installs it")
    if args.open:
        webbrowser.open(page.as_uri())
    return 0


def reasons_now():
    """What tells why a figure isn't what the sources make; knows nothing where nothing was built yet."""
    if not (build_dir() / "declarations.json").exists():
        say("Not compared with the sources, as nothing is built: ./course build")
        return lambda chapter, entry: None
    known, current = declarations(), {}

    def reasons(chapter, entry):
        if chapter not in current:
            current[chapter] = provenance.CurrentInputs.of(chapter, known)
        return provenance.stale_reasons(entry, current[chapter], FIGURES / chapter)

    return reasons
