"""What was green for which inputs, so that nothing is tried again whose outcome is known: build/green.json.

A check is known by a name. Its inputs are all that can change its outcome, as one hash: sources, data, tools, build files,
and what is installed (toolchain()). When one of them changes, the check is due again.
"""

import contextlib
import fcntl
import functools
import hashlib
import json
import os
import platform
import subprocess
import sys

from course_lib.paths import BUILD, ROOT

# What CMake and the compilers read of the environment.
VARIABLES = ("CC", "CXX", "CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS", "CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH",
             "LD_LIBRARY_PATH")


class Memory:
    """The checks that were green, kept in a file that several runs may share."""

    def __init__(self, path=None):
        self._path = path or BUILD / "green.json"

    def passed(self, check, inputs):
        """How many tests of the check passed when it was green for these inputs; None when it was not."""
        entry = self._read().get(check)
        return entry["passed"] if entry and entry["inputs"] == inputs else None

    def remember(self, check, inputs, passed):
        with self._locked():
            self._write({**self._read(), check: {"inputs": inputs, "passed": passed}})

    def forget(self, check):
        with self._locked():
            self._write({name: entry for name, entry in self._read().items() if name != check})

    def _read(self):
        try:
            return json.loads(self._path.read_text())
        except (OSError, ValueError):
            return {}  # never written, or cut short: nothing is known

    def _write(self, entries):
        temporary = self._path.with_suffix(".tmp")
        temporary.write_text(json.dumps(entries, indent=1, sort_keys=True) + "\n")
        temporary.replace(self._path)

    @contextlib.contextmanager
    def _locked(self):
        self._path.parent.mkdir(parents=True, exist_ok=True)
        with open(self._path.with_suffix(".lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield


def digest(words):
    """One hash of texts and paths; a path counts by its bytes, or by its absence."""
    total = hashlib.sha256()
    for word in words:
        content = word.encode() if isinstance(word, str) else bytes_of(word)
        total.update(f"{len(content)}:".encode() + content)
    return total.hexdigest()


def bytes_of(path):
    try:
        state = path.stat()
        return hash_of_file(path, state.st_mtime_ns, state.st_size)
    except OSError:
        return b"none"


@functools.lru_cache(maxsize=None)
def hash_of_file(path, modified, size):
    return hashlib.sha256(path.read_bytes()).digest()


def files_digest(names, root=ROOT):
    """One hash of files below the root: their names, whether they can be run, and what is in them."""
    words = []
    for name in sorted(names):
        words += [name, str(os.access(root / name, os.X_OK)), root / name]
    return digest(words)


@functools.lru_cache
def toolchain():
    """What is installed: every Debian package with its version, the compiler, CMake, this Python, the processor's kind."""
    words = [sys.version, platform.machine(), *(f"{name}={os.environ.get(name)}" for name in VARIABLES)]
    for command in (["dpkg-query", "-W"], ["cmake", "--version"], [os.environ.get("CXX", "c++"), "-v"]):
        try:
            words.append(subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout)
        except FileNotFoundError:
            words.append("none")
    return digest(words)
