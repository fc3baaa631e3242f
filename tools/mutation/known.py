"""Finds what an earlier run found out of a mutant, as long as all that it depends on is as it was.

A test that caught a mutant catches it again when neither the library nor the test's own file has changed; so a change in
one graded file asks anew what this file caught and what escaped, and nothing else. Whether a body compiles, and to the
reference's code, is up to the library alone, unless the body stands in a header, which tests include.
"""

import hashlib
import re

CAUGHT = "caught"
ESCAPED = "escaped"
TEST = re.compile(r"^TEST\w*\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.MULTILINE)


class KnownOutcomes:
    """The outcomes of a chapter's mutants, kept from run to run."""

    def __init__(self, store, toolchain):
        """@param toolchain  of the reference, built"""
        self._store = store
        self._library = digest_of(*toolchain.library_words, *map(contents, toolchain.library_objects))
        self._files = {name: digest_of(contents(path)) for name, path in toolchain.test_objects.items()}
        self._file_of_test = {}
        for name, path in toolchain.test_sources.items():
            for suite, test in TEST.findall(path.read_text(encoding="utf-8", errors="replace")):
                self._file_of_test[f"{suite}.{test}"] = name

    def get(self, mutant):
        """The outcome, or None."""
        for part in (self._of_library(mutant), *map(self._of_file, self._files), self._of_all()):
            found = part and self._store.get(self._key(mutant, part))
            if found:
                return found
        return None

    def put(self, mutant, outcome):
        """@return the outcome"""
        self._store.put(self._key(mutant, self._part(mutant, outcome)), outcome)
        return outcome

    def _part(self, mutant, outcome):
        """What the outcome depends on besides the library."""
        if outcome["state"] == CAUGHT and outcome["by"] in self._file_of_test:
            return self._of_file(self._file_of_test[outcome["by"]])
        of_library = outcome["state"] not in (CAUGHT, ESCAPED) and self._of_library(mutant)
        return of_library or self._of_all()

    def _key(self, mutant, part):
        return self._store.key(self._library, mutant.exercise, mutant.body, part)

    @staticmethod
    def _of_library(mutant):
        return "" if mutant.path.endswith(".h") else "library"

    def _of_file(self, name):
        return f"{name} {self._files[name]}"

    def _of_all(self):
        return digest_of(*(self._of_file(name) for name in sorted(self._files)))


def digest_of(*parts):
    return hashlib.sha256(b"\0".join(part if isinstance(part, bytes) else part.encode() for part in parts)).hexdigest()


def contents(path):
    return path.read_bytes()
