"""The Debian packages of packages.txt: which are needed, which are missing, how they are installed."""

import os
import shutil
import subprocess
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.process import run
from course_lib.terminal import say

# What a group asks for besides its own packages.
GROUPS = {
    "build": (),
    "docs": ("build",),
    "grade": ("build",),
    "test": ("build", "docs", "grade"),
    "bench": ("test",),
    "full": ("bench",),
}


@dataclass(frozen=True)
class Package:
    name: str
    group: str
    purpose: str


def read_packages(path=ROOT / "packages.txt"):
    """All lines `name group purpose` of packages.txt; # starts a comment."""
    packages = []
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        words = line.split("#")[0].split(None, 2)
        if not words:
            continue
        if len(words) < 3 or words[1] not in GROUPS:
            raise CourseError(f"{path.name}:{number}: a line is 'name group purpose', group one of {', '.join(GROUPS)}")
        packages.append(Package(*words))
    return packages


def groups_of(group):
    """The group and all that it asks for."""
    found = {group}
    for needed in GROUPS[group]:
        found |= groups_of(needed)
    return found


def needed_packages(group):
    wanted = groups_of(group)
    return [package for package in read_packages() if package.group in wanted]


def is_debian():
    return shutil.which("apt-get") is not None and shutil.which("dpkg-query") is not None


def missing_packages(packages):
    """Those that dpkg does not list as installed."""
    names = [package.name for package in packages]
    query = ["dpkg-query", "--show", "--showformat", "${Package} ${db:Status-Abbrev}\n", *names]
    listed = subprocess.run(query, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    installed = {line.split()[0] for line in listed.splitlines() if line.endswith(" ii ") or line.endswith(" hi ")}
    return [package for package in packages if package.name not in installed]


def list_packages(packages):
    for package in packages:
        say(f"  {package.name:<24} {package.purpose}")


def ensure_packages(group):
    """Makes sure that a group's packages are installed; says what it installs. Quick when nothing is missing.

    Where there is no apt-get (another system) or no right to use it, it prints the list and goes on: what is really
    missing, the build names.
    """
    packages = needed_packages(group)
    if not is_debian():
        say("This is no Debian, so nothing is installed. The course needs what these Debian packages hold:")
        list_packages(packages)
        return
    missing = missing_packages(packages)
    if not missing:
        return
    names = [package.name for package in missing]
    prefix = root_prefix()
    if prefix is None:
        say("Neither root nor sudo here, so nothing is installed. Missing packages:")
        list_packages(missing)
        say(f"Have them installed by: apt-get install {' '.join(names)}")
        return
    say(f"Installing {len(missing)} Debian packages:")
    list_packages(missing)
    apt(prefix, ["update"], "apt-get update")
    apt(prefix, ["install", "-y", "--no-install-recommends", *names], "apt-get install")


def root_prefix():
    """What to put before a command that needs root; None when there is no way."""
    if os.geteuid() == 0:
        return []
    return ["sudo"] if shutil.which("sudo") else None


def apt(prefix, words, title):
    command = [*prefix, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", *words]
    finished = run(command, title)
    if finished.code != 0:
        say(finished.output)
        reasons = [line for line in finished.output.splitlines() if line.startswith("E:")] or ["see its output above"]
        raise CourseError(f"{title} failed: {reasons[0]}; check the network and the package sources, then try again")
