"""Packages: what is listed, what is missing, how it is installed, and what happens where nothing can be."""

import contextlib
import io
import os
import shutil
import stat
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from course_lib import cmake, packages
from course_lib.errors import CourseError
from course_lib.paths import ROOT
from course_lib.process import Finished

STUB_TOOLS = ("sh", "dirname", "env", "id", "python3")


def ensure(group, installed=(), debian=True, root=True, sudo=True, apt_code=0):
    """Calls ensure_packages on a made-up system; returns what it ran and what it printed."""
    commands = []

    def run(command, title, **_):
        commands.append(command)
        return Finished(apt_code, "E: no network\n" if apt_code else "", 0)

    def missing(wanted):
        return [package for package in wanted if package.name not in installed]

    found = {"sudo": "/usr/bin/sudo"} if sudo else {}
    printed = io.StringIO()
    with mock.patch.object(packages, "run", run), mock.patch.object(packages, "missing_packages", missing), \
            mock.patch.object(packages, "is_debian", lambda: debian), \
            mock.patch.object(packages.shutil, "which", found.get), \
            mock.patch.object(packages.os, "geteuid", lambda: 0 if root else 1000), \
            contextlib.redirect_stdout(printed):
        packages.ensure_packages(group)
    return commands, printed.getvalue()


def all_names(group):
    return {package.name for package in packages.needed_packages(group)}


class PackageList(unittest.TestCase):
    def test_every_line_has_a_group_and_a_purpose_and_no_name_comes_twice(self):
        names = [package.name for package in packages.read_packages()]
        self.assertEqual(len(names), len(set(names)))

    def test_groups_include_what_they_build_on(self):
        self.assertLess(all_names("build"), all_names("docs"))
        self.assertLess(all_names("docs"), all_names("test"))
        self.assertLess(all_names("test") | all_names("bench"), all_names("full"))
        self.assertNotIn("chromium", all_names("build"), "Must a reader of the figures install a browser?")

    def test_a_bad_line_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "packages.txt"
            path.write_text("# names\ncmake build configures\nninja-build nonsense\n")
            with self.assertRaisesRegex(CourseError, r"packages\.txt:3"):
                packages.read_packages(path)

    def test_dpkg_is_asked_what_is_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            stub = Path(folder) / "dpkg-query"
            stub.write_text("#!/bin/sh\nprintf 'cmake ii \\ng++ hi \\nchromium rc \\n'\n")
            stub.chmod(stub.stat().st_mode | stat.S_IXUSR)
            wanted = [packages.Package(name, "build", "") for name in ("cmake", "g++", "chromium", "xvfb")]
            with mock.patch.dict(os.environ, {"PATH": folder + ":" + os.environ["PATH"]}):
                missing = [package.name for package in packages.missing_packages(wanted)]
        self.assertEqual(missing, ["chromium", "xvfb"], "Is a package that was removed, its settings kept, installed?")


class Installing(unittest.TestCase):
    def test_what_is_missing_is_listed_and_installed(self):
        commands, printed = ensure("build", installed=all_names("build") - {"cmake", "gnuplot-nox"})
        self.assertEqual([command[-2:] for command in commands[1:]], [["cmake", "gnuplot-nox"]])
        self.assertIn("--no-install-recommends", commands[1])
        self.assertRegex(printed, r"gnuplot-nox +charts")
        self.assertNotIn("sudo", commands[1])

    def test_nothing_is_run_again_when_all_is_there(self):
        commands, printed = ensure("test", installed=all_names("test"))
        self.assertEqual((commands, printed), ([], ""))

    def test_sudo_is_used_when_not_root(self):
        commands, _ = ensure("build", root=False)
        self.assertTrue(all(command[0] == "sudo" for command in commands) and commands)

    def test_without_root_and_sudo_it_says_what_to_run_and_goes_on(self):
        commands, printed = ensure("build", installed=all_names("build") - {"cmake"}, root=False, sudo=False)
        self.assertEqual(commands, [])
        self.assertIn("apt-get install cmake", printed)

    def test_another_system_gets_the_list_and_goes_on(self):
        commands, printed = ensure("build", debian=False)
        self.assertEqual(commands, [])
        for name in all_names("build"):
            self.assertIn(name, printed)

    def test_a_failed_installation_is_one_line_with_the_reason(self):
        with self.assertRaisesRegex(CourseError, "apt-get update failed: E: no network; check the network"):
            ensure("build", apt_code=100)


