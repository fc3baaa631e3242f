"""--preview shows each picture in a window until a key is pressed, and says so where no window can be opened."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from display import virtual_display

BIN = Path(os.environ["CAUSTIC_BUILD_DIR"]) / "bin"
CHAPTER = BIN / "01_bezier_curves"
FIGURE = "de_casteljau"


def start_preview(out, display):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment.update(display)
    return subprocess.Popen([CHAPTER, "--only", FIGURE, "--preview", "--out", out], env=environment, text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


class Preview(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = folder.name

    def test_a_key_closes_the_window_and_the_chapter_goes_on(self):
        with virtual_display() as display:
            process = start_preview(self.out, {"DISPLAY": display.name})
            window = display.wait_for_window(f"{FIGURE}.png")
            self.assertIsNone(process.poll(), "Does the picture stay until a key is pressed?")
            display.press(window, "space")
            _, message = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, message)

    def test_without_a_screen_it_says_so(self):
        process = start_preview(self.out, {})
        _, message = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 2)
        self.assertIn("--preview: no window can be opened here", message)


if __name__ == "__main__":
    unittest.main()
