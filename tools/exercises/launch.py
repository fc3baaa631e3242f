"""Starts a program under limits: launch.py [--processes=N] MEMORY_MIB CPU_SECONDS FILE_MIB PROGRAM [ARGUMENT...]; 0 sets no limit.

A program of its own because limits have to be set between fork and exec, where a grader with threads must not run Python.
"""

import os
import resource
import sys


def limit(kind, value):
    if value:
        _, hard = resource.getrlimit(kind)
        most = value if hard == resource.RLIM_INFINITY else min(value, hard)
        try:
            resource.setrlimit(kind, (most, most))
        except (ValueError, OSError):
            pass  # macOS refuses a limit of address space


def main(arguments):
    if arguments[0].startswith("--processes="):
        limit(resource.RLIMIT_NPROC, int(arguments.pop(0).split("=")[1]))
    memory, seconds, file_size = (int(word) for word in arguments[:3])
    limit(resource.RLIMIT_AS, memory << 20)
    limit(resource.RLIMIT_CPU, seconds)
    limit(resource.RLIMIT_FSIZE, file_size << 20)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.execvp(arguments[3], arguments[3:])


if __name__ == "__main__":
    main(sys.argv[1:])
