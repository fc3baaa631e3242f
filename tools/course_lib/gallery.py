"""One page with all figures, chapter by chapter, with the lessons' captions: build/figures/index.html.

It shows a chapter's committed figures where the sources still make them, and else its drafts. It is written again after each
chapter, so that it can be looked at while the others are drawn.
"""

import html
import os
import re

from course_lib.paths import DRAFT_FIGURES, FIGURES, ROOT

PAGE = DRAFT_FIGURES / "index.html"
PICTURE = re.compile(r"!\[([^\]]*)\]\(\S*?figures/(\w+)/([\w.]+\.png)\)")
TITLE = re.compile(r"^# (.+)$", re.MULTILINE)
HEAD = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Caustic: all figures</title>
<style>
body { font: 16px/1.5 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; background: #fff }
figure { margin: 2em 0 }
img { max-width: 100%; border: 1px solid #ddd }
figcaption { color: #555 }
</style>
<h1>Caustic: all figures</h1>
"""


def write_page(chapters, is_current, page=PAGE, root=ROOT):
    """Writes the page and returns its path.

    @param chapters  names of those to show, in order
    @param is_current  whether a chapter's committed figures are what its sources make
    """
    text = HEAD + "".join(section(chapter, is_current(chapter), page, root) for chapter in chapters)
    page.parent.mkdir(parents=True, exist_ok=True)
    temporary = page.with_suffix(".tmp")
    temporary.write_text(text + "</html>\n", encoding="utf-8")
    temporary.replace(page)
    return page


def section(chapter, current, page, root):
    """A chapter: its title, then its pictures in the order of the lesson, those that the lesson leaves out last."""
    lesson = (root / "chapters" / chapter / "README.md").read_text(encoding="utf-8")
    title = TITLE.search(lesson)
    committed, drafts = root / FIGURES.relative_to(ROOT) / chapter, page.parent / chapter
    captions = {file: caption for caption, folder, file in PICTURE.findall(lesson) if folder == chapter}
    drawn = {path.name for folder in (committed, drafts) for path in folder.glob("*.png")}
    names = [name for name in captions if name in drawn] + sorted(drawn - set(captions))
    figures = "".join(figure(name, captions.get(name, ""), committed / name, drafts / name, current, page) for name in names)
    return f"<h2>{html.escape(title[1] if title else chapter)}</h2>\n" + (figures or "<p>Not drawn yet.</p>\n")


def figure(name, caption, committed, draft, current, page):
    shown, quality = (draft, "draft") if draft.exists() and not (current and committed.exists()) else (committed, "report")
    if quality == "report" and not current:
        quality = "report, of older sources"
    source = html.escape(os.path.relpath(shown, page.parent))
    other = f', <a href="{html.escape(os.path.relpath(draft, page.parent))}">draft</a>' if shown != draft and draft.exists() else ""
    return (f'<figure><a href="{source}"><img src="{source}" alt="{html.escape(caption)}" loading="lazy"></a>\n'
            f"<figcaption>{html.escape(caption)} <small>({name}, {quality}{other})</small></figcaption></figure>\n")
