"""Doxygen's search, mended: lessons and headings are found by any of their words, before classes, with and without accents.

Chinese has no spaces between words; there a text is found from each of its characters on.
"""

import html
import re
import unicodedata

from course_lib.errors import CourseError
from docs.tree import headings

# Words that nobody looks for.
LEAST_LETTERS = 3
# Doxygen's way from what was typed to what is compared; ours drops the accents first.
TYPED = ('this.DOMSearchField().value.replace(/^ +/, "")',
         'this.DOMSearchField().value.replace(/^ +/, "").normalize("NFD").replace(/[\\u0300-\\u036f]/g, "")')
SECTIONS = re.compile(r'(0: ")([^"]*)(")')
DATA, DATA_END = "var searchData=\n[\n", "];\n"
CHINESE_CHARACTER = r"[\u3400-\u9fff]"


def put_lessons_first(tree, folder):
    """Puts titles and headings of the pages before whatever else the search finds; titles of lessons before all."""
    search = folder / "search"
    letters = mended_script(search)
    entries = {}
    pages = sorted(tree.pages.values(), key=lambda page: (not page.name.startswith("chapter_"), page.name))
    named = [(page.title, page.url, "") for page in pages] + [heading for page in pages for heading in headings_of(tree, page)]
    for place, (text, url, scope) in enumerate(named):
        for key in keys(text):
            entries.setdefault(key[0], []).append(entry(key, place, text, url, scope))
    letters = with_more_letters(search, letters, sorted(filter(str.isalnum, set(entries) - set(letters))))
    for letter, lines in entries.items():
        if letter in letters:
            prepend(search / f"all_{letters.index(letter):x}.js", lines)


def mended_script(search):
    """Mends search.js; returns the first letters that there is data for, in the order of the data's files."""
    script = (search / "search.js").read_text(encoding="utf-8")
    if TYPED[0] not in script:
        raise CourseError("this Doxygen's search.js is another one; see tools/docs/search.py")
    (search / "search.js").write_text(script.replace(*TYPED), encoding="utf-8")
    return SECTIONS.search((search / "searchdata.js").read_text(encoding="utf-8"))[2]


def with_more_letters(search, letters, more):
    """Gives the search empty data for first letters that Doxygen found nothing for; returns all letters."""
    page = (search / "all_0.html").read_text(encoding="utf-8")
    for index, _ in enumerate(more, start=len(letters)):
        (search / f"all_{index:x}.js").write_text(DATA + DATA_END, encoding="utf-8")
        (search / f"all_{index:x}.html").write_text(page.replace("all_0.js", f"all_{index:x}.js"), encoding="utf-8")
    data = search / "searchdata.js"
    letters += "".join(more)
    data.write_text(SECTIONS.sub(lambda section: section[1] + letters + section[3], data.read_text(encoding="utf-8"), count=1),
                    encoding="utf-8")
    return letters


def headings_of(tree, page):
    """(text, address, the page's title) of a page's headings below its title."""
    texts = [text for _, text in headings((tree.root / page.path).read_text(encoding="utf-8"))][1:]
    return [(plain(text), f"{page.url}#{page.label(anchor)}", page.title) for text, anchor in zip(texts, page.anchors)]


def plain(text):
    """A heading without Markdown's signs and formulas' dollars."""
    return re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text).replace("`", "").replace("*", "").replace("$", "")


def keys(text):
    """What finds a text: itself without accents in small letters, from its start and from each longer word on."""
    folded = "".join(letter for letter in unicodedata.normalize("NFD", text.lower()) if not unicodedata.combining(letter))
    words = [word.start() for word in re.finditer(r"\w+", folded) if len(word[0]) >= LEAST_LETTERS]
    starts = {0, *words, *(character.start() for character in re.finditer(CHINESE_CHARACTER, folded))}
    return [folded[start:] for start in sorted(starts) if folded[start:start + 1].strip()]


def entry(key, place, text, url, scope):
    """A line of Doxygen's data; its name is compared as Doxygen's convertToId writes what was typed."""
    name = re.sub(r"[^a-z0-9\u0080-\uffff]", lambda sign: f"_{ord(sign[0]):02x}", key)
    quoted = [html.escape(part).replace("\\", "\\\\") for part in (text, url, scope)]
    return f"  ['{name}_p{place}',['{quoted[0]}',['../{quoted[1]}',1,'{quoted[2]}']]],\n"


def prepend(path, lines):
    data = path.read_text(encoding="utf-8")
    if not data.startswith(DATA):
        raise CourseError(f"{path.name} isn't as this course's Doxygen writes it; see tools/docs/search.py")
    path.write_text(DATA + "".join(lines) + data[len(DATA):], encoding="utf-8")
