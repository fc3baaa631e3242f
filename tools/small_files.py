"""Names those of the given files that are larger than 2 MB, the most that a file of the course may have: small_files.py FILE..."""

import sys
from pathlib import Path

MOST = 2_000_000  # bytes


def large_files(names):
    """(name, bytes) of the files that are too large."""
    return [(name, Path(name).stat().st_size) for name in names if Path(name).is_file() and Path(name).stat().st_size > MOST]


if __name__ == "__main__":
    found = large_files(sys.argv[1:])
    for name, size in found:
        print(f"{name}: it has {size / 1e6:.1f} MB, and {MOST / 1e6:.0f} MB is the most; make it smaller", file=sys.stderr)
    sys.exit(1 if found else 0)
