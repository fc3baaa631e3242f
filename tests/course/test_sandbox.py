"""tools/exercises/sandbox.py: what a program finds, and what it cannot do, where hand-ins run. Python plays the test program.

Where no sandbox is to be had, found out by trying, the same tests show what is missing: they fail.
"""

import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from course_lib.paths import BUILD, ROOT
from exercises import sandbox, verdicts
from test_verdicts import PROLOGUE

PASSES = '\nverdict("passed")\n'


class Sandbox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        assert sandbox.why_not() == "", sandbox.why_not()

    def setUp(self):
        BUILD.mkdir(exist_ok=True)
        folder = tempfile.TemporaryDirectory(dir=BUILD)  # not in /tmp, of which the sandbox has its own
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, text, time_limit=20.0, memory_limit=0):
        program = self.folder / "program"
        program.write_text(PROLOGUE.replace(sys.executable, sandbox.PYTHON) + text)
        program.chmod(0o755)
        return verdicts.run_test(program, "Suite.Test", time_limit, memory_limit, self.folder / "scratch", sandboxed=True)

    def test_an_honest_program_passes(self):
        outcome = self.run_program('open("mine", "w").write("x")\nprint(os.getcwd(), os.listdir())' + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "/tmp ['mine']\n"))

    def test_a_verdict_that_was_not_asked_for_has_no_word(self):
        outcome = self.run_program('os.set_blocking(word_from, False)\ntry:\n    print(os.read(word_from, 100))\n'
                                   'except BlockingIOError: print("nothing there")\n'
                                   'os.write(verdict_to, b\'{"word": "", "verdict": "passed", "failures": []}\\n\')\n')
        self.assertEqual((outcome.state, outcome.output), ("no verdict", "nothing there\n"))

    def test_the_graders_files_are_not_there(self):
        secret = self.folder / "reference.cpp"
        secret.write_text("the solution")
        places = [secret, Path(__file__), Path.home(), "/root", "/home", "/var", "/etc/passwd", "/etc/shadow", "/sys", "/run"]
        # Folders on the way to the program are there, when the tree lies in somebody's home, and hold that way alone.
        way = {str(parent) for parent in self.folder.parents}
        hidden = [str(place) for place in places if str(place) not in way]
        above = [str(place) for place in places if str(place) in way]
        outcome = self.run_program(f"print([p for p in {hidden!r} if os.path.exists(p)], "
                                   f"[p for p in {above!r} if len(os.listdir(p)) > 1])" + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "[] []\n"))

    def test_nothing_but_its_tmp_can_be_written(self):
        places = [__file__, "/usr/x", "/x", "/etc/x", "/dev/x", "/dev/shm/x", "/lib/x", f"{self.folder}/x", f"{self.folder}/program"]
        outcome = self.run_program(f"for place in {places!r}:\n    try:\n        open(place, 'w')\n        print(place)\n"
                                   "    except OSError: pass" + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", ""))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["program", "scratch"])

    def test_its_tmp_has_an_end(self):
        outcome = self.run_program("import errno\ntry:\n    for number in range(5):\n        with open(str(number), 'wb') as file:\n"
                                   "            file.write(bytes(60 << 20))\nexcept OSError as error: print(errno.errorcode[error.errno])"
                                   + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "ENOSPC\n"))

    def test_there_is_no_network(self):
        outcome = self.run_program("import socket\nprint([name for _, name in socket.if_nameindex()])\ntry:\n"
                                   "    socket.create_connection(('1.1.1.1', 53), 2)\nexcept OSError as error: print('unreachable')" + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "['lo']\nunreachable\n"))

    def test_it_sees_no_process_but_its_own_and_has_no_rights(self):
        outcome = self.run_program("print(len([n for n in os.listdir('/proc') if n.isdigit()]), os.getppid())\n"
                                   "print([l.split()[1] for l in open('/proc/self/status') if l.startswith('CapEff')])" + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "2 1\n['0000000000000000']\n"))

    def test_one_that_kills_its_parent_ends_nothing_but_itself(self):
        for victim in ("os.getppid()", "-1", f"{os.getpid()}"):
            outcome = self.run_program("import signal\nif os.getpid() > 9: os._exit(9)  # not in a world of its own\n"
                                       f"try:\n    os.kill({victim}, signal.SIGKILL)\nexcept OSError: pass\nos._exit(0)")
            self.assertIn(outcome.state, ("no verdict", "crashed"), victim)
            self.assertNotIn("exit code 9", outcome.reason, victim)

    def test_it_starts_no_process_but_threads(self):
        # Tries a few, each of which would leave at once.
        outcome = self.run_program("import threading\nstarted = 0\nfor _ in range(20):\n    try: child = os.fork()\n"
                                   "    except PermissionError: continue\n    if child == 0: os._exit(0)\n    started += 1\n"
                                   "thread = threading.Thread(target=lambda: print('thread'))\nthread.start()\nthread.join()\n"
                                   "print(started)" + PASSES)
        self.assertEqual((outcome.state, outcome.output), ("passed", "thread\n0\n"))

    def test_one_that_closes_its_pipes_and_goes_on_is_ended(self):
        start = time.monotonic()
        outcome = self.run_program("os.closerange(0, 50)\nwhile True: time.sleep(1)", time_limit=1)
        self.assertEqual(outcome.state, "timed out")
        self.assertLess(time.monotonic() - start, 15)

    def test_it_ends_with_the_grader(self):
        program = self.folder / "program"
        program.write_text(PROLOGUE.replace(sys.executable, sandbox.PYTHON) + "time.sleep(60)")
        program.chmod(0o755)
        grade = "import sys; from pathlib import Path; from exercises import verdicts\n" \
                "folder = Path(sys.argv[1])\n" \
                "verdicts.run_test(folder / 'program', 'Suite.Test', 60, 0, folder / 'scratch', sandboxed=True)"
        grader = subprocess.Popen([sys.executable, "-c", grade, self.folder], env={**os.environ, "PYTHONPATH": str(ROOT / "tools")})
        self.addCleanup(grader.kill)
        # bubblewrap, the sandbox's first process and the program; the first of them alone is not bound to its parent yet.
        self.assertTrue(self.comes_true(lambda: len(self.running() - {grader.pid}) > 2), "Does it begin?")
        grader.kill()
        grader.wait()
        self.assertTrue(self.comes_true(lambda: not self.running()), "Does it go on without its grader?")

    def running(self):
        """The processes whose command line names this test's folder."""
        found = set()
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                if bytes(self.folder) in path.read_bytes():
                    found.add(int(path.parent.name))
            except OSError:
                pass
        return found

    @staticmethod
    def comes_true(condition):
        deadline = time.monotonic() + 20
        while not condition() and time.monotonic() < deadline:
            time.sleep(0.02)
        return condition()

    def test_memory_is_limited(self):
        outcome = self.run_program("block = bytearray(2 << 30)" + PASSES, memory_limit=1024)
        self.assertEqual(outcome.state, "no verdict")
        self.assertIn("MemoryError", outcome.output)

    def test_crashes_are_told_from_exits(self):
        self.assertEqual(self.run_program("os.kill(os.getpid(), 11)").reason, "segmentation fault (SIGSEGV)")
        self.assertEqual(self.run_program("os._exit(7)").reason, "ended before the test did (exit code 7)")


if __name__ == "__main__":
    unittest.main()
