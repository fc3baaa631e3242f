"""Mutants of which the compiler makes the very code that it makes of the reference: no test can tell them apart.

Works on the assembly of a schema's file, in which every body is a function of its own and the reference's comes last.
"""

import re

FUNCTION = re.compile(r"^\t\.type\t(\S+), @function$")
LABEL = re.compile(r"^(\.L\w+|[\w.$]+):")
LOCAL = re.compile(r"\.L[A-Z]*\d+\b")
KEPT_DIRECTIVES = (".long", ".quad", ".value", ".byte", ".string", ".ascii", ".zero")
# The outermost closure in a mangled name is a body. A function's first has no number, its next is 0.
BODY = re.compile(r"UlvE(\d*)_")
CLONE = re.compile(r"\.(constprop|isra|part|cold)\.\d+")


def same_as_last(assembly, bodies):
    """The indices of the bodies with the code of the last of them, in every instance of a template.

    @param bodies  how many there are
    @return nothing when the assembly holds none of them
    """
    functions, data = parts_of(assembly.splitlines())
    by_body = {}
    for name, lines in functions.items():
        match = BODY.search(name)
        if match:
            index = 0 if match[1] == "" else int(match[1]) + 1
            by_body.setdefault(index, {})[anonymous(name)] = normalised(lines, data)
    last = by_body.get(bodies - 1)
    if last is None:
        return None
    return {i for i in range(bodies - 1) if by_body.get(i) == last}


def parts_of(lines):
    """(function -> its instructions and labels, local label -> the data behind it)"""
    names = {match[1] for match in map(FUNCTION.match, lines) if match}
    functions, data = {}, {}
    function, label, in_code = None, None, True
    for line in lines:
        words = line.split(None, 1)
        if line.startswith(("\t.section", "\t.text", "\t.data", "\t.bss")):
            in_code, label = ".text" in words[0] + words[-1].split(",")[0], None
        elif line.startswith("\t.size\t"):
            function = None
        elif LABEL.match(line):
            name = LABEL.match(line)[1]
            if name in names:
                function = functions.setdefault(name, [])
            elif in_code and function is not None:
                function.append(line)
            else:
                label = data.setdefault(name, [])
        elif words and (not words[0].startswith(".") or words[0] in KEPT_DIRECTIVES):
            if in_code and function is not None:
                function.append(line)
            elif label is not None:
                label.append(line)
    return functions, data


def normalised(lines, data):
    """A function's text with its labels numbered as they come, and data in place of its label."""
    numbers = {}

    def renamed(match):
        label = match[0]
        if label in data and label not in numbers:
            numbers[label] = None
            numbers[label] = "[" + ";".join(LOCAL.sub(renamed, line.strip()) for line in data[label]) + "]"
        return numbers.setdefault(label, f"L{len(numbers)}") or "[itself]"

    return [anonymous(LOCAL.sub(renamed, line)) for line in lines]


def anonymous(text):
    """A name that is the same for each body."""
    return CLONE.sub(r".\1", BODY.sub("Ul_", text))
