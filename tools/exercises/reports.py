"""Grades as a table, as JSON, as Gradescope's results.json and as JUnit XML."""

import json
import os
import re
import xml.etree.ElementTree as xml
from pathlib import Path

from course_lib.errors import CourseError
from course_lib.terminal import count, table
from exercises.verdicts import CRASHED, FAILED, NOT_BUILT, NOT_IMPLEMENTED, REFUSED, TIMED_OUT, TRIED

MOST_REASON = 96
# What XML 1.0 cannot hold, not even escaped.
NOT_IN_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def points_text(points, most):
    return f"{points} of {most} points"


def grade_table(grade):
    """One row a test: test, exercise, points, what became of it.

    The compiler's errors stand once: the first of all beside the table, another one at its exercise's first test.
    """
    said, rows = {grade.error}, []
    for o in grade.outcomes:
        reason = shortened(o.outcome.reason)
        if o.outcome.state == NOT_BUILT and o.outcome.reason in said or is_own_stub(o):
            reason = ""
        said.add(o.outcome.reason)
        rows.append([shown_name(o.test), o.test.exercise, f"{o.points}/{o.test.points}", o.outcome.state, reason])
    return table(rows, ["test", "exercise", "points", "outcome", "reason"], right=(2,))


def shown_name(test):
    return f"{test.name} (hidden)" if test.hidden else test.name


def is_own_stub(graded):
    """Whether a test met the stub of its own exercise, of which there is no more to say."""
    return graded.outcome.state == NOT_IMPLEMENTED and f"exercise {graded.test.exercise} is not" in graded.outcome.reason


def shortened(text):
    return text if len(text) <= MOST_REASON else text[:MOST_REASON - 3] + "..."


def summary(grade):
    return f"{grade.chapter}: {points_text(grade.points, grade.catalog.points)}"


def public_summary(grade):
    """The points of the tests that a student may see."""
    seen = [o for o in grade.outcomes if not o.test.hidden]
    return f"{grade.chapter}: {points_text(sum(o.points for o in seen), sum(o.test.points for o in seen))}"


def details(graded):
    """Everything that a student should see of one test, in several lines."""
    outcome = graded.outcome
    reason = f": {outcome.reason}" if outcome.reason and not is_own_stub(graded) else ""
    lines = [f"{graded.test.exercise}: {outcome.state}{reason}"]
    for failure in outcome.failures:
        if failure["message"] == outcome.reason and not failure["place"]:
            continue
        lines.append("")
        if failure["place"]:
            lines.append(failure["place"])
        lines.append(failure["message"])
        if failure["times"] > 1:
            lines.append(f"(the first of {failure['times']} failures on this line)")
    if outcome.state in TRIED:
        lines += ["", f"Look at: {graded.test.look_at}"]
        if outcome.state in (CRASHED, TIMED_OUT) and outcome.output.strip():
            lines += ["", "It printed:", outcome.output.strip()]
    return "\n".join(lines)


def to_json(grades, submission, on_reference, sandbox):
    return {
        "submission": submission,
        "sandbox": sandbox,
        "onReference": on_reference,
        "points": sum(grade.points for grade in grades),
        "maxPoints": sum(grade.catalog.points for grade in grades),
        "chapters": [chapter_json(grade) for grade in grades],
    }


def chapter_json(grade):
    return {
        "chapter": grade.chapter,
        "points": grade.points,
        "maxPoints": grade.catalog.points,
        "built": not grade.error,
        "error": grade.error,
        "notes": grade.notes,
        "looks": grade.looks,
        "exercises": {id: {"points": sum(o.points for o in grade.of_exercise(id)),
                           "maxPoints": sum(o.test.points for o in grade.of_exercise(id))} for id in grade.catalog.exercises},
        "tests": [{
            "name": o.test.name,
            "hidden": o.test.hidden,
            "exercise": o.test.exercise,
            "points": o.points,
            "maxPoints": o.test.points,
            "outcome": o.outcome.state,
            "reason": o.outcome.reason,
            "failures": o.outcome.failures,
            "output": o.outcome.output,
            "seconds": round(o.outcome.seconds, 3),
        } for o in grade.outcomes],
    }


