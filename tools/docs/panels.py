"""The panels of a figure: the pictures that stand side by side on its white ground. Each can be had as a PNG of its own."""

import re
import struct
import zlib
from collections import Counter

from course_lib.png import SIGNATURE, read_png

LEAST = 100  # pixels of a panel's side; letters are smaller
EVERY = 4  # of so many rows one is looked at for where panels begin and end
FEW = 0.2  # of the rows that the most frequent panels have; what spans fewer is no panel but a part of one
WHITE = 255


class Sheet:
    """A figure and where its panels are."""

    def __init__(self, path):
        self._picture = read_png(path)
        self._darkest = [darkest(row, self._picture.channels) for row in self._picture.rows]

    def panels(self):
        """(left, top, right, bottom) of each panel, without right and bottom themselves; from the left in each row, rows downwards."""
        runs = Counter(run.span() for row in self._darkest[::EVERY] for run in re.finditer(rb"[^\xff]{%d,}" % LEAST, row))
        most = max(runs.values(), default=0)
        spans = [span for span, count in runs.items() if count >= FEW * most]
        found = [(left, top, right, bottom) for left, right in spans for top, bottom in self._heights(left, right)]
        outer = [panel for panel in found if not any(encloses(other, panel) for other in found if other != panel)]
        return sorted(outer, key=lambda panel: (panel[1], panel[0]))

    def _heights(self, left, right):
        """From which row to which both borders of a span are there."""
        start = None
        for y, row in enumerate([*self._darkest, bytes([WHITE]) * self._picture.width]):
            inside = row[left] < WHITE and row[right - 1] < WHITE
            if inside and start is None:
                start = y
            elif not inside and start is not None:
                if y - start >= LEAST:
                    yield start, y
                start = None

    def save_panel(self, number, path):
        """Writes panel `number`, counted from 1, as a PNG; false when there is no such panel."""
        panels = self.panels()
        if not 1 <= number <= len(panels):
            return False
        left, top, right, bottom = panels[number - 1]
        step = self._picture.channels
        rows = [row[left * step:right * step] for row in self._picture.rows[top:bottom]]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(png(rows, right - left, step))
        return True


def darkest(row, channels):
    """The smallest channel of each pixel of a row."""
    return row if channels == 1 else bytes(map(min, *(row[channel::channels] for channel in range(channels))))


def encloses(outer, inner):
    return outer[0] <= inner[0] and outer[1] <= inner[1] and outer[2] >= inner[2] and outer[3] >= inner[3]


def png(rows, width, channels):
    """A PNG file of rows of bytes, each as its difference from the row above."""
    above, packed = bytes(width * channels), []
    for row in rows:
        packed.append(b"\x02" + bytes((value - up) & 255 for value, up in zip(row, above)))
        above = row
    header = struct.pack(">IIBBBBB", width, len(rows), 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(packed), 6)) + chunk(b"IEND", b"")


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
