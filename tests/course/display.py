"""A screen for tests of programs with windows: Xvfb, and the mouse and keyboard of xdotool."""

import contextlib
import os
import subprocess
import time

PATIENCE = 60  # seconds that a window may take to appear on a busy machine


class Display:
    """A virtual screen; `name` is what DISPLAY must be for a program to open its windows there."""

    def __init__(self, name):
        self.name = name

    def xdotool(self, *words):
        """Runs xdotool on this screen and returns what it prints."""
        command = ["xdotool", *map(str, words)]
        environment = {**os.environ, "DISPLAY": self.name}
        return subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def wait_for_window(self, title):
        """The id of the visible window whose title contains `title`, as soon as it is there."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            with contextlib.suppress(subprocess.CalledProcessError):
                return self.xdotool("search", "--onlyvisible", "--name", title).splitlines()[0]
            time.sleep(0.1)
        raise AssertionError(f"no window titled '{title}' within {PATIENCE} s")

    def press(self, window, key):
        """Presses a key while a window has the focus (there is no window manager to give it)."""
        self.xdotool("windowfocus", "--sync", window)
        self.xdotool("key", key)

    def screenshot(self, path):
        """Saves the whole screen as a picture (imagemagick's import)."""
        subprocess.run(["import", "-display", self.name, "-window", "root", str(path)], check=True)


@contextlib.contextmanager
def virtual_display(width=1600, height=1200):
    """An Xvfb screen on a free number, ended with the block."""
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
                              pass_fds=[writing], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise AssertionError("Xvfb did not start")
        yield Display(f":{number}")
    finally:
        server.terminate()
        server.wait()
