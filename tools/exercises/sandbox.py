"""Where somebody else's code is compiled and run: bubblewrap, with namespaces of its own for processes, network, users,
mounts and IPC.

In there the machine is /usr and what else the loader needs, read-only, and the files that are named; /tmp is private, and
of limited size. There are no capabilities. All that was started in there is dead when Watch.end comes back.
"""

import json
import os
import platform
import selectors
import shutil
import signal
import subprocess
import sys
from functools import lru_cache
from pathlib import Path

from course_lib.errors import CourseError
from exercises import system_calls

LAUNCH = Path(__file__).resolve().parent / "launch.py"
SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/opt", "/nix")
LOADER = ("/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/alternatives", "/etc/localtime")
# The system's own Python where there is one: another one may lie in somebody's home.
PYTHON = "/usr/bin/python3" if os.access("/usr/bin/python3", os.X_OK) else sys.executable
MOST_PROCESSES = 256  # of a user, threads counted; binds none who is root
HOME = "/tmp"
TRIAL = 20  # seconds for the trial whether it works


class NoSandbox(CourseError):
    """There is no sandbox here."""

    code = 3


def program():
    """The path of bubblewrap; None where it isn't installed."""
    return shutil.which("bwrap")


@lru_cache(maxsize=None)
def why_not():
    """Why there is no sandbox here, found out by trying; empty when there is one."""
    if program() is None:
        return "bubblewrap is not installed (./course setup --group grade)"
    if not system_calls.known():
        return f"there is no filter of system calls for {platform.machine()}"
    command = wrapped(["/usr/bin/env", "true"])
    try:
        tried = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace", timeout=TRIAL)
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"bubblewrap cannot be run: {error}"
    if tried.returncode == 0:
        return ""
    lines = tried.stdout.strip().splitlines() or [f"exit code {tried.returncode}"]
    return f"bubblewrap makes none on this machine ({lines[-1]})"


def require():
    """@throws NoSandbox where there is none"""
    if why_not():
        raise NoSandbox(f"no sandbox: {why_not()}; where a container or a machine that is thrown away holds what a hand-in "
                        "does, grade with --unsandboxed")


def wrapped(command, readable=(), writable=(), size=256, info=None, calls_from=None):
    """A command as it is run in the sandbox.

    @param readable, writable  paths that are there under their own names; a later one may lie in an earlier one
    @param size  of /tmp, in MiB
    @param info  a descriptor that tells about the sandbox's first process
    @param calls_from  a descriptor with the filter of system calls
    """
    words = [program(), "--unshare-user", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts",
             "--unshare-cgroup-try", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--hostname", "sandbox"]
    for place in SYSTEM:
        if os.path.islink(place):
            words += ["--symlink", os.readlink(place), place]
        elif os.path.isdir(place):
            words += ["--ro-bind", place, place]
    for place in LOADER:
        words += ["--ro-bind-try", place, place]
    words += ["--proc", "/proc", "--dev", "/dev", "--size", str(size << 20), "--tmpfs", "/tmp"]
    if PYTHON == sys.executable:
        for place in (sys.base_prefix, sys.prefix):
            words += [] if place.startswith(SYSTEM) else ["--ro-bind", place, place]
    for place in readable:
        words += ["--ro-bind", str(place), str(place)]
    for place in writable:
        words += ["--bind", str(place), str(place)]
    words += ["--remount-ro", "/dev", "--remount-ro", "/", "--chdir", HOME]
    if info is not None:
        words += ["--info-fd", str(info)]
    if calls_from is not None:
        words += ["--seccomp", str(calls_from)]
    return [*words, "--", *map(str, command)]


def limited(command, memory, seconds, file_size, processes=0):
    """A command under limits (launch.py): MiB, seconds of processor time, MiB, processes; 0 sets none."""
    return [PYTHON, "-I", "-S", LAUNCH, f"--processes={processes}", str(memory), str(seconds), str(file_size), *command]


def childless():
    """A descriptor with the filter under which no process can be started."""
    readable, writable = os.pipe()
    os.write(writable, system_calls.without_children())
    os.close(writable)
    return readable


class Watch:
    """Knows the sandbox's first process, and that with it all others are dead."""

    def __init__(self, info):
        """@param info  where bubblewrap writes; is read to its end and closed"""
        self._process = None
        with os.fdopen(info, "rb") as stream:
            text = stream.read()
        try:
            self._process = os.pidfd_open(json.loads(text)["child-pid"])
        except (ValueError, KeyError, OSError):
            pass  # it has ended already, or bubblewrap never came so far

    def end(self):
        """Kills all that is in there, and comes back when it is dead.

        The kernel lets the first process of a process namespace go last.
        """
        if self._process is None:
            return
        try:
            signal.pidfd_send_signal(self._process, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            pass
        with selectors.DefaultSelector() as selector:
            selector.register(self._process, selectors.EVENT_READ)
            selector.select()
        os.close(self._process)
        self._process = None


def compiler_cache():
    """The folder of ccache, made if need be; none where there is no ccache."""
    ccache = shutil.which("ccache")
    if not ccache:
        return []
    asked = subprocess.run([ccache, "--get-config", "cache_dir"], stdout=subprocess.PIPE, text=True)
    folder = Path(asked.stdout.strip())
    if asked.returncode != 0 or not folder.is_absolute():
        return []
    folder.mkdir(parents=True, exist_ok=True)
    return [folder]


def exit_code(code):
    """bubblewrap's exit code as that of what ran in it: -9 when signal 9 ended it."""
    return 128 - code if code is not None and code > 128 else code
