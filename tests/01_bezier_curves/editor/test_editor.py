"""The editor under Xvfb: opened, points dragged, added and deleted, undone, saved; and what it says to bad input.

    xvfb-run -a -s '-screen 0 1280x800x24' python3 test_editor.py PROGRAM [--screenshot PNG]

With --screenshot it makes the picture for the documentation instead.
"""

import argparse
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from screen import PATIENCE, EditorWindow, near, run, wait_for

HERE = Path(__file__).resolve().parent
PROFILES = HERE.parents[2] / "assets" / "profiles"
PROGRAM = None  # set by main

# Two smooth segments and a corner, as in property_editor.cpp.
WAVE = [(0, 0), (1, 2), (2, 2), (3, 0), (4, -2), (5, -1), (6, 0), (6, 1), (8, 1), (9, 0)]

WHITE = (255, 255, 255)
CHOSEN = (0xe6, 0x9f, 0x00)


def write_profile(path, points):
    path.write_text("".join(f"{x} {y}\n" for x, y in points))
    return path


def read_profile(path):
    """The control points of a profile, by a reader that shares nothing with the editor's."""
    lines = [line.split("#")[0].split() for line in path.read_text().splitlines()]
    return [tuple(map(float, words)) for words in lines if words and words != ["closed"]]


def world_points(report):
    return [tuple(point["world"]) for point in report["points"]]


def index_of(report, node, kind):
    return next(i for i, point in enumerate(report["points"]) if point["node"] == node and point["kind"] == kind)


def pixel_of(report, node, kind="anchor"):
    return report["points"][index_of(report, node, kind)]["pixel"]


def bezier(points, t):
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


class EditorTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def wave(self):
        return write_profile(self.folder / "wave.txt", WAVE)

    def editor(self, *arguments):
        return EditorWindow(PROGRAM, self.folder, *arguments)

    def assert_shown(self, editor, points, report):
        """Each control point of `points` is painted where it belongs, at the place that the view's scale predicts."""
        (x0, y0), (x1, y1) = report["points"][0]["world"], report["points"][-1]["world"]
        (u0, v0), (u1, v1) = report["points"][0]["pixel"], report["points"][-1]["pixel"]
        scale = ((u1 - u0) ** 2 + (v1 - v0) ** 2) ** 0.5 / ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
        places = [(u0 + scale * (x - x0), v0 - scale * (y - y0)) for x, y in points]

        def wrong():
            picture = editor.picture()
            return [place for place in places if picture.pixel(*place) not in (WHITE, CHOSEN)
                    or picture.pixel(place[0] + 4.5, place[1]) == picture.pixel(place[0] + 14, place[1])]
        wait_for("every point where the file says", lambda: not wrong())


