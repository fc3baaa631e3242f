"""Which figures are stale, and how the numbers and pictures of two runs are compared."""

import contextlib
import io
import json
import random
import struct
import tempfile
import unittest
import zlib
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import inputs
from commands import figures
from course_lib import png, provenance
from course_lib.chapters import choose_chapters
from course_lib.compare import Tolerances, compare_pictures, compare_tables, same_rate
from course_lib.cpp_source import without_comments
from course_lib.errors import CourseError
from course_lib.provenance import CurrentInputs, Wanted

CHAPTER = "01_curves"
DECLARATIONS = {"files": {"common/curve/curve.cpp": {"topic": "curve", "chapter": 1},
                          "common/tree/tree.cpp": {"topic": "tree", "chapter": 4},
                          "tests/support/kit.h": {"topic": "support", "chapter": 1}}}
FILES = {"common/curve/curve.cpp": "int a;\n", "common/tree/tree.cpp": "int b;\n", "tests/support/kit.h": "int c;\n",
         "chapters/01_curves/main.cpp": "int main() {}\n", "chapters/01_curves/chart.gp": "plot x\n",
         "chapters/01_curves/README.md": "A lesson.\n", "assets/cup.svg": "<svg/>\n", "assets/vase.svg": "<svg/>\n"}


class TemporaryTree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, name, content):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path


