"""Which figures of a chapter are up to date, by what their provenance.json says."""

import json
from dataclasses import dataclass

import inputs
from course_lib.errors import CourseError
from course_lib.paths import ROOT, shown


@dataclass(frozen=True)
class Wanted:
    """What the figures are to be made with."""

    quality: str
    seed: int


@dataclass(frozen=True)
class CurrentInputs:
    """Hashes of what a chapter's figures would be made from now."""

    sources: str
    assets: dict

    @classmethod
    def of(cls, chapter, declarations, root=ROOT):
        return cls(inputs.sources_hash(declarations, chapter, root), inputs.asset_hashes(root))


def read(folder):
    """The entries of <folder>/provenance.json by figure; none when there is no such file."""
    path = folder / "provenance.json"
    if not path.exists():
        return {}
    try:
        return json.loads(path.read_text())["figures"]
    except (ValueError, KeyError, TypeError):
        raise CourseError(f"{shown(path)}: is no record of figures; remove it, then run ./course figures") from None


def input_reasons(entry, current):
    """What changed since a figure was made, in words; nothing when it is up to date."""
    reasons = []
    for name, digest in entry.get("inputs", {}).items():
        if name == "sources":
            if digest != current.sources:
                reasons.append("its sources changed")
        elif name not in current.assets:
            reasons.append(f"{name} is gone")
        elif digest != current.assets[name]:
            reasons.append(f"{name} changed")
    if "sources" not in entry.get("inputs", {}):
        reasons.append("its sources are not recorded")
    return reasons


def file_reasons(entry, folder):
    return [f"{name} is missing" for name in entry.get("files", []) if not (folder / name).is_file()]


def stale_reasons(entry, current, folder, wanted=None):
    """Why a figure must be drawn again; nothing when it need not be."""
    if entry is None:
        return ["it was never drawn"]
    reasons = input_reasons(entry, current) + file_reasons(entry, folder)
    if wanted and (entry.get("quality"), entry.get("seed")) != (wanted.quality, wanted.seed):
        reasons.append(f"it was drawn as {entry.get('quality')} with seed {entry.get('seed')}")
    return reasons


def prune(folder, names):
    """Forgets figures that the chapter draws no more, and removes the files that were theirs alone."""
    entries = read(folder)
    gone = [name for name in entries if name not in names]
    if not gone:
        return []
    kept = {file for name in names for file in entries.get(name, {}).get("files", [])}
    removed = [file for name in gone for file in entries[name].get("files", []) if file not in kept]
    for file in removed:
        (folder / file).unlink(missing_ok=True)
    path = folder / "provenance.json"
    record = json.loads(path.read_text())
    for name in gone:
        del record["figures"][name]
    path.write_text(json.dumps(record, indent=2) + "\n")
    return removed
