"""Runs a file of tests in a copy of the tree that has the tools and what the toy course is made of: alone.py MODULE.

A copy, so that no input is forgotten: what else such a test would read is not there (course_lib/checks.py).
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from course_lib.checks import seen_alone
from exercises.trees import lay_out


def main():
    with tempfile.TemporaryDirectory(prefix="caustic-") as folder:
        top = Path(folder) / "caustic"
        lay_out(top, seen_alone(), {})
        environment = {name: value for name, value in os.environ.items() if name != "CAUSTIC_BUILD_DIR"}
        environment["PYTHONPATH"] = str(top / "tools")
        command = [sys.executable, "-B", "-m", "unittest", *sys.argv[1:]]
        return subprocess.run(command, cwd=top / "tests" / "course", env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
