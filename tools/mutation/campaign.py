"""Tries the mutants of a chapter: builds them many to a program, a few programs at a time, and keeps what comes out."""

import concurrent.futures
import hashlib
import itertools
import random
import threading
import time
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.terminal import Step, count
from exercises.building import build_tree, program
from exercises.trees import files_to_build, lay_out, remove_tree
from mutation.equivalents import read_equivalents
from mutation.known import KnownOutcomes
from mutation.mutants import mutants_of, read_enumerations, read_targets
from mutation.programs import MutantProgram, Toolchain
from mutation.running import Batch, batches_of, limit_for, touches, try_mutant, try_reference

INVALID = "invalid"  # does not compile
EQUIVALENT = "equivalent"
UNTRIED = "untried"
SAME_CODE = {"state": EQUIVALENT, "by": "", "how": "", "why": "The compiler makes the reference's code of it."}
TOGETHER = 48  # mutants in a program
ROUND = 96  # mutants that are dealt out at once when the clock ends the run


@dataclass
class ChapterResult:
    """What became of the chosen mutants of a chapter."""

    catalog: object
    mutants: list  # the chosen ones
    outcomes: dict  # mutant's id -> {"state": ..., "by": test, "how": ..., "why": reason of an equivalent}
    complaints: list

    def of_state(self, state):
        return [m for m in self.mutants if self.outcomes.get(m.id, {"state": UNTRIED})["state"] == state]

    @property
    def share_caught(self):
        """Per cent of those that are mistakes; None when none was tried."""
        caught, escaped = len(self.of_state("caught")), len(self.of_state("escaped"))
        return 100 * caught / (caught + escaped) if caught + escaped else None


class Deadline:
    """When no further program is begun; never without minutes."""

    def __init__(self, minutes=None):
        self._end = None if minutes is None else time.monotonic() + 60 * minutes

    @property
    def ends(self):
        return self._end is not None

    @property
    def passed(self):
        return self.ends and time.monotonic() > self._end