class Work(EditorTest):
    def test_points_are_dragged_added_deleted_undone_and_saved(self):
        path = self.wave()
        with self.editor(path) as editor:
            report = editor.wait("the wave", lambda r: r["segments"] == 3)
            self.assertEqual(world_points(report), [tuple(map(float, p)) for p in WAVE])
            self.assert_shown(editor, WAVE, report)

            start = pixel_of(report, 1)
            editor.drag(start, (start[0] + 60, start[1] - 80))
            dragged = editor.wait("the drag's end", lambda r: r["changed"])
            self.assertTrue(near(pixel_of(dragged, 1), (start[0] + 60, start[1] - 80), 0.6))
            self.assert_shown(editor, world_points(dragged), dragged)

            points = [point["pixel"] for point in dragged["points"]]
            on_curve = bezier(points[0:4], 0.45)
            split = editor.double_click(on_curve, "a point added", lambda r: r["segments"] == 4)
            self.assertIn("Split", split["status"])
            self.assertTrue(near(pixel_of(split, 1), on_curve, 9))
            before, after = [p["pixel"] for p in split["points"]][0:4], [p["pixel"] for p in split["points"]][3:7]
            for t in (0.2, 0.5, 0.8):  # the two halves lie on the curve that was there
                whole = [bezier(points[0:4], k / 2000) for k in range(2001)]
                for half in (bezier(before, t), bezier(after, t)):
                    self.assertLess(min(abs(x - half[0]) + abs(y - half[1]) for x, y in whole), 0.5)

            editor.click(pixel_of(split, 2))
            editor.wait("point 2 selected", lambda r: r["points"][index_of(r, 2, "anchor")]["selected"])
            editor.key("d")
            deleted = editor.wait("a point deleted", lambda r: r["segments"] == 3)
            self.assertEqual(len(deleted["points"]), 10)

            editor.key("z")
            undone = editor.wait("the deletion undone", lambda r: r["segments"] == 4)
            self.assertEqual(world_points(undone), world_points(split))
            self.assertEqual(undone["status"], "Undone: delete")

            editor.key("s")
            saved = editor.wait("it saved", lambda r: not r["changed"])
            self.assertIn("Saved as", saved["status"])
            self.assertEqual(read_profile(path), world_points(saved))
            self.assert_shown(editor, read_profile(path), saved)
            editor.key("q")
            self.assertEqual(editor.wait_end(), 0)
        # The saved file read back is what was on the screen.
        with self.editor(path) as editor:
            again = editor.wait("the file opened again", lambda r: r["segments"] == 4)
            self.assertEqual(world_points(again), world_points(saved))

    def test_handles_turn_together_unless_ctrl_is_held(self):
        with self.editor(self.wave()) as editor:
            report = editor.wait("the wave", lambda r: r["segments"] == 3)
            start = pixel_of(report, 1, "in")
            editor.drag(start, (start[0] + 60, start[1] - 20))
            turned = editor.wait("a smooth joint", lambda r: r["changed"])
            anchor, before, after = (pixel_of(turned, 1, kind) for kind in ("anchor", "in", "out"))
            cross = ((before[0] - anchor[0]) * (after[1] - anchor[1]) - (before[1] - anchor[1]) * (after[0] - anchor[0]))
            self.assertAlmostEqual(cross, 0, places=6)
            self.assertFalse(near(pixel_of(report, 1, "out"), after, 5), "the partner did not move")

            start = pixel_of(turned, 1, "in")
            editor.drag(start, (start[0] + 90, start[1]), modifier="ctrl")
            broken = editor.wait("a corner", lambda r: not r["points"][index_of(r, 1, "anchor")]["smooth"])
            self.assertEqual(pixel_of(broken, 1, "out"), after)

    def test_a_new_curve_is_drawn_from_nothing(self):
        with self.editor("new.txt") as editor:
            editor.wait("an empty sheet", lambda r: not r["points"])
            places = [(150, 500), (300, 200), (520, 260), (700, 480)]
            for count, place in enumerate(places):
                editor.key("a")
                editor.wait_status("Click where")
                editor.click(place)
                report = editor.wait("the new point", lambda r, n=count: len({p["node"] for p in r["points"]}) == n + 1)
            for node, place in enumerate(places):
                self.assertTrue(near(pixel_of(report, node), place, 0.6))
            editor.key("l")
            editor.wait("a closed curve", lambda r: r["closed"] and r["segments"] == 4)
            editor.key("s")
            editor.wait("it saved", lambda r: not r["changed"])
            self.assertIn("closed", (self.folder / "new.txt").read_text())
            self.assertEqual(len(read_profile(self.folder / "new.txt")), 13)

    def test_the_slider_and_keys_choose_t(self):
        with self.editor(self.wave()) as editor:
            editor.wait("the wave", lambda r: r["segments"] == 3)
            editor.click((96, 672))
            editor.wait("t = 0", lambda r: r["u"] < 0.01)
            editor.click((790, 672))
            editor.wait("the end", lambda r: r["u"] > 2.99)
            editor.key("bracketleft")
            editor.wait("the last segment's beginning", lambda r: abs(r["u"] - 2) < 1e-9)
            editor.key("period")
            editor.wait("a step on", lambda r: abs(r["u"] - 2.01) < 1e-9)
            editor.key("comma")
            editor.wait("a step back", lambda r: abs(r["u"] - 2) < 1e-9)

    def test_another_profile_is_opened_from_the_list(self):
        write_profile(self.folder / "line.txt", [(0, 0), (1, 1), (2, 2), (3, 3)])
        with self.editor(self.wave()) as editor:
            editor.key("o")
            editor.wait("the list", lambda r: r["choices"] == ["line.txt", "wave.txt"])
            editor.click((200, 125))
            report = editor.wait("the line", lambda r: r["segments"] == 1)
            self.assertTrue(report["file"].endswith("line.txt"))

    def test_an_svg_is_opened_and_saved_as_text(self):
        svg = self.folder / "a.svg"
        svg.write_text('<svg xmlns="http://www.w3.org/2000/svg" height="10"><path d="M1 9 C 2 7 4 8 5 1"/></svg>')
        with self.editor(svg) as editor:
            report = editor.wait("the path", lambda r: r["segments"] == 1)
            self.assertEqual(world_points(report), [(1, 1), (2, 3), (4, 2), (5, 9)])
            editor.key("s")
            editor.wait_status("Saved as")
        self.assertEqual(read_profile(self.folder / "a.txt"), [(1, 1), (2, 3), (4, 2), (5, 9)])


