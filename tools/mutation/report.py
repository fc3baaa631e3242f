"""What a run of mutants found, as tables, CSV, JSON, and each escape with its diff."""

import csv
import json

from course_lib.errors import CourseError
from course_lib.terminal import say, table
from mutation.campaign import EQUIVALENT, INVALID, UNTRIED
from mutation.operators import OPERATORS
from mutation.running import CAUGHT, ESCAPED

COLUMNS = ("mistakes", "caught", "escaped", "equivalent", "untried", "caught %", "don't compile")


def numbers_of(mutants, outcomes):
    """The row of some mutants. A mistake is what compiles; a share is of those that aren't equivalent."""
    states = [outcomes.get(m.id, {"state": UNTRIED})["state"] for m in mutants]
    caught, escaped = states.count(CAUGHT), states.count(ESCAPED)
    share = f"{100 * caught / (caught + escaped):.1f}" if caught + escaped else "-"
    return [len(states) - states.count(INVALID), caught, escaped, states.count(EQUIVALENT), states.count(UNTRIED), share,
            states.count(INVALID)]


def rows_by(result, heading, key_of, order):
    """One row for each value of key_of, and their sum."""
    rows = []
    for key in order:
        of_key = [m for m in result.mutants if key_of(m) == key]
        if of_key:
            rows.append([key, *numbers_of(of_key, result.outcomes)])
    rows.append(["all", *numbers_of(result.mutants, result.outcomes)])
    return table(rows, [heading, *COLUMNS], right=range(1, 1 + len(COLUMNS)))


def show(result):
    chapter = result.catalog.chapter
    for mutant in result.of_state(ESCAPED):
        say()
        say(f"escaped: {mutant.place}  {mutant.exercise}  {mutant.operator}  {mutant.id}")
        for sign, text in (("-", mutant.was), ("+", mutant.becomes)):
            for line in text.splitlines():
                say(f"    {sign} {line}")
    say()
    say(f"{chapter}, by exercise")
    say(rows_by(result, "exercise", lambda m: m.exercise, result.catalog.exercises))
    say()
    say(f"{chapter}, by operator")
    say(rows_by(result, "operator", lambda m: m.operator, OPERATORS))
    say()
    for complaint in result.complaints:
        say(f"wrong: {complaint}")


def show_sum(results):
    rows = [[r.catalog.chapter, *numbers_of(r.mutants, r.outcomes)] for r in results]
    everything = [m for r in results for m in r.mutants]
    outcomes = {id: outcome for r in results for id, outcome in r.outcomes.items()}
    rows.append(["all", *numbers_of(everything, outcomes)])
    say(table(rows, ["chapter", *COLUMNS], right=range(1, 1 + len(COLUMNS))))
    say()


def entries(results):
    for result in results:
        for m in result.mutants:
            outcome = result.outcomes.get(m.id, {"state": UNTRIED, "by": "", "how": ""})
            yield {"chapter": result.catalog.chapter, "exercise": m.exercise, "operator": m.operator, "place": m.place,
                   "id": m.id, "outcome": outcome["state"], "by": outcome["by"], "how": outcome["how"],
                   "why": outcome.get("why", ""), "was": m.was, "becomes": m.becomes}


def write_json(results, path):
    write(path, json.dumps(list(entries(results)), indent=1, ensure_ascii=False) + "\n")


def write_csv(results, path):
    """Counts in the benchmarks' columns: method is the operator, case the chapter."""
    rows = [["method", "case", "value", "unit", "reference"]]
    for result in results:
        for operator in OPERATORS:
            of_operator = [m for m in result.mutants if m.operator == operator]
            numbers = dict(zip(COLUMNS, numbers_of(of_operator, result.outcomes)))
            for what in (CAUGHT, ESCAPED, EQUIVALENT):
                if of_operator:
                    rows.append([operator, result.catalog.chapter, numbers[what], what, numbers["mistakes"]])
    lines = []

    class Lines:
        write = staticmethod(lines.append)

    csv.writer(Lines, lineterminator="\n").writerows(rows)
    write(path, "".join(lines))


def write(path, text):
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise CourseError(f"cannot write {path}: {error.strerror}") from None