class Campaign:
    """The mutants of one chapter and a tree in which the reference is built."""

    def __init__(self, catalog, folder, store, jobs):
        self._catalog = catalog
        self._tree = folder / "tree"
        self._work = folder / "programs"
        self._store = store
        self._jobs = jobs
        self._targets = read_targets(catalog)
        enumerations = read_enumerations()
        self.mutants = [m for target in self._targets.values() for m in mutants_of(target, enumerations)]
        self._equivalents = read_equivalents(catalog.chapter)
        self._touching = {}
        self._touching_lock = threading.Lock()

    def sample(self, size, seed, only=None):
        """`size` of the chapter's mutants, the same for the same seed; without a size all, in an order that the seed gives.

        @param only  an exercise, when no other is of interest
        """
        order = [m for m in self.mutants if only in (None, m.exercise)]
        if size is None and seed is None:
            return order
        random.Random(f"{seed} {self._catalog.chapter}").shuffle(order)
        return order[:size]

    def build_reference(self):
        """Builds the reference and runs its tests: all must pass, and they tell how long a test takes."""
        lay_out(self._tree, files_to_build(), {})
        remove_tree(self._work)
        self._work.mkdir(parents=True)
        built = build_tree(self._tree, [self._catalog.target], self._catalog.chapter)
        if built.error:
            raise CourseError(f"the reference of {self._catalog.chapter} does not build: {built.error}")
        self._toolchain = Toolchain(self._tree, self._catalog.target)
        self._digest = hashlib.sha256(program(self._tree, self._catalog.target).read_bytes()).hexdigest()
        self._known = KnownOutcomes(self._store, self._toolchain)
        self._seconds = {test.name: self._reference_seconds(test) for test in self._catalog.tests}

    def run(self, chosen, deadline):
        """@return ChapterResult; what was not tried before the deadline is missing in its outcomes"""
        outcomes = {}
        waiting = []
        for mutant in chosen:
            known = self._known.get(mutant)
            if known is not None:
                outcomes[mutant.id] = known
            else:
                waiting.append(mutant)
        at_once = ROUND if deadline.ends else max(1, len(waiting))
        with Step(f"try {count(len(waiting), 'mutant')} of {self._catalog.chapter}") as step:
            for done in self._try_all(list(groups(waiting, at_once)), deadline):
                outcomes.update(done)
                step.progress(len(outcomes) - len(chosen) + len(waiting), len(waiting))
        complaints = list(self._equivalents.complaints(self.mutants, outcomes))
        for mutant in chosen:
            reason = self._equivalents.reason(mutant)
            if reason and outcomes.get(mutant.id, {}).get("state") == "escaped":
                outcomes[mutant.id] = {**outcomes[mutant.id], "state": EQUIVALENT, "why": reason}
        return ChapterResult(self._catalog, chosen, outcomes, complaints)

    def _reference_seconds(self, test):
        key = self._store.key(self._digest, test.name, "seconds")
        if self._store.get(key) is None:
            batch = Batch((test.name,), int(limit_for(test.time_limit)), test.memory_limit)
            ended = try_reference(self._toolchain.reference, batch, self._work / "scratch")
            if not ended.passed:
                raise CourseError(f"{test.name} does not pass on the reference: {ended.how}")
            self._store.put(key, round(ended.seconds, 2))
        return self._store.get(key)

    def _try_all(self, chunks, deadline):
        numbers = itertools.count()

        def try_one(chunk):
            return {} if deadline.passed else self._try_together(chunk, self._work / str(next(numbers)))

        with concurrent.futures.ThreadPoolExecutor(self._jobs) as pool:
            waiting = [pool.submit(try_one, chunk) for chunk in chunks]
            try:
                for finished in concurrent.futures.as_completed(waiting):
                    yield finished.result()
            finally:
                pool.shutdown(cancel_futures=True)

    def _try_together(self, mutants, folder):
        """Mutants of one exercise in one program."""
        folder.mkdir(parents=True)
        target = self._targets[mutants[0].exercise]
        outcomes = {}
        try:
            built = MutantProgram(self._toolchain, target, mutants, folder)
            compiled = {mutant.id for mutant in built.mutants}
            for mutant in mutants:
                if mutant.id not in compiled:
                    outcomes[mutant.id] = self._known.put(mutant, {"state": INVALID, "by": "", "how": ""})
            batches = batches_of(self._tests_touching(target, built.program, folder), target.id, self._seconds)
            for number, mutant in enumerate(built.mutants, start=1):
                same = mutant.id in built.same
                outcomes[mutant.id] = self._known.put(mutant, dict(SAME_CODE) if same else
                                                 try_mutant(built.program, number, batches, folder / "scratch"))
        finally:
            remove_tree(folder)
        return outcomes

    def _tests_touching(self, target, built, folder):
        """The graded tests that enter the exercise's body: no other can notice a mistake in it."""
        with self._touching_lock:
            key = self._store.key(self._digest, target.id, target.body, "touching")
            if self._store.get(key) is None:
                names = [test.name for test in self._catalog.tests
                         if touches(built, test, limit_for(self._seconds[test.name]), folder / "scratch")]
                self._store.put(key, names)
            names = self._store.get(key)
        return [test for test in self._catalog.tests if test.name in names]


def groups(mutants, at_once):
    """Lists of at most TOGETHER mutants of one exercise.

    @param at_once  that many are dealt out before the next: a run that is ended by the clock has then seen of all exercises
    """
    for begin in range(0, len(mutants), at_once):
        by_exercise = {}
        for mutant in mutants[begin:begin + at_once]:
            by_exercise.setdefault(mutant.exercise, []).append(mutant)
        for of_one in by_exercise.values():
            for start in range(0, len(of_one), TOGETHER):
                yield of_one[start:start + TOGETHER]
