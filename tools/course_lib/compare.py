"""Compares the numbers of two runs of a chapter: CSV files column by column, pictures block by block.

What counts as equal stands in chapters/NN_name/check.json, when it is there:
  {"relative": 1e-6, "absolute": 0,                      for all numbers (these are the defaults)
   "block": 2,                                           for block means of pictures, of 255
   "files": {"speed_accuracy.csv": {
       "relative": 1e-3,                                 for the numbers of this file
       "columns": {"error": {"relative": 0.2}},          for this column
       "ignore": ["note"],                               columns that are not compared
       "timed": ["^kd-tree, .* speed-up$"],              rows (their keys, joined by a comma) that show measured times
       "rows": "common"}}}                               a draft may have rows that the report lacks
Columns named time are never compared; failures and trials are compared as a rate.
"""

import csv
import json
import math
import re
from dataclasses import dataclass, field

from course_lib.errors import CourseError
from course_lib.paths import ROOT, shown
from course_lib.png import read_png, worst_block

DEFAULTS = {"relative": 1e-6, "absolute": 0.0, "block": 2.0}
KEYS = (("method", "setting"), ("method", "case"), ("method", "triangles"))
SIGMAS = 6  # false alarm of a rate below 1e-8


@dataclass
class Tolerances:
    """What check.json says of a chapter."""

    general: dict = field(default_factory=lambda: dict(DEFAULTS))
    files: dict = field(default_factory=dict)

    @classmethod
    def of(cls, chapter, root=ROOT):
        path = root / "chapters" / chapter / "check.json"
        if not path.exists():
            return cls()
        try:
            stated = json.loads(path.read_text())
        except ValueError as error:
            raise CourseError(f"{shown(path)}: is no JSON ({error}); correct it") from None
        return cls({**DEFAULTS, **{name: stated[name] for name in DEFAULTS if name in stated}}, stated.get("files", {}))

    def of_file(self, name):
        return self.files.get(name, {})

    def of_column(self, name, column):
        """(relative, absolute) of one column of a CSV file."""
        layers = [self.general, self.of_file(name), self.of_file(name).get("columns", {}).get(column, {})]
        merged = {key: value for layer in layers for key, value in layer.items()}
        return merged["relative"], merged["absolute"]


def number(text):
    """The number that a cell holds; None for other text."""
    try:
        return float(text)
    except ValueError:
        return None


def close(one, other, relative, absolute):
    if math.isnan(one) or math.isnan(other):
        return math.isnan(one) and math.isnan(other)
    if math.isinf(one) or math.isinf(other):
        return one == other
    return abs(one - other) <= max(absolute, relative * max(abs(one), abs(other)))


def same_rate(failures, trials, other_failures, other_trials):
    """Whether two counts may come from one rate: the difference of the rates lies in a binomial band."""
    if min(trials, other_trials) <= 0:
        return trials == other_trials
    pooled = (failures + other_failures) / (trials + other_trials)
    scale = 1 / trials + 1 / other_trials
    band = SIGMAS * math.sqrt(pooled * (1 - pooled) * scale) + scale
    return abs(failures / trials - other_failures / other_trials) <= band


def read_table(path):
    with path.open(newline="") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    return reader.fieldnames or [], rows


def key_columns(columns):
    """The columns that name a row; none when rows are told apart by their order only."""
    for keys in KEYS:
        if all(key in columns for key in keys):
            return keys
    return ()


def row_name(row, keys):
    return ", ".join(row[key] for key in keys)


def compare_tables(committed, fresh, tolerances):
    """What differs between two CSV files, one line a difference; `committed` says the file's name."""
    name = committed.name
    columns, old_rows = read_table(committed)
    new_columns, new_rows = read_table(fresh)
    if columns != new_columns:
        return [f"{name}: its columns are {','.join(columns)}, now {','.join(new_columns)}"]
    keys = key_columns(columns)
    if not keys:
        return compare_by_order(name, columns, old_rows, new_rows, tolerances)
    old = {tuple(row[key] for key in keys): row for row in old_rows}
    found, common = [], 0
    timed = tolerances.of_file(name).get("timed", [])
    for row in new_rows:
        other = old.get(tuple(row[key] for key in keys))
        if any(re.search(pattern, row_name(row, keys)) for pattern in timed):
            continue
        if other is not None:
            common += 1
            found += compare_rows(name, row_name(row, keys), columns, keys, other, row, tolerances)
        elif tolerances.of_file(name).get("rows") != "common":
            found.append(f"{name}: no row {row_name(row, keys)}")
    if common == 0:
        found.append(f"{name}: no row in common with a draft")
    return found


def compare_by_order(name, columns, old_rows, new_rows, tolerances):
    if len(old_rows) != len(new_rows):
        return [f"{name}: {len(old_rows)} rows, now {len(new_rows)}"]
    return [difference for index, (old, new) in enumerate(zip(old_rows, new_rows), start=1)
            for difference in compare_rows(name, f"row {index}", columns, (), old, new, tolerances)]


def compare_rows(name, row, columns, keys, old, new, tolerances):
    found = []
    left_out = {*keys, "time", *tolerances.of_file(name).get("ignore", [])}
    if "failures" in columns and "trials" in columns:
        left_out |= {"failures", "trials"}
        counts = [float(line[column]) for line in (old, new) for column in ("failures", "trials")]
        if not same_rate(*counts):
            found.append(f"{name}: {row}: {old['failures']} of {old['trials']} failed, "
                         f"now {new['failures']} of {new['trials']}")
    for column in columns:
        if column not in left_out and not same_cell(old[column], new[column], *tolerances.of_column(name, column)):
            found.append(f"{name}: {row}: {column} is {old[column]}, now {new[column]}")
    return found


def same_cell(one, other, relative, absolute):
    if one == other:
        return True
    numbers = number(one), number(other)
    return None not in numbers and close(*numbers, relative, absolute)


def compare_pictures(committed, fresh, tolerances):
    """What differs between two pictures by more than the tolerance; nothing when they are the same."""
    if committed.read_bytes() == fresh.read_bytes():
        return []
    old, new = read_png(committed), read_png(fresh)
    if (old.width, old.height, old.channels) != (new.width, new.height, new.channels):
        return [f"{committed.name}: {old.width}x{old.height} pixels of {old.channels} channels, "
                f"now {new.width}x{new.height} of {new.channels}"]
    difference, place = worst_block(old, new)
    if difference <= tolerances.general["block"]:
        return []
    return [f"{committed.name}: the block at {place[0]},{place[1]} differs by {difference:.1f} of 255"]
