"""A filter of system calls: what is under it starts threads, but no process.

A test needs none, and a limit of processes (RLIMIT_NPROC) does not bind a grader that is root. The filter is a classic
BPF program as seccomp(2) describes it.
"""

import errno
import platform
import struct
from dataclasses import dataclass

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
CALL, MACHINE, FIRST_ARGUMENT = 0, 4, 16  # where a call's data stand; the argument's lower half
ALLOW, KILL, FAIL = 0x7FFF0000, 0x80000000, 0x00050000
CLONE_THREAD = 0x00010000
X32 = 0x40000000  # x86-64's second table of calls begins here


@dataclass(frozen=True)
class Calls:
    """A machine's numbers."""

    machine: int  # AUDIT_ARCH_*
    clone: int
    clone3: int
    forks: tuple
    end: int = 0xFFFFFFFF  # of the numbers that are taken


NEWER = (220, 435, ())  # the numbers that all newer machines share
CALLS = {
    "x86_64": Calls(0xC000003E, 56, 435, (57, 58), X32),
    "aarch64": Calls(0xC00000B7, *NEWER),
    "riscv64": Calls(0xC00000F3, *NEWER),
}


def known():
    """Whether there is a filter for this machine."""
    return platform.machine() in CALLS


def without_children():
    """The filter for this machine, as bytes. clone3 hides its flags from a filter, so it is not there, and the C library
    takes clone."""
    calls = CALLS[platform.machine()]
    refused = FAIL | errno.EPERM
    steps = [(LOAD, 0, 0, MACHINE), (EQUAL, 1, 0, calls.machine), (RETURN, 0, 0, KILL), (LOAD, 0, 0, CALL)]
    steps += [(AT_LEAST, 0, 1, calls.end), (RETURN, 0, 0, refused)]
    steps += [(EQUAL, 0, 1, calls.clone3), (RETURN, 0, 0, FAIL | errno.ENOSYS)]
    for number in calls.forks:
        steps += [(EQUAL, 0, 1, number), (RETURN, 0, 0, refused)]
    steps += [(EQUAL, 1, 0, calls.clone), (RETURN, 0, 0, ALLOW), (LOAD, 0, 0, FIRST_ARGUMENT)]
    steps += [(ANY_BIT, 1, 0, CLONE_THREAD), (RETURN, 0, 0, refused), (RETURN, 0, 0, ALLOW)]
    return b"".join(struct.pack("=HBBI", *step) for step in steps)
