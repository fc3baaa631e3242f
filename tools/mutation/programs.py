"""Builds the programs that hold many mutants: compiles what an exercise's file goes into anew, links it in front of the rest."""

import json
import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from course_lib.errors import CourseError
from exercises.building import MOST_COMPILER_FILE, MOST_COMPILER_MEMORY, MOST_COMPILER_TIME, PRESET, first_error, program
from exercises.verdicts import LAUNCH
from mutation.same_code import same_as_last
from mutation.schema import CHOICE, HEADER, blamed, make_schema

ARCHIVE_MEMBER = re.compile(r"\((\S*?)lib(\w+)\.a\)(\S+\.o)$")  # (common/math/libcaustic_math_01.a)slabs.cpp.o
SYNTAX_ONLY = "-fsyntax-only"


@dataclass(frozen=True)
class Unit:
    """A file that is compiled, as the build knows it."""

    object: str  # below the build folder
    source: str
    command: tuple  # the compiler's words without -o, -c and their files


class Toolchain:
    """How a built tree compiles and links the graded tests of a chapter."""

    def __init__(self, tree, target):
        self.tree = tree
        self.folder = tree / "build" / PRESET
        self.reference = program(tree, target)
        self._link = self._link_words(target)
        commands = json.loads((self.folder / "compile_commands.json").read_text())
        units = [unit_of(entry) for entry in commands]
        linked = self._linked_objects()
        self.units = {unit.object: unit for unit in units if unit.object in linked}
        own = [word for word in self._link if word.endswith(".o")]
        self.library_words = tuple(word for word in self._link if word not in own)
        self.library_objects = tuple(self.folder / name for name in sorted(self.units) if name not in own)
        self.test_objects = {name: self.folder / name for name in own}
        self.test_sources = {name: Path(self.units[name].source) for name in own if name in self.units}
        self._dependencies = self._read_dependencies()

    def units_with(self, path):
        """The units of the test program that an exercise's file is compiled into."""
        source = str((self.tree / path).resolve())
        if not path.endswith(".h"):
            return [unit for unit in self.units.values() if os.path.realpath(unit.source) == source]
        return [unit for unit in self.units.values() if source in self._dependencies.get(unit.object, ())]

    def compile(self, unit, object_, replaced, folder, *more):
        """Compiles a unit with `replaced` (its path in the tree, below `folder`) in place of the tree's.

        @return the compiler's output; empty when all went well
        """
        source = unit.source
        if os.path.realpath(source) == str((self.tree / replaced).resolve()):
            source = str(folder / replaced)
        # In front of all others: a header with many mutants hides the tree's.
        words = [unit.command[0], f"-I{folder}", f"-I{folder / 'common'}", *unit.command[1:], "-w", *more]
        if SYNTAX_ONLY in more:
            return self._execute([*words, "-c", source])
        assembly = f"{object_}.s"
        # Functions with one code stay two: mutation.same_code looks for them.
        return (self._execute([*words, "-fno-ipa-icf", "-S", "-o", assembly, source])
                or self._execute([unit.command[0], "-c", "-o", str(object_), assembly]))

    def link(self, objects, target):
        """Links the test program with some of its objects replaced.

        @param objects  object below the build folder -> the new one
        """
        words = [str(objects[word]) if word in objects else word for word in self._link]
        out = words.index("-o")
        words[out + 1] = str(target)
        own = [str(new) for old, new in objects.items() if old not in self._link]
        # Before any archive: a member of one is taken only for what is still missing.
        output = self._execute([*words[:out], *own, *words[out:]])
        if output:
            raise CourseError(f"mutants compile but don't link: {first_error(output)}")

    def _execute(self, words):
        limits = [str(MOST_COMPILER_MEMORY), str(10 * MOST_COMPILER_TIME), str(MOST_COMPILER_FILE)]
        ended = subprocess.run([sys.executable, "-I", "-S", str(LAUNCH), *limits, *words], cwd=self.folder,
                               env={**os.environ, "LC_ALL": "C"}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace")
        return "" if ended.returncode == 0 else ended.stdout or f"{words[0]} stopped with exit code {ended.returncode}"

    def _ninja(self, *words):
        return subprocess.run(["ninja", "-C", str(self.folder), "-t", *words], stdout=subprocess.PIPE, text=True,
                              errors="surrogateescape", check=True).stdout

    def _link_words(self, target):
        for line in reversed(self._ninja("commands", target).splitlines()):
            for part in line.split(" && "):
                if f"-o bin/{target} " in part:
                    return shlex.split(part)
        raise CourseError(f"ninja does not say how {target} is linked")

    def _linked_objects(self):
        """Everything of ours in the test program, as objects below the build folder."""
        words = list(self._link)
        words[words.index("-o") + 1] = os.devnull
        # Said twice, it names what is taken out of archives, too.
        traced = subprocess.run([*words, "-Wl,--trace,--trace"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True).stdout
        found = {word for word in self._link if word.endswith(".o")}
        for line in traced.splitlines():
            match = ARCHIVE_MEMBER.match(line.strip())
            if match:
                found.add(f"{match[1]}CMakeFiles/{match[2]}.dir/{match[3]}")
        return found

    def _read_dependencies(self):
        found = {}
        target = ""
        for line in self._ninja("deps").splitlines():
            if line and not line.startswith(" "):
                target = line.split(":")[0]
                found[target] = set()
            elif line.strip():
                found[target].add(os.path.realpath(self.folder / line.strip()))
        return found


def unit_of(entry):
    words = shlex.split(entry["command"])
    kept = []
    object_ = ""
    skip = False
    for word, following in zip(words, [*words[1:], ""]):
        if skip:
            skip = False
        elif word in ("-o", "-c", "-MF", "-MT"):
            skip = True
            object_ = following if word == "-o" else object_
        elif word not in ("-MD", "-Werror"):
            kept.append(word)
    return Unit(object_, entry["file"], tuple(kept))


class MutantProgram:
    """The test program with many mutants of one exercise in it."""

    def __init__(self, toolchain, target, mutants, folder):
        """Compiles and links; mutants that don't compile are left out.

        @param folder  for what is generated, empty
        """
        self._toolchain = toolchain
        self._target = target
        self._folder = folder
        self._path = target.exercise.path
        self._units = toolchain.units_with(self._path)
        if not self._units:
            raise CourseError(f"{target.exercise.place}: no graded test is linked with this file, so none can catch a mistake in it")
        (folder / self._path).parent.mkdir(parents=True, exist_ok=True)
        (folder / HEADER).write_text(CHOICE)
        self.mutants = self._compiling(list(mutants))
        self.program = folder / "program"
        objects = {}
        same = []
        self._write(self.mutants)
        for number, unit in enumerate(self._units):
            objects[unit.object] = folder / f"{number}.o"
            output = toolchain.compile(unit, objects[unit.object], self._path, folder)
            if output:
                raise CourseError(f"{target.exercise.place}: the mutants don't compile together: {first_error(output)}")
            assembly = (folder / f"{number}.o.s").read_text(errors="replace")
            same.append(same_as_last(assembly, len(self.mutants) + 1))
        same = [indices for indices in same if indices is not None]  # of the units that hold the body at all
        self.same = {self.mutants[i].id for i in set.intersection(*same)} if same else set()
        toolchain.link(objects, self.program)

    def _write(self, mutants):
        schema = make_schema(self._target, mutants)
        (self._folder / self._path).write_bytes(schema.text.encode("utf-8", "surrogateescape"))
        return schema

    def _compiling(self, mutants):
        """Those that compile."""
        while mutants:
            schema = self._write(mutants)
            outputs = self._errors()
            if not outputs:
                return mutants
            bad = set().union(*(blamed(output, self._folder / self._path, schema) for output in outputs))
            if not bad:  # nobody is named: by halves
                if len(mutants) == 1:
                    return []
                middle = len(mutants) // 2
                return self._compiling(mutants[:middle]) + self._compiling(mutants[middle:])
            mutants = [mutant for i, mutant in enumerate(mutants) if i not in bad]
        self._write([])
        outputs = self._errors()
        if outputs:
            raise CourseError(f"{self._target.exercise.place}: the reference does not compile with a choice of bodies: "
                              f"{first_error(outputs[0])}")
        return []

    def _errors(self):
        outputs = (self._toolchain.compile(unit, None, self._path, self._folder, SYNTAX_ONLY) for unit in self._units)
        return [output for output in outputs if output]
