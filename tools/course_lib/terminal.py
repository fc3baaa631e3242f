"""What the user sees: a bar with the time left on a terminal, plain lines elsewhere."""

import re
import sys
import time

# What could move the cursor, colour, or turn a line around: control characters but tab and newline, and marks of direction.
UNPRINTABLE = re.compile("[\0-\b\v-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")
BAR_WIDTH = 24
TITLE_WIDTH = 44
PLAIN_PAUSE = 20  # seconds between two lines when there is no terminal


def format_duration(seconds):
    """Seconds as a person says them: "0.8 s", "42 s", "3 min 05 s", "2 h 10 min"."""
    if seconds < 9.95:
        return f"{seconds:.1f} s"
    whole = int(seconds + 0.5)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02} min"


def say(text=""):
    print(text, flush=True)


def printable(text):
    """Somebody else's text without any power over a terminal: such characters are spelt out."""
    return UNPRINTABLE.sub(lambda found: found[0].encode("unicode_escape").decode(), text.replace("\r\n", "\n"))


def count(number, thing):
    """"1 test", "3 tests"."""
    return f"{number} {thing}" + ("" if number == 1 else "s")


def table(rows, head=None, right=()):
    """Rows of text in columns; `right` names the columns (by index) that are aligned to the right."""
    lines = ([head] if head else []) + [[str(cell) for cell in row] for row in rows]
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))] if lines else []
    if head:
        lines.insert(1, ["-" * width for width in widths])

    def aligned(line):
        cells = [cell.rjust(width) if column in right else cell.ljust(width)
                 for column, (cell, width) in enumerate(zip(line, widths))]
        return "  ".join(cells).rstrip()

    return "\n".join(aligned(line) for line in lines)


class Step:
    """One step of work, shown while it goes on and with its time when it ends. Use it in a `with`."""

    def __init__(self, title, stream=None):
        self.title = title
        self.note = ""
        self._stream = stream or sys.stdout
        self._terminal = self._stream.isatty()
        self._start = time.monotonic()
        self._shown = self._start

    @property
    def seconds(self):
        return time.monotonic() - self._start

    def __enter__(self):
        if self._terminal:
            self._write(f"\r\x1b[K  {self.title} ...")
        return self

    def __exit__(self, kind, value, trace):
        outcome = "failed" if kind else self.note
        line = f"  {self.title:<{TITLE_WIDTH}} {format_duration(self.seconds):>12}  {outcome}".rstrip() + "\n"
        self._write("\r\x1b[K" + line if self._terminal else line)

    def progress(self, done, total):
        """Shows that `done` of `total` parts are ready."""
        now = time.monotonic()
        if now - self._shown < (0.1 if self._terminal else PLAIN_PAUSE) or not total:
            return
        self._shown = now
        share = min(1, done / total)
        left = format_duration((now - self._start) * (1 - share) / share) + " left" if share > 0 else ""
        if self._terminal:
            filled = int(share * BAR_WIDTH)
            bar = "#" * filled + "." * (BAR_WIDTH - filled)
            self._write(f"\r\x1b[K  {self.title} [{bar}] {100 * share:3.0f} %  {left}")
        else:
            self._write(f"  {self.title}: {done} of {total}, {left}\n")

    def _write(self, text):
        self._stream.write(text)
        self._stream.flush()