class Script(unittest.TestCase):
    """The shell part: finds or installs Python, and hands over."""

    def run_course(self, tools, *words, stubs=()):
        """Runs ./course with nothing on the PATH but `tools` and stubs that only tell how they are called."""
        with tempfile.TemporaryDirectory() as folder:
            for tool in tools:
                (Path(folder) / tool).symlink_to(shutil.which(tool))
            for name in stubs:
                stub = Path(folder) / name
                stub.write_text(f'#!{shutil.which("sh")}\necho "{name} $*" >&2\n')
                stub.chmod(0o755)
            return subprocess.run([shutil.which("sh"), ROOT / "course", *words], env={"PATH": folder}, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_help_lists_the_commands(self):
        finished = self.run_course(STUB_TOOLS, "--help")
        self.assertEqual(finished.returncode, 0)
        for command in ("setup", "build", "figures", "test"):
            self.assertRegex(finished.stdout, rf"\n  {command} +\w")

    def test_without_python_and_apt_it_says_what_to_install(self):
        finished = self.run_course(("dirname", "id"), "build")
        self.assertEqual(finished.returncode, 1)
        self.assertRegex(finished.stderr, r"^course: python3 is missing; install .*\n$")

    def test_without_python_it_installs_it(self):
        finished = self.run_course(("dirname", "env", "id"), "build", stubs=("apt-get", "sudo"))
        self.assertIn("install -y --no-install-recommends python3", finished.stderr)
        self.assertNotEqual(finished.returncode, 0, "The stub installs nothing, so there is nothing to hand over to.")

    def test_a_wrong_word_is_one_line(self):
        for words, pattern in ((["figurs"], "no command 'figurs'; there are"), (["build", "--prest"], "see ./course build --help"),
                               (["figures", "99"], "no chapter '99'; there are 01_bezier_curves")):
            finished = self.run_course(STUB_TOOLS, *words)
            self.assertEqual(finished.returncode, 1)
            self.assertRegex(finished.stderr, "^course: .*" + pattern + ".*\n$")


class Configured(unittest.TestCase):
    """When a build folder is configured again. What is built without a package stays out until then."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = Path(temporary.name)
        self.ninja = folder / "build.ninja"
        self.presets = folder / "presets"
        self.installed = folder / "status"
        for path in (self.presets, self.installed):
            path.touch()
            os.utime(path, (1000, 1000))
        patched = mock.patch.object(cmake, "CONFIGURED_FROM", (self.presets, self.installed))
        patched.start()
        self.addCleanup(patched.stop)

    def at(self, path, time):
        path.touch()
        os.utime(path, (time, time))
        return cmake.configured_after(self.ninja)

    def test_once_is_enough(self):
        self.assertFalse(cmake.configured_after(self.ninja))
        self.assertTrue(self.at(self.ninja, 2000))

    def test_again_when_packages_came(self):
        self.at(self.ninja, 2000)
        self.assertFalse(self.at(self.installed, 3000), "Is what needs them built from now on?")
        self.assertTrue(self.at(self.ninja, 4000))

    def test_again_when_presets_changed(self):
        self.at(self.ninja, 2000)
        self.assertFalse(self.at(self.presets, 3000))

    def test_other_systems_have_no_list_of_packages(self):
        self.installed.unlink()
        self.assertTrue(self.at(self.ninja, 2000))


if __name__ == "__main__":
    unittest.main()
