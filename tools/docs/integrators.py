"""The page that charts all integrators together: error over time on the scenes that chapters measure, from their own CSV files."""

import csv
import html
import math
import subprocess
from dataclasses import dataclass
from pathlib import Path

from course_lib.errors import CourseError
from docs.markdown import RAW_HTML

CHARTS_FOLDER = "charts"
SCRIPT = "docs/charts/integrators.gp"
STYLE = "common/figure/style.gp"


@dataclass(frozen=True)
class Measured:
    """A scene that chapters measured: its name on the page and which rows of which chapters are its."""

    name: str
    title: str
    sources: tuple  # of (chapter's number, "scene=…" that a row's setting has; empty: all rows)


SCENES = (Measured("diffuse_box", "A diffuse box", (("07", "scene=diffuse_box"),)),
          Measured("mirror_box", "A box with a small lamp and a mirror", (("07", "scene=mirror_box"),)),
          Measured("peers_box", "The peers' box: a mirror ball and a glass ball", (("07", "scene=peers_box"),)),
          Measured("caustic", "The caustic of a glass ball", (("07", "scene=caustic"), ("08", ""))),
          Measured("mirror_caustic", "The same caustic, seen in a mirror", (("09", ""),)))


class Integrators:
    """Reads the chapters' speed_accuracy.csv and makes the page's parts and pictures of them."""

    def __init__(self, root):
        self._root = root

    def page(self):
        """A section for each scene: its chart, and each method's error after one and the same time."""
        sections = [section(scene, lines) for scene, lines in self._scenes()]
        return "\n".join(sections) or "Nothing is measured yet."

    def draw(self, html_folder):
        """Draws the charts into the site."""
        (html_folder / CHARTS_FOLDER).mkdir(exist_ok=True)
        for scene, lines in self._scenes():
            picture = html_folder / CHARTS_FOLDER / f"{scene.name}.png"
            chart(self._root, picture, scene.title, lines)

    def _scenes(self):
        """(scene, {method: points}) of all scenes that are measured in this tree."""
        found = [(scene, self._lines(scene)) for scene in SCENES]
        return [(scene, lines) for scene, lines in found if lines]

    def _lines(self, scene):
        """Method -> [(seconds, error)], from the first chapter that measured the method in this scene."""
        lines = {}
        for number, setting in scene.sources:
            measured = {}
            for row in self._rows(number):
                if setting in ("", *row["setting"].split(";")):
                    measured.setdefault(row["method"], []).append((float(row["time"]), float(row["error"])))
            lines.update(without(measured, lines))
        return {method: sorted(points) for method, points in lines.items()}

    def _rows(self, number):
        path = next((self._root / "figures").glob(f"{number}_*/speed_accuracy.csv"), None)
        if path is None:
            return []
        with path.open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))


def without(measured, known):
    return {method: points for method, points in measured.items() if method not in known}


def section(scene, lines):
    url = f"{CHARTS_FOLDER}/{scene.name}.png"
    alt = f"{scene.title}: error over seconds of {', '.join(lines)}"
    picture = (f'<p><a class="figure" href="{url}"><img src="{url}" alt="{html.escape(alt)}" loading="lazy"></a></p>')
    seconds = common_time(lines)
    ranked = sorted((error_at(points, seconds), method) for method, points in lines.items())
    rows = "".join(f"| {method} | {error:.3g} |\n" for error, method in ranked)
    return (f"\n## {scene.title} {{#integrators-{scene.name}}}\n\n{RAW_HTML.format(picture)}\n\n"
            f"| method | error after {seconds:.2g} s |\n| :-- | --: |\n{rows}")


def common_time(lines):
    """The latest time that the measurements of every method reach."""
    return min(points[-1][0] for points in lines.values())


def error_at(points, seconds):
    """The error at a time between two measured points, on the straight line between them in a log-log chart."""
    after = next(index for index, point in enumerate(points) if point[0] >= seconds)
    if after == 0:
        return points[0][1]
    (t0, e0), (t1, e1) = points[after - 1], points[after]
    share = math.log(seconds / t0) / math.log(t1 / t0)
    return math.exp(math.log(e0) + share * math.log(e1 / e0))


def chart(root, picture, title, lines):
    """Draws one scene's chart with gnuplot, in the style of all charts of the course."""
    rows = "".join(f"{method},{time!r},{error!r}\n" for method, points in lines.items() for time, error in points)
    names = ", ".join(f'"{method}"' for method in lines)
    commands = "\n".join([f'output = "{picture}"', f'load "{root / STYLE}"', f"$points << END\nmethod,time,error\n{rows}END",
                          f"methods = {len(lines)}", f"array names[{len(lines)}] = [{names}]", f'scene = "{title}"',
                          f'load "{root / SCRIPT}"', ""])
    try:
        finished = subprocess.run(["gnuplot"], input=commands, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  cwd=Path(root))
    except FileNotFoundError:
        raise CourseError("there is no program 'gnuplot'; ./course setup installs it") from None
    if finished.returncode != 0 or not picture.exists():
        last = (finished.stdout.strip().splitlines() or ["it says nothing"])[-1]
        raise CourseError(f"gnuplot cannot draw {picture.name}: {last}")