def to_gradescope(grades, sandbox):
    """https://gradescope-autograders.readthedocs.io/en/latest/specs/ : results.json."""
    tests = []
    for grade in grades:
        for position, o in enumerate(grade.outcomes, start=1):
            tests.append({
                "name": o.test.name,
                "number": f"{int(grade.catalog.number)}.{position}",
                "score": o.points,
                "max_score": o.test.points,
                "status": "passed" if o.outcome.passed else "failed",
                "output": details(o),
                "output_format": "text",
                "tags": [grade.chapter, o.test.exercise],
                "visibility": "hidden" if o.test.hidden else "visible",
            })
    lines = [line for grade in grades for line in [public_summary(grade), *errors_and_notes(grade)]] + [f"sandbox: {sandbox}"]
    return {
        "score": sum(grade.points for grade in grades),
        "output": "\n".join(lines),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "execution_time": round(sum(o.outcome.seconds for grade in grades for o in grade.outcomes)),
        "tests": tests,
    }


def errors_and_notes(grade):
    refused = all(o.outcome.state == REFUSED for o in grade.outcomes)
    error = f"{REFUSED if refused else NOT_BUILT}: {grade.error}"
    return ([line for line in (error, excerpt_after(grade)) if line] if grade.error else []) + [f"note: {n}" for n in grade.notes]


def excerpt_after(grade):
    """What the compiler said, without the line that is the error itself."""
    first, _, rest = grade.excerpt.partition("\n")
    return rest if first.strip() == grade.error else grade.excerpt


def to_junit(grades, sandbox):
    """JUnit's XML as Jenkins and GitLab read it: a suite a chapter; failures are assertions, errors all else."""
    suites = xml.Element("testsuites", name="caustic")
    for grade in grades:
        states = [o.outcome.state for o in grade.outcomes]
        failures = sum(state in (FAILED, NOT_IMPLEMENTED) for state in states)
        errors = sum(not o.outcome.passed for o in grade.outcomes) - failures
        suite = xml.SubElement(suites, "testsuite", name=grade.chapter, tests=str(len(states)), failures=str(failures),
                               errors=str(errors), skipped="0", time=f"{sum(o.outcome.seconds for o in grade.outcomes):.3f}")
        properties = xml.SubElement(suite, "properties")
        xml.SubElement(properties, "property", name="points", value=str(grade.points))
        xml.SubElement(properties, "property", name="maxPoints", value=str(grade.catalog.points))
        xml.SubElement(properties, "property", name="sandbox", value=sandbox)
        for o in grade.outcomes:
            add_case(suite, grade, o)
    return xml.tostring(suites, encoding="utf-8", xml_declaration=True)


def add_case(suite, grade, graded):
    outcome = graded.outcome
    case = xml.SubElement(suite, "testcase", name=graded.test.name, classname=f"{grade.chapter}.{graded.test.exercise}",
                          time=f"{outcome.seconds:.3f}")
    if not outcome.passed:
        kind = "failure" if outcome.state in (FAILED, NOT_IMPLEMENTED) else "error"
        element = xml.SubElement(case, kind, message=for_xml(outcome.reason or outcome.state), type=outcome.state)
        element.text = for_xml(details(graded))
    if outcome.output:
        xml.SubElement(case, "system-out").text = for_xml(outcome.output)


def for_xml(text):
    return NOT_IN_XML.sub("\N{REPLACEMENT CHARACTER}", text)


def write_file(path, content):
    """Through a temporary file, so that no half report is left; straight into a device or a pipe.

    @throws CourseError when it cannot be written
    """
    path = Path(path)
    data = content if isinstance(content, bytes) else (json.dumps(content, indent=2) + "\n").encode()
    temporary = path.with_name(path.name + ".tmp")
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            path.write_bytes(data)  # root could replace even /dev/stdout
            return
        temporary.write_bytes(data)
        os.replace(temporary, path)
    except OSError as error:
        raise CourseError(f"{path} cannot be written: {error.strerror}; name a file in a folder that is there") from None


def remove_file(path):
    """Removes a report of an earlier run; a device or a pipe stays, and so does no path at all.

    @throws CourseError when it cannot be removed
    """
    if path is None or not (Path(path).is_file() or Path(path).is_symlink()):
        return
    try:
        Path(path).unlink()
    except OSError as error:
        raise CourseError(f"{path} cannot be replaced: {error.strerror}; name another file") from None


def done_text(grades):
    """"3 of 12 exercises done"."""
    done = sum(len(grade.done) for grade in grades)
    return f"{done} of {count(sum(len(grade.catalog.exercises) for grade in grades), 'exercise')} done"
