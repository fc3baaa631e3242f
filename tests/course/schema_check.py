"""Checks JSON and XML against the schemas of tests/course/schemas, with Debian's python3-jsonschema and libxml2-utils."""

import json
import subprocess
from pathlib import Path

SCHEMAS = Path(__file__).resolve().parent / "schemas"
# Debian's package belongs to Debian's Python, whichever Python runs the tests.
PYTHON = "/usr/bin/python3"
VALIDATE = """
import json, sys, jsonschema
schema, data = (json.load(open(path)) for path in sys.argv[1:])
jsonschema.Draft7Validator.check_schema(schema)
for error in jsonschema.Draft7Validator(schema).iter_errors(data):
    print("/".join(map(str, error.absolute_path)) + ": " + error.message)
"""


def json_errors(path, schema):
    """What is wrong with a JSON file by a schema, one line each."""
    checked = subprocess.run([PYTHON, "-c", VALIDATE, str(SCHEMAS / schema), str(path)], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True)
    assert checked.returncode == 0, checked.stderr
    return checked.stdout.splitlines()


def xml_errors(path, schema):
    checked = subprocess.run(["xmllint", "--noout", "--schema", str(SCHEMAS / schema), str(path)],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert checked.returncode in (0, 3), checked.stdout
    return [] if checked.returncode == 0 else checked.stdout.splitlines()


def read(path):
    return json.loads(Path(path).read_text())
