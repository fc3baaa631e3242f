"""The page that lists the mistakes which the graded tests have to catch, from the heads of their patches."""

from collections import Counter

from exercises.catalog import catalog_path, read_catalog
from exercises.mistakes import patch_head
from strip import order_key

FOLDERS = ("mistakes", "alternatives")


class MistakeTable:
    """Makes a sum and, for each chapter, a table: exercise, mistake, the test that catches it."""

    def __init__(self, tree):
        self._tree = tree

    def page(self):
        chapters = [(page, *self._of(page)) for page in self._tree.chapters()]
        chapters = [(page, catalog, mistakes, right) for page, catalog, mistakes, right in chapters if mistakes]
        if not chapters:
            return "A student's tree holds no patches: their context is the solution."
        return "\n".join([self._sum(chapters), *(self._section(page, mistakes) for page, _, mistakes, _ in chapters)])

    def _of(self, page):
        """(catalog, [(path, head)] of its mistakes, number of its alternatives); nothing of a chapter without graded tests."""
        chapter, root = self._tree.chapter_of(page), self._tree.root
        if not catalog_path(chapter, root).exists():
            return None, [], 0
        mistakes, right = (sorted((root / "tests" / chapter / folder).glob("*.patch")) for folder in FOLDERS)
        heads = [(path.relative_to(root).as_posix(), patch_head(path.read_text(encoding="utf-8"))) for path in mistakes]
        return read_catalog(chapter, root), sorted(heads, key=lambda mistake: order_key(mistake[1]["exercise"])), len(right)

    def _sum(self, chapters):
        rows = [(page.title, len({head["exercise"] for _, head in mistakes}), len(catalog.tests), len(mistakes),
                 most_by_one(mistakes), right) for page, catalog, mistakes, right in chapters]
        totals = [sum(row[column] for row in rows) for column in (1, 2, 3)]
        lines = ["| " + " | ".join(map(str, row)) + " |" for row in rows]
        return "\n".join(["| chapter | exercises | graded tests | mistakes | most that one test is named for | right alternatives |",
                          "| :-- | --: | --: | --: | --: | --: |", *lines,
                          f"| together | {totals[0]} | {totals[1]} | {totals[2]} | | {sum(row[5] for row in rows)} |", ""])

    def _section(self, page, mistakes):
        chapter = self._tree.chapter_of(page)
        lines = [f"| {head['exercise']} | <a href=\"tree:/{path}\">{in_a_cell(head['mistake'])}</a> | `{head['caught-by']}` |"
                 for path, head in mistakes]
        return "\n".join([f"\n## {page.title} {{#mistakes-{chapter}}}\n", "| exercise | mistake | caught by |", "| :-- | :-- | :-- |",
                          *lines, ""])


def most_by_one(mistakes):
    return max(Counter(head["caught-by"] for _, head in mistakes).values())


def in_a_cell(text):
    """A sentence within a table's cell and a link: nothing in it ends them."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("|", "&#124;").replace("*", "&#42;").replace("`", "")
