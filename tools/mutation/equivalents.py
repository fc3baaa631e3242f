"""Mutants that are no mistakes: tests/NN_name/mistakes/equivalents.json says which, and why."""

import json
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.paths import ROOT

KEYS = ("exercise", "was", "becomes", "why")


@dataclass(frozen=True)
class Equivalents:
    """The listed mutants of a chapter."""

    place: str
    reasons: dict  # (exercise, was, becomes) -> why

    def reason(self, mutant):
        return self.reasons.get((mutant.exercise, mutant.was, mutant.becomes), "")

    def complaints(self, mutants, results):
        """Entries that name no mutant, or one that a test catches.

        @param mutants  all of the chapter; @param results  mutant's id -> outcome, of those that were tried
        """
        known = {(m.exercise, m.was, m.becomes): m for m in mutants}
        for key in self.reasons:
            mutant = known.get(key)
            if mutant is None:
                yield f"{self.place}: no operator makes this of {key[0]}: {key[2]!r}; take the entry out"
            elif results.get(mutant.id, {}).get("state") == "caught":
                yield f"{self.place}: {results[mutant.id]['by']} catches what is listed as equivalent in {key[0]}: {key[2]!r}"


def equivalents_path(chapter, root=ROOT):
    return root / "tests" / chapter / "mistakes" / "equivalents.json"


def read_equivalents(chapter, root=ROOT):
    """@throws CourseError for a file that is not as docs/mutants.md says"""
    path = equivalents_path(chapter, root)
    place = path.relative_to(root).as_posix()
    if not path.exists():
        return Equivalents(place, {})
    try:
        entries = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise CourseError(f"{place}: {error}") from None
    if not isinstance(entries, list):
        raise CourseError(f"{place}: must be a list; docs/mutants.md shows one")
    reasons = {}
    for number, entry in enumerate(entries, start=1):
        if not isinstance(entry, dict) or any(not isinstance(entry.get(key), str) for key in KEYS) or not entry["why"].strip():
            raise CourseError(f"{place}: entry {number} needs the texts {', '.join(KEYS)}; docs/mutants.md shows one")
        key = (entry["exercise"], entry["was"], entry["becomes"])
        if key in reasons:
            raise CourseError(f"{place}: entry {number} is there twice")
        reasons[key] = entry["why"]
    return Equivalents(place, reasons)
