"""Drives headless Chromium through its DevTools protocol, over a pair of pipes (no network, no package but Chromium)."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from course_lib.errors import CourseError

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage",
         "--proxy-server=127.0.0.1:9", "--remote-debugging-pipe")
# The numbers of the file descriptors are Chromium's.
READS_FROM, WRITES_TO = 3, 4


def installed():
    """The path of a Chromium; None when there is none."""
    return next((path for path in map(shutil.which, PROGRAMS) if path), None)


class Browser:
    """One Chromium with one page. Use it in a `with`.

    `messages` collects what pages complain of: errors on the console, exceptions, files that could not be loaded.
    """

    def __init__(self, size=(1400, 1000), timeout=30):
        program = installed()
        if program is None:
            raise CourseError("there is no Chromium; ./course setup --group test installs it")
        self.messages = []
        self._timeout = timeout
        self._answers = {}
        self._events = []
        self._buffer = b""
        self._last = 0
        self._session = None
        self._profile = tempfile.mkdtemp(prefix="caustic-browser-")
        self._process = self._start([program, *FLAGS, f"--user-data-dir={self._profile}",
                                     f"--window-size={size[0]},{size[1]}", "about:blank"])
        self._attach()

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        try:
            self._send("Browser.close", {}, session=False)
            self._process.wait(timeout=10)
        except (OSError, subprocess.TimeoutExpired):
            self._process.kill()
            self._process.wait()
        os.close(self._to_browser)
        os.close(self._from_browser)
        shutil.rmtree(self._profile, ignore_errors=True)

    def open(self, path, condition="true"):
        """Opens a file (or a URL) and waits until it is loaded and the JavaScript expression `condition` holds."""
        url = path.resolve().as_uri() if isinstance(path, Path) else path
        self._events.clear()
        self.call("Page.navigate", {"url": url})
        self._wait_for("Page.loadEventFired", url)
        self.wait_until(condition, url)

    def wait_until(self, condition, what="", frame=None):
        """Waits until a JavaScript expression is true in the page, or in the frame of that name; returns its value."""
        end = time.monotonic() + self._timeout
        while True:
            value = self._evaluate_now(condition, frame)
            if value:
                return value
            if time.monotonic() > end:
                raise CourseError(f"in the browser, {condition} did not come true within {self._timeout} s {what}".strip())
            time.sleep(0.02)

    def _evaluate_now(self, condition, frame):
        """The condition's value; None while the frame loads, which takes its context away between two calls."""
        try:
            return self.evaluate(condition, self.frame(frame) if frame else None)
        except CourseError as error:
            if frame and "context with specified id" in str(error):
                return None
            raise

    def evaluate(self, expression, context=None):
        """The value of a JavaScript expression in the page, or in another context of it (see frame)."""
        parameters = {"expression": expression, "returnByValue": True, "awaitPromise": True}
        answer = self.call("Runtime.evaluate", {**parameters, "contextId": context} if context else parameters)
        if "exceptionDetails" in answer:
            raise CourseError(f"in the browser, {expression} failed: {described(answer['exceptionDetails'])}")
        return answer["result"].get("value")

    def frame(self, name):
        """A context to evaluate expressions in: that of an inner frame, by its name."""
        children = self.call("Page.getFrameTree")["frameTree"].get("childFrames", [])
        frame = next((child["frame"]["id"] for child in children if child["frame"].get("name") == name), None)
        if frame is None:
            raise CourseError(f"the page has no frame {name}")
        return self.call("Page.createIsolatedWorld", {"frameId": frame})["executionContextId"]

    def type(self, text):
        """Presses the keys of a text, as a user would."""
        for letter in text:
            self.call("Input.dispatchKeyEvent", {"type": "keyDown", "text": letter, "key": letter})
            self.call("Input.dispatchKeyEvent", {"type": "keyUp", "key": letter})

    def press(self, key, code):
        """Presses a key that writes nothing, such as ArrowLeft, by its name and its Windows code."""
        for kind in ("rawKeyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", {"type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code})

    def resize(self, width=None, height=None):
        """Shows the page as in a window of this size, a phone's for example; without one, as in the window that it is in."""
        if width is None:
            self.call("Emulation.clearDeviceMetricsOverride")
        else:
            self.call("Emulation.setDeviceMetricsOverride",
                      {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def screenshot(self, path):
        """Saves what the window shows as PNG."""
        answer = self.call("Page.captureScreenshot", {"format": "png"})
        Path(path).write_bytes(base64.b64decode(answer["data"]))

    def pdf(self, path):
        """Prints the page as PDF, with numbered pages, in the size that its style sheet asks for."""
        footer = '<div style="font-size: 8px; width: 100%; text-align: center"><span class="pageNumber"></span></div>'
        answer = self.call("Page.printToPDF", {"printBackground": True, "preferCSSPageSize": True, "displayHeaderFooter": True,
                                               "headerTemplate": "<span></span>", "footerTemplate": footer,
                                               "generateDocumentOutline": True})
        Path(path).write_bytes(base64.b64decode(answer["data"]))

    def call(self, method, parameters=None):
        """Calls a method of the protocol on the page and returns its answer."""
        number = self._send(method, parameters or {})
        end = time.monotonic() + self._timeout
        while number not in self._answers:
            self._receive(end, method)
        answer = self._answers.pop(number)
        if "error" in answer:
            raise CourseError(f"Chromium refuses {method}: {answer['error']['message']}")
        return answer["result"]

    # The protocol: JSON messages, each ended by a zero byte

    def _start(self, command):
        browser_reads, self._to_browser = os.pipe()
        self._from_browser, browser_writes = os.pipe()
        # A shell moves the pipes to the numbers that Chromium asks for.
        moved = f'exec "$@" {READS_FROM}<&{browser_reads} {WRITES_TO}>&{browser_writes}'
        process = subprocess.Popen(["bash", "-c", moved, "browser", *command], pass_fds=(browser_reads, browser_writes),
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(browser_reads)
        os.close(browser_writes)
        return process

    def _attach(self):
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self._session = self.call("Target.attachToTarget", {"targetId": page, "flatten": True})["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def _send(self, method, parameters, session=True):
        self._last += 1
        message = {"id": self._last, "method": method, "params": parameters}
        if session and self._session:
            message["sessionId"] = self._session
        os.write(self._to_browser, json.dumps(message).encode() + b"\0")
        return self._last

    def _receive(self, end, what):
        """Waits for the next messages and sorts them."""
        left = end - time.monotonic()
        if left <= 0 or not select.select([self._from_browser], [], [], left)[0]:
            raise CourseError(f"Chromium did not answer {what} within {self._timeout} s")
        chunk = os.read(self._from_browser, 1 << 20)
        if not chunk:
            raise CourseError(f"Chromium ended while it was asked for {what}")
        *complete, self._buffer = (self._buffer + chunk).split(b"\0")
        for text in complete:
            self._sort(json.loads(text))

    def _sort(self, message):
        if "id" in message:
            self._answers[message["id"]] = message
            return
        self._events.append(message["method"])
        complaint = complaint_of(message["method"], message.get("params", {}))
        if complaint:
            self.messages.append(complaint)

    def _wait_for(self, event, what):
        end = time.monotonic() + self._timeout
        while event not in self._events:
            self._receive(end, f"{event} of {what}")


def complaint_of(method, parameters):
    if method == "Runtime.exceptionThrown":
        return described(parameters["exceptionDetails"])
    if method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "assert", "warning"):
        return " ".join(str(argument.get("value", argument.get("description"))) for argument in parameters["args"])
    if method == "Log.entryAdded" and parameters["entry"]["level"] == "error":
        return f"{parameters['entry']['text']} {parameters['entry'].get('url', '')}".strip()
    if method == "Network.loadingFailed" and not parameters.get("canceled"):
        return f"loading failed: {parameters['errorText']}"
    return None


def described(details):
    return details.get("exception", {}).get("description", details["text"])
