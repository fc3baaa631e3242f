"""Drives the editor's window as a user does: by mouse and keys of the X server, nothing else.

What the window shows is known by two ways: the report that the editor writes after each change, and pictures of the
screen. Nothing waits for a fixed time; whatever is waited for is polled, with a limit that a loaded machine needs.
"""

import ctypes
import json
import os
import subprocess
import time

PATIENCE = 90  # seconds; a laden machine takes its time
POLL = 0.03


class Gone(AssertionError):
    """The editor ended while something was waited for."""


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, timeout=PATIENCE, **options)


def asked(*command):
    """What a program answers; nothing when it fails, or hangs, as xdotool may while windows come and go."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False, timeout=10).stdout
    except subprocess.TimeoutExpired:
        return ""


def wait_for(what, condition, patience=PATIENCE):
    """Polls until the condition returns something true, and returns that."""
    end = time.monotonic() + patience
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise AssertionError(f"waited {patience} s in vain for {what}")
        time.sleep(POLL)


class Picture:
    """What the screen shows of the window, as 8-bit RGB."""

    def __init__(self, width, height, data):
        self.width, self.height, self.data = width, height, data

    def pixel(self, x, y):
        start = 3 * (int(y) * self.width + int(x))
        return tuple(self.data[start:start + 3])


class EditorWindow:
    """A running editor. As a context it ends with the block, however that is left."""

    def __init__(self, program, folder, *arguments):
        self.report_path = folder / "report.json"
        self.report_path.unlink(missing_ok=True)
        runtime = folder / "runtime"
        runtime.mkdir(mode=0o700, exist_ok=True)
        environment = {**os.environ, "XDG_RUNTIME_DIR": str(runtime)}
        command = [str(program), *map(str, arguments), "--report", str(self.report_path)]
        self.complaints = folder / "stderr.log"  # a file: nobody has to read it for the editor to go on
        with self.complaints.open("w") as complaints:
            self.process = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stderr=complaints)
        self.window = None

    def __enter__(self):
        self.wait("its first picture", lambda report: True)
        self.find_window()
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait(timeout=PATIENCE)

    def find_window(self):
        """Finds the window (a new one, perhaps) and gives it the keyboard: this screen has no window manager to do so."""
        def newest():
            found = asked("xdotool", "search", "--onlyvisible", "--name", "^Bezier editor$").split()
            fresh = [window for window in found if window != self.window]
            return fresh[-1] if fresh else None

        def focused():
            asked("xdotool", "windowfocus", self.window)
            return asked("xdotool", "getwindowfocus").strip() == self.window
        self.window = wait_for("the window", newest)
        wait_for("the keyboard", focused)

    # What it shows

    def report(self):
        """The editor's own account of what it shows; nothing before it was ever written."""
        try:
            return json.loads(self.report_path.read_text())
        except FileNotFoundError:
            return None

    def wait(self, what, condition, patience=PATIENCE):
        """Waits until a report fulfils the condition, and returns it."""
        def check():
            if self.process.poll() is not None:
                raise Gone(f"the editor ended with {self.process.returncode} instead of {what}: "
                           f"{self.complaints.read_text()}")
            report = self.report()
            return report if report and condition(report) else None
        return wait_for(what, check, patience)

    def wait_status(self, words):
        return self.wait(f"the status '{words}'", lambda report: words in report["status"])

    def wait_end(self):
        """Waits until the editor ends by itself; returns its exit code."""
        return self.process.wait(timeout=PATIENCE)

    def picture(self):
        size = dict(line.split("=") for line in
                    run("xdotool", "getwindowgeometry", "--shell", self.window).stdout.decode().split())
        data = run("import", "-window", self.window, "-depth", "8", "rgb:-").stdout
        return Picture(int(size["WIDTH"]), int(size["HEIGHT"]), data)

    # What a user does

    def move(self, place):
        """Moves the mouse to a pixel of the window."""
        run("xdotool", "mousemove", "--window", self.window, int(place[0]), int(place[1]))

    def press(self, button=1):
        run("xdotool", "mousedown", button)

    def release(self, button=1):
        run("xdotool", "mouseup", button)

    def click(self, place, button=1):
        self.move(place)
        run("xdotool", "click", button)

    def double_click(self, place, what, condition):
        """Double-clicks until the condition holds: on a laden machine two clicks may come too late for a double one."""
        self.move(place)
        for _ in range(5):
            run("xdotool", "click", "--repeat", "2", "--delay", "30", "1")
            try:
                return self.wait(what, condition, patience=PATIENCE / 5)
            except Gone:
                raise
            except AssertionError:
                continue
        raise AssertionError(f"double-clicked in vain for {what}")

    def drag(self, start, end, modifier=None):
        """Presses at one place, moves in steps, and releases at another; returns once the point is there."""
        self.move(start)
        if modifier:
            run("xdotool", "keydown", modifier)
        self.press()
        grabbed = self.wait("a point grabbed", lambda report: any(point["selected"] for point in report["points"]))
        index = next(i for i, point in enumerate(grabbed["points"]) if point["selected"])
        for share in (0.3, 0.7, 1.0):
            self.move([a + share * (b - a) for a, b in zip(start, end)])
        shift = [b - a for a, b in zip(map(int, start), map(int, end))]
        goal = [a + b for a, b in zip(grabbed["points"][index]["pixel"], shift)]
        self.wait("the point at its new place", lambda report: near(report["points"][index]["pixel"], goal, 0.6))
        self.release()
        if modifier:
            run("xdotool", "keyup", modifier)
        return index

    def key(self, name):
        run("xdotool", "key", name)

    def close(self):
        """Asks the window to close, as the button in its frame does (WM_DELETE_WINDOW)."""
        send_delete_window(int(self.window))


def near(a, b, distance):
    return all(abs(x - y) <= distance for x, y in zip(a, b))


class ClientMessage(ctypes.Structure):
    """Xlib's XClientMessageEvent, padded to the size of XEvent."""

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("padding", ctypes.c_long * 24)]


def send_delete_window(window):
    """What a window manager sends; xdotool of Debian 12 can't."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong
    x11.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
    x11.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = x11.XOpenDisplay(None)
    if not display:
        raise AssertionError("there is no screen")
    event = ClientMessage(type=33, window=window, format=32, message_type=x11.XInternAtom(display, b"WM_PROTOCOLS", 0))
    event.data[0] = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
    x11.XSendEvent(display, window, 0, 0, ctypes.byref(event))
    x11.XCloseDisplay(display)