class Staleness(TemporaryTree):
    def setUp(self):
        super().setUp()
        for name, text in FILES.items():
            self.write(name, text)
        self.folder = self.root / "figures" / CHAPTER
        self.write(f"figures/{CHAPTER}/cup.png", "picture")
        current = self.current()
        self.entry = {"files": ["cup.png"], "quality": "report", "seed": 1,
                      "inputs": {"sources": current.sources, "assets/cup.svg": current.assets["assets/cup.svg"]}}

    def current(self):
        return CurrentInputs.of(CHAPTER, DECLARATIONS, self.root)

    def reasons(self, wanted=Wanted("report", 1)):
        return provenance.stale_reasons(self.entry, self.current(), self.folder, wanted)

    def test_an_unchanged_figure_is_up_to_date(self):
        self.assertEqual(self.reasons(), [])

    def test_one_byte_of_any_input_makes_it_stale(self):
        for name in ("common/curve/curve.cpp", "chapters/01_curves/main.cpp", "chapters/01_curves/chart.gp", "assets/cup.svg"):
            self.write(name, "x" + FILES[name])
            self.assertTrue(self.reasons(), f"{name} changed, but the figure is said to be up to date")
            self.write(name, FILES[name])
        self.assertEqual(self.reasons(), [])

    def test_comments_and_blank_lines_of_code_leave_it_alone(self):
        for text in ("/// What a is.\nint a;\n", "int a;  // what it's for\n", "/* long\n   story */\n\nint a;\n"):
            self.write("common/curve/curve.cpp", text)
            self.assertEqual(self.reasons(), [], text)
        self.write("chapters/01_curves/chart.gp", "# comment\n" + FILES["chapters/01_curves/chart.gp"])
        self.assertTrue(self.reasons(), "Only C++ is read as C++.")

    def test_what_looks_like_a_comment_within_text_counts(self):
        for old, new in (('"http://a";', '"http://b";'), ("int a = 10'000 /* a */ + 1'0;", "int a = 10'000 /* a */ + 1'1;"),
                         ("c = '\"'; // a", "d = '\"'; // a"), ('R"(// a)";', 'R"(// b)";')):
            self.assertNotEqual(without_comments(old), without_comments(new))

    def test_what_it_is_not_made_from_leaves_it_alone(self):
        for name in ("common/tree/tree.cpp", "tests/support/kit.h", "chapters/01_curves/README.md", "assets/vase.svg"):
            self.write(name, FILES[name] + " ")
            self.assertEqual(self.reasons(), [], f"{name} is no input of this figure")

    def test_an_asset_that_is_gone_or_a_missing_picture_makes_it_stale(self):
        (self.root / "assets/cup.svg").unlink()
        (self.folder / "cup.png").unlink()
        self.assertEqual(self.reasons(), ["assets/cup.svg is gone", "cup.png is missing"])

    def test_another_seed_or_quality_makes_it_stale(self):
        self.assertEqual(self.reasons(Wanted("draft", 1)), ["it was drawn as report with seed 1"])
        self.assertEqual(self.reasons(Wanted("report", 2)), ["it was drawn as report with seed 1"])

    def test_a_figure_without_an_entry_was_never_drawn(self):
        self.assertEqual(provenance.stale_reasons(None, self.current(), self.folder), ["it was never drawn"])

    def test_a_broken_record_is_named(self):
        self.write(f"figures/{CHAPTER}/provenance.json", "{")
        with self.assertRaisesRegex(CourseError, "provenance.json: is no record of figures; remove it"):
            provenance.read(self.folder)

    def test_figures_that_are_drawn_no_more_go_with_their_files(self):
        self.write(f"figures/{CHAPTER}/old.png", "old")
        record = {"chapter": CHAPTER, "figures": {"cup": self.entry, "old": {"files": ["old.png", "cup.png"]}}}
        self.write(f"figures/{CHAPTER}/provenance.json", json.dumps(record))
        self.assertEqual(provenance.prune(self.folder, ["cup"]), ["old.png"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["cup.png", "provenance.json"])
        self.assertEqual(list(provenance.read(self.folder)), ["cup"])


class Drawing(TemporaryTree):
    """Which figures ./course figures draws, and at what quality; the chapter's program is made up."""

    def setUp(self):
        super().setUp()
        for name, text in FILES.items():
            self.write(name, text)
        self.drawn = []
        for name, value in (("FIGURES", self.root / "figures"), ("DRAFT_FIGURES", self.root / "build/figures"),
                            ("declarations", lambda: DECLARATIONS), ("run_chapter", self.run_chapter)):
            patch = mock.patch.object(figures, name, value)
            patch.start()
            self.addCleanup(patch.stop)
        patch = mock.patch.object(CurrentInputs, "of", lambda chapter, said: CurrentInputs("sources", {}))
        patch.start()
        self.addCleanup(patch.stop)

    def run_chapter(self, chapter, out, names, quality, seed, threads=None):
        self.drawn.append((quality, *names))
        entries = {name: {"files": [], "quality": quality, "seed": seed, "inputs": {"sources": "sources"}} for name in names}
        self.write((out / chapter / "provenance.json").relative_to(self.root), json.dumps({"figures": entries}))

    def draw(self, quality="report", force=False):
        """What is drawn, and what is said."""
        self.drawn.clear()
        args = SimpleNamespace(quality=quality, only=[], force=force, seed=1, threads=None)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            figures.draw_chapter(CHAPTER, {"cup": False}, args)
        return self.drawn[:], printed.getvalue()

    def test_where_the_committed_figures_are_up_to_date_a_draft_is_drawn(self):
        self.run_chapter(CHAPTER, self.root / "figures", ["cup"], "report", 1)
        drawn, said = self.draw()
        self.assertEqual(drawn, [("draft", "cup")])
        self.assertRegex(said, r"1 figure up to date in .*figures/01_curves/ \(--force draws them again\)\n")
        self.assertEqual(self.draw()[0], [], "Is a draft that is up to date drawn again?")

    def test_what_is_stale_is_drawn_as_a_report_alone(self):
        self.assertEqual(self.draw()[0], [("report", "cup")])

    def test_drafts_alone_when_these_are_asked_for(self):
        self.assertEqual(self.draw(quality="draft")[0], [("draft", "cup")])
        self.assertEqual(self.draw(quality="draft", force=True)[0], [("draft", "cup")])

    def test_a_chapter_is_drawn_before_the_next_is_built(self):
        done = []
        args = SimpleNamespace(chapters=[], quality="draft", only=[], check=False, full=False, force=False, seed=1, threads=None,
                               open=False, report=False)
        replaced = {"choose_chapters": lambda words: ["01_curves", "02_rays"], "ensure_packages": lambda group: None,
                    "all_chapters": lambda: [], "table_of_contents": lambda chapter: {},
                    "draw_chapter": lambda chapter, table, args: done.append(f"draw {chapter}"),
                    "write_page": lambda chapters, current: done.append("page") or self.root / "index.html"}
        with contextlib.ExitStack() as stack:
            stack.enter_context(contextlib.redirect_stdout(io.StringIO()))
            stack.enter_context(mock.patch.object(figures.cmake, "build", lambda targets, title: done.append(f"build {targets[0]}")))
            for name, value in replaced.items():
                stack.enter_context(mock.patch.object(figures, name, value))
            self.assertEqual(figures.run(args), 0)
        self.assertEqual(done, ["build 01_curves", "draw 01_curves", "page", "build 02_rays", "draw 02_rays", "page", "build preview"])


class ChapterChoice(TemporaryTree):
    def setUp(self):
        super().setUp()
        for name in ("01_bezier_curves", "02_intersections", "10_sampling"):
            self.write(f"chapters/{name}/main.cpp", "")
        self.write("chapters/03_no_main/README.md", "")

    def test_a_chapter_is_named_by_number_or_in_full(self):
        for word in ("1", "01", "01_bezier_curves"):
            self.assertEqual(choose_chapters([word], self.root), ["01_bezier_curves"])
        self.assertEqual(choose_chapters(["10", "2", "02"], self.root), ["02_intersections", "10_sampling"])
        self.assertEqual(len(choose_chapters([], self.root)), 3)

    def test_anything_else_is_an_error_that_lists_what_there_is(self):
        for word in ("0", "3", "001", "1_", "01_bezier", "bezier", "*", ""):
            with self.assertRaisesRegex(CourseError, "there are 01_bezier_curves, 02_intersections, 10_sampling"):
                choose_chapters([word], self.root)


class Tables(TemporaryTree):
    def differences(self, old, new, **stated):
        one, other = self.write("old/a.csv", old), self.write("new/a.csv", new)
        return compare_tables(one, other, Tolerances(files={"a.csv": stated}))

    def test_times_may_differ_and_errors_may_not(self):
        old = "method,setting,time,time_unit,error,error_unit\nchords,n=2,3.5,ns,0.25,1\n"
        self.assertEqual(self.differences(old, old.replace("3.5", "9.9")), [])
        self.assertEqual(self.differences(old, old.replace("0.25", "0.26")),
                         ["a.csv: chords, n=2: error is 0.25, now 0.26"])

    def test_tolerances_are_relative_and_stated_by_column(self):
        old = "method,case,value\nchords,cusp,1000\n"
        self.assertEqual(self.differences(old, old.replace("1000", "1000.0005")), [])
        self.assertEqual(len(self.differences(old, old.replace("1000", "1002"))), 1)
        self.assertEqual(self.differences(old, old.replace("1000", "1002"), columns={"value": {"relative": 0.01}}), [])
        self.assertEqual(self.differences(old, old.replace("1000", "1002"), absolute=3), [])
        self.assertEqual(self.differences(old, old.replace("1000", "7"), ignore=["value"]), [])

    def test_not_a_number_equals_itself_only(self):
        old = "method,case,value\nchords,cusp,nan\n"
        self.assertEqual(self.differences(old, old), [])
        self.assertEqual(len(self.differences(old, old.replace("nan", "1"))), 1)

    def test_rows_are_matched_by_name(self):
        old = "method,case,value\na,x,1\nb,x,2\n"
        self.assertEqual(self.differences(old, "method,case,value\nb,x,2\na,x,1\n"), [])
        self.assertEqual(self.differences(old, "method,case,value\na,x,1\na,y,2\n"), ["a.csv: no row a, y"])
        self.assertEqual(self.differences(old, "method,case,value\na,x,1\na,y,2\n", rows="common"), [])
        self.assertTrue(self.differences(old, "method,case,value\nc,x,1\n", rows="common"),
                        "Is a comparison of no rows a success?")

    def test_rows_that_show_times_are_left_out(self):
        old = "method,case,value\na,speed-up,3\na,slope,2\n"
        new = "method,case,value\na,speed-up,4\na,slope,5\n"
        self.assertEqual(self.differences(old, new, timed=["^a, speed-up$"]), ["a.csv: a, slope: value is 2, now 5"])

    def test_tables_without_names_are_compared_in_order(self):
        self.assertEqual(self.differences("x,y\n1,2\n3,4\n", "x,y\n1,2\n3,5\n"), ["a.csv: row 2: y is 4, now 5"])
        self.assertEqual(self.differences("x,y\n1,2\n3,4\n", "x,y\n1,2\n"), ["a.csv: 2 rows, now 1"])

    def test_other_columns_are_a_difference(self):
        self.assertEqual(len(self.differences("x,y\n1,2\n", "x,z\n1,2\n")), 1)

    def test_failures_are_compared_as_rates(self):
        old = "method,case,failures,trials\nsearch,two humps,300,1000\n"
        self.assertEqual(self.differences(old, old.replace("300,1000", "33,100")), [])
        self.assertEqual(len(self.differences(old, old.replace("300,1000", "0,1000"))), 1)

    # A thousand pairs of runs at one true rate each: six standard deviations are passed by chance less than once in 10^8.
    def test_the_band_of_rates_raises_no_false_alarm_and_finds_a_real_change(self):
        numbers = random.Random(1)
        for rate in (0, 0.001, 0.3, 0.999, 1):
            for _ in range(200):
                draft = sum(numbers.random() < rate for _ in range(100))
                report = sum(numbers.random() < rate for _ in range(1000))
                self.assertTrue(same_rate(draft, 100, report, 1000))
        self.assertFalse(same_rate(0, 1000, 100, 1000))
        self.assertFalse(same_rate(1000, 1000, 900, 1000))

    def test_tolerances_come_from_the_chapter(self):
        self.write(f"chapters/{CHAPTER}/check.json", '{"relative": 0.5, "files": {"a.csv": {"columns": {"y": {"relative": 0}}}}}')
        tolerances = Tolerances.of(CHAPTER, self.root)
        self.assertEqual(tolerances.of_column("a.csv", "x"), (0.5, 0.0))
        self.assertEqual(tolerances.of_column("a.csv", "y"), (0, 0.0))
        self.assertEqual(Tolerances.of("99_none", self.root).of_column("a.csv", "x"), (1e-6, 0.0))


def encoded(rows, colour, step, filters, palette=None):
    """A PNG file with the row filters given in turn, by the formulas of the specification."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    packed, above = b"", bytes(len(rows[0]))
    for y, row in enumerate(rows):
        kind = filters[y % len(filters)]
        left = bytes(step) + row[:-step]
        corner = bytes(step) + above[:-step]
        guess = {0: bytes(len(row)), 1: left, 2: above, 3: bytes((a + b) // 2 for a, b in zip(left, above)),
                 4: bytes(png.paeth(a, b, c) for a, b, c in zip(left, above, corner))}[kind]
        packed += bytes([kind]) + bytes((value - g) & 255 for value, g in zip(row, guess))
        above = row
    header = struct.pack(">IIBBBBB", len(rows[0]) // step, len(rows), 8, colour, 0, 0, 0)
    middle = chunk(b"PLTE", palette) if palette else b""
    return png.SIGNATURE + chunk(b"IHDR", header) + middle + chunk(b"IDAT", zlib.compress(packed)) + chunk(b"IEND", b"")


def noise(width, height, seed):
    numbers = random.Random(seed)
    return [bytes(numbers.randrange(256) for _ in range(width)) for _ in range(height)]


class Pictures(TemporaryTree):
    def test_every_row_filter_and_colour_type_is_read(self):
        for colour, step in ((0, 1), (2, 3), (4, 2), (6, 4)):
            rows = noise(7 * step, 11, seed=colour)
            path = self.write("a.png", encoded(rows, colour, step, filters=(0, 1, 2, 3, 4)))
            picture = png.read_png(path)
            self.assertEqual((picture.width, picture.height, picture.channels), (7, 11, step))
            self.assertEqual(picture.rows, rows)

    def test_a_palette_is_looked_up(self):
        path = self.write("a.png", encoded([bytes([1, 0])], 3, 1, (0,), palette=bytes([9, 8, 7, 6, 5, 4])))
        self.assertEqual(png.read_png(path).rows, [bytes([6, 5, 4, 9, 8, 7])])

    def test_damage_is_named(self):
        whole = encoded(noise(9, 3, 1), 2, 3, (0,))
        for broken in (b"GIF", whole[:-20], whole[:60] + b"x" + whole[61:]):
            with self.assertRaisesRegex(CourseError, "draw it again"):
                png.read_png(self.write("a.png", broken))

    def compared(self, one, other):
        paths = [self.write(f"{name}/a.png", encoded(rows, 2, 3, (1,))) for name, rows in (("old", one), ("new", other))]
        return compare_pictures(*paths, Tolerances())

    def test_noise_that_averages_out_passes_and_a_changed_block_is_named(self):
        grey = [bytes([100] * 60)] * 40
        flicker = [bytes(100 + (-1) ** (x // 3 + y) for x in range(60)) for y in range(40)]
        self.assertEqual(self.compared(grey, flicker), [])
        patched = [bytes(row[:51] + bytes([160] * 9)) if 32 <= y < 36 else row for y, row in enumerate(grey)]
        self.assertRegex(self.compared(grey, patched)[0], r"a\.png: the block at 16,32 differs by \d+")

    def test_another_size_is_a_difference(self):
        self.assertRegex(self.compared(noise(60, 40, 1), noise(60, 41, 1))[0], "20x40 pixels .* now 20x41")


if __name__ == "__main__":
    unittest.main()
