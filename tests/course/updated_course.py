"""A toy course that changes, and a student's tree that is to follow it."""

import hashlib
import os
import shutil

from exercises import student
from toy_course import ToyCase, course

SUMS, CLAMP, PRODUCTS = "common/math/sums.cpp", "common/math/clamp.h", "common/math/products.cpp"
MINE = "double all = 0;\nfor (double one : values) all += one;\nreturn all;"


def snapshot(tree, *left_out):
    """path -> hash and rights of all files but git's and those that were built."""
    found = {}
    for path in sorted(tree.rglob("*")):
        name = path.relative_to(tree).as_posix()
        if path.is_file() and not name.startswith((".git/", "build/", *left_out)) and "__pycache__" not in name:
            found[name] = hashlib.sha256(path.read_bytes()).hexdigest(), os.access(path, os.X_OK)
    return found


def replace(path, old, new):
    text = path.read_text()
    assert old in text, f"{path} has no {old}"
    path.write_text(text.replace(old, new))


class Updating(ToyCase):
    """Each test has a copy of the course to change and a student's tree of the unchanged one."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.started = cls.top / "started"
        assert course(cls.toy, "start", cls.started).returncode == 0
        shutil.rmtree(cls.started / ".git")

    def setUp(self):
        self.new, self.tree = self.top / "new", self.top / "tree"
        for target, source in ((self.new, self.toy), (self.tree, self.started)):
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(source, target)

    def update(self, *words, code=0, source=None):
        ended = course(self.tree, "update", "--from", source or self.new, *words)
        self.assertEqual(ended.returncode, code, ended.stdout + ended.stderr)
        self.assertFalse((self.tree / student.UPDATE).exists(), "Is nothing left behind?")
        return ended.stderr if code else ended.stdout

    def asides(self):
        """name -> text of what was put aside."""
        top = self.tree / student.ASIDE
        return {path.relative_to(top).as_posix().partition("/")[2]: path.read_text() for path in top.rglob("*") if path.is_file()}

    def as_started(self):
        """A student's tree of the course as it is now."""
        fresh = self.top / "fresh"
        shutil.rmtree(fresh, ignore_errors=True)
        fresh.mkdir()
        student.make(fresh, 1, self.new)
        return fresh

    def change_much(self):
        """A course in which something of each kind has changed."""
        replace(self.new / SUMS, "double mean(", "/// New words.\ndouble mean(")
        replace(self.new / SUMS, "double largest(const std::vector<double>& values) {",
                "double largest(const std::vector<double>& values,\n               double least) {")
        replace(self.new / "common/math/sums.h", "double largest(const std::vector<double>& values);",
                "double largest(const std::vector<double>& values, double least);")
        replace(self.new / CLAMP, "    //! [ex-01.4]\n", "    // solved for you\n")
        (self.new / "common/math/later.cpp").write_text(
            "double later() {\n    //! [ex-02.2]\n    return 3;\n    //! [ex-02.2]\n}\n")
        (self.new / "chapters/03_third").mkdir()
        (self.new / "chapters/03_third/main.cpp").write_text("// another chapter\n")
        (self.new / "tests/01_first/mistakes/one_more.patch").write_text("exercise: ex-01.1\n")
        replace(self.new / "tests/01_first/graded_sums.cpp", "EXPECT_EQ(total({}), 0);", "EXPECT_EQ(total({}), 0) << 1;")
        (self.new / "chapters/02_second/main.cpp").unlink()
        replace(self.new / "tools/commands/hint.py", 'HELP = "', 'HELP = "of now: ')
        (self.new / "tools/commands/fresh.py").write_text('HELP = "fresh"\n')
        (self.new / "tools/commands/bench.py").unlink()
