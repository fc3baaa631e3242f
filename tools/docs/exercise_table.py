"""The page that lists all exercises, from grading.json and the bodies themselves."""

from course_lib.cpp_source import without_comments
from docs.snippets import all_snippets
from exercises.catalog import catalog_path, read_catalog


class ExerciseTable:
    """Makes the tables, one for each chapter that has graded tests, and the sums."""

    def __init__(self, tree):
        self._tree = tree

    def page(self):
        snippets = all_snippets(self._tree.root)
        pages = [page for page in self._tree.chapters() if catalog_path(self._tree.chapter_of(page), self._tree.root).exists()]
        return "\n".join(self._section(page, snippets) for page in pages)

    def _section(self, page, snippets):
        chapter = self._tree.chapter_of(page)
        catalog = read_catalog(chapter, self._tree.root)
        rows = [(exercise, text, snippets[exercise], sum(test.points for test in catalog.tests_of(exercise)))
                for exercise, text in catalog.exercises.items()]
        lines = [f'| {exercise} | {text.title} | <a href="tree:/{snippet.path}#L{snippet.line}">{snippet.path.removeprefix("common/")}</a> '
                 f"| {code_lines(snippet.code)} | {text.minutes} | {points} |" for exercise, text, snippet, points in rows]
        total = (f"| | together | | {sum(code_lines(snippet.code) for _, _, snippet, _ in rows)} "
                 f"| {sum(text.minutes for _, text, _, _ in rows)} | {sum(points for *_, points in rows)} |")
        return "\n".join([f'\n## {page.title} {{#exercises-{chapter}}}\n\n<a href="{page.url}">The lesson</a>\n',
                          "| exercise | what the student writes | where | lines | minutes | points |",
                          "| :-- | :-- | :-- | --: | --: | --: |", *lines, total, ""])



def code_lines(code):
    """Lines of code that hold more than comments."""
    return len(without_comments(code).splitlines())