class Manners(EditorTest):
    def changed(self, editor):
        report = editor.wait("the wave", lambda r: r["segments"] == 3)
        start = pixel_of(report, 1)
        editor.drag(start, (start[0], start[1] - 50))
        return editor.wait("a change", lambda r: r["changed"])

    def test_unsaved_changes_are_asked_about(self):
        with self.editor(self.wave()) as editor:
            self.changed(editor)
            editor.key("q")
            self.assertTrue(editor.wait_status("Unsaved changes")["complaining"])
            self.assertIsNone(editor.process.poll())
            editor.key("q")
            self.assertEqual(editor.wait_end(), 0)
        self.assertEqual(read_profile(self.folder / "wave.txt"), [tuple(map(float, p)) for p in WAVE])

    def test_closing_the_window_asks_too(self):
        with self.editor(self.wave()) as editor:
            self.changed(editor)
            editor.close()
            editor.wait_status("Unsaved changes")
            editor.find_window()
            editor.key("s")
            editor.wait("it saved", lambda r: not r["changed"])
            editor.close()
            self.assertEqual(editor.wait_end(), 0)

    def test_a_curve_that_cannot_be_saved_stays(self):
        path = self.wave()
        with self.editor(path) as editor:
            self.changed(editor)
            path.unlink()
            path.mkdir()
            editor.key("s")
            report = editor.wait("a complaint", lambda r: r["complaining"])
            self.assertTrue(report["changed"])
            self.assertIn("wave.txt", report["status"])

    def test_the_wheel_only_magnifies(self):
        with self.editor(self.wave()) as editor:
            report = editor.wait("the wave", lambda r: r["segments"] == 3)
            editor.move((400, 300))
            run("xdotool", "click", "4")
            editor.wait_status("Magnified")
            editor.click(pixel_of(report, 1))
            run("xdotool", "click", "5")
            back = editor.wait("the wheel turned back", lambda r: r["status"] == "")
            self.assertEqual(back["points"], report["points"])
            self.changed(editor)


class BadInput(EditorTest):
    def refused(self, *arguments, **environment):
        finished = subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, check=False,
                                  timeout=PATIENCE, cwd=self.folder,
                                  env=environment.get("env"))
        self.assertEqual(finished.returncode, 2, finished.stderr)
        self.assertEqual(len(finished.stderr.splitlines()), 1, finished.stderr)
        self.assertEqual(finished.stdout, "")
        return finished.stderr

    def test_what_cannot_be_opened_is_said_in_one_line(self):
        (self.folder / "empty.txt").touch()
        (self.folder / "nan.txt").write_text("0 0\n1 nan\n2 0\n3 0\n")
        (self.folder / "deep.txt").write_text("0 0 0\n1 0 5\n2 0 0\n3 0 0\n")
        (self.folder / "none.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
        for name in ("missing.svg", ".", "empty.txt", "none.svg", "folder/new.txt"):
            self.assertIn(name, self.refused(name))
        self.assertIn("nan.txt:2", self.refused("nan.txt"))
        self.assertIn("flat", self.refused("deep.txt"))
        self.assertIn("--help", self.refused("--colour"))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["deep.txt", "empty.txt", "nan.txt", "none.svg"])

    def test_without_a_screen_it_says_so(self):
        self.assertIn("no screen", self.refused(self.wave(), env={"PATH": "/usr/bin"}))

    def test_help_is_there(self):
        finished = subprocess.run([str(PROGRAM), "--help"], capture_output=True, text=True, check=True, timeout=PATIENCE)
        self.assertIn("FILE", finished.stdout)
        self.assertIn("--report", finished.stdout)


def take_screenshot(program, png):
    """The wine glass, turned about its axis, while a handle of the bowl is being dragged."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        profile = folder / "wine_glass.txt"
        profile.write_bytes((PROFILES / "wine_glass.txt").read_bytes())
        with EditorWindow(program, folder, profile) as editor:
            report = editor.wait("the glass", lambda r: r["points"])
            before = pixel_of(report, 0)
            editor.key("m")
            report = editor.wait("the mirror", lambda r: pixel_of(r, 0) != before)
            segments = report["segments"]
            points = [point["pixel"] for point in report["points"]]
            longest = max(range(segments), key=lambda i: abs(points[3 * i][1] - points[3 * i + 3][1])
                          + abs(points[3 * i][0] - points[3 * i + 3][0]))
            editor.click((96 + (790 - 96) * (longest + 0.42) / segments, 672))
            editor.wait("t", lambda r: abs(r["u"] - longest - 0.42) < 0.02)
            editor.click(pixel_of(report, longest))
            editor.wait("a point selected", lambda r: any(point["selected"] for point in r["points"]))
            picture = editor.picture()
            png.parent.mkdir(parents=True, exist_ok=True)
            run("convert", "-size", f"{picture.width}x{picture.height}", "-depth", "8", "rgb:-", "-strip",
                "-define", "png:exclude-chunks=date,time", str(png), input=bytes(picture.data))


def main():
    global PROGRAM
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path, help="bezier_editor")
    parser.add_argument("--screenshot", type=Path, metavar="PNG", help="make the picture for the documentation")
    options, rest = parser.parse_known_args()
    PROGRAM = options.program.resolve()
    if options.screenshot:
        return take_screenshot(PROGRAM, options.screenshot)
    return unittest.main(argv=[sys.argv[0], *rest], verbosity=2)


if __name__ == "__main__":
    main()
