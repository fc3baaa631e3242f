"""Doxygen's filter for Markdown: prints a page of the tree in Doxygen's dialect. See markdown.py.

Doxygen runs it in the tree's top folder; CAUSTIC_DECLARATIONS names the file that CMake wrote.
"""

import json
import os
import sys
from pathlib import Path, PurePosixPath

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from docs.markdown import Converter
from docs.parts import Parts
from docs.snippets import all_snippets
from docs.tree import LESSONS, Tree


def page_text(converter, page, parts):
    """The whole page for Doxygen: as converted, and what the site adds at its end."""
    text = converter.convert()
    if page.name.startswith(LESSONS):
        text += parts.lesson_end(page)
    return text


def main(arguments):
    if len(arguments) != 1:
        sys.exit("usage: filter.py FILE.md")
    tree = Tree(Path.cwd())
    parts = Parts(tree, json.loads(Path(os.environ["CAUSTIC_DECLARATIONS"]).read_text()))
    page = tree.pages[str(PurePosixPath(os.path.relpath(arguments[0], tree.root)))]
    sys.stdout.reconfigure(encoding="utf-8")
    print(page_text(Converter(tree, page, all_snippets(tree.root), parts.generators()), page, parts), end="")


if __name__ == "__main__":
    main(sys.argv[1:])
