"""Mutant schemata: all mistakes of a body compiled into one file, which chooses by a number at run time."""

import re
from dataclasses import dataclass

from strip import lines_of

HEADER = "mutation_choice.h"
VARIABLE = "CAUSTIC_MUTATION"
REFERENCE = 0
STOP = -1  # ends the program where the body is entered
STOPPED = 77  # its exit code then
FIRST = 1

CHOICE = f"""#pragma once

#include <concepts>
#include <cstdlib>
#include <type_traits>

// What mutants call. Only builds of mutants see this header.
namespace mutation {{

/// The number of the body that is to be run: 0 is the reference's, -1 ends the program where the body is entered.
inline int choice() {{
    static const int chosen = [] {{
        const char* word = std::getenv("{VARIABLE}");
        return word == nullptr ? {REFERENCE} : std::atoi(word);
    }}();
    return chosen;
}}

template <typename T>
concept Floating = std::floating_point<std::remove_cvref_t<T>>;

/// Eigen's expressions; the header does without Eigen's, for a course may.
template <typename T>
concept Dense = requires(const T& x) {{ typename T::PlainObject; x.template cast<float>(); }};

/// Colours are arrays, and only vectors have a norm.
template <typename T>
concept ArrayOf = Dense<T> && !requires(const T& x) {{ x.norm(); }};

/// Through memory: GCC 12 makes x of static_cast<double>(static_cast<float>(x)) where it vectorises.
template <Floating T>
T narrowed(T x) {{
    const volatile float narrow = static_cast<float>(x);
    return static_cast<T>(narrow);
}}
template <Dense T>
typename T::PlainObject narrowed(const T& x) {{
    return x.unaryExpr([](typename T::Scalar one) {{ return narrowed(one); }});
}}

template <Floating T>
T unsignedOf(T x) {{ return x < 0 ? -x : x; }}
template <Dense T>
typename T::PlainObject unsignedOf(const T& x) {{ return x.cwiseAbs(); }}
template <ArrayOf T>
typename T::PlainObject unsignedOf(const T& x) {{ return x.abs(); }}

template <ArrayOf T>
typename T::PlainObject firstChannel(const T& x) {{
    const typename T::PlainObject all = x;
    return T::PlainObject::Constant(all.size() > 0 ? all(0) : 0);
}}

template <typename T>
const auto& directionOf(const T& x) {{
    if constexpr (requires {{ x.direction; }}) return x.direction;
    else return x;
}}

/// A value that is 5 % too large when x and z of the direction have different signs and y is positive.
template <typename T, typename D>
auto offInOctant(const T& value, const D& direction) {{
    const auto& d = directionOf(direction);
    const bool here = d.x() * d.z() < 0 && d.y() > 0;
    if constexpr (Floating<T>) return here ? value * T(1.05) : value;
    else return typename T::PlainObject(value * (here ? 1.05 : 1.0));
}}

}}  // namespace mutation
"""


@dataclass(frozen=True)
class Schema:
    """A file in which an exercise's body is many."""

    text: str
    lines: tuple  # for each mutant the (first, last) line of its function in the text, counted from 1


def make_schema(target, mutants):
    """Number FIRST + i chooses mutants[i], and the number behind the last the reference's body once more."""
    lines = lines_of(target.source)
    exercise = target.exercise
    out = [f'#include "{HEADER}"\n', *lines[:exercise.first]]
    out.append(f"    if (mutation::choice() == {STOP}) std::_Exit({STOPPED});\n    switch (mutation::choice()) {{\n")
    ranges = []
    for number, text in enumerate([*(mutant.body for mutant in mutants), target.body], start=FIRST):
        # Functions of their own: one with all bodies in it would take the optimiser for ever.
        out.append(f"    case {number}: return [&]() __attribute__((noinline)) -> {target.result} {{\n")
        head = sum(text.count("\n") for text in out)
        out.append(text)
        ranges.append((head, head + text.count("\n") + 1))
        out.append("    }();\n")
    out.append("    default: break;\n    }\n")
    out.append(target.body)
    out += lines[exercise.last - 1:]
    return Schema("".join(out), tuple(ranges[:-1]))


def blamed(output, path, schema):
    """The indices of the mutants in whose bodies the compiler's errors lie, or whose instances they are."""
    found = set()
    block = []
    pattern = re.compile(re.escape(str(path)) + r":(\d+):")
    for line in output.splitlines():
        # What an error is required from stands above it, from "In instantiation of" on; notes below it tell nothing.
        if " note: " in line:
            continue
        block.append(line)
        if re.search(r"\b(?:fatal )?error: ", line):
            found |= owners([int(n) for text in block for n in pattern.findall(text)], schema)
            block = []
    return found


def owners(numbers, schema):
    return {i for n in numbers for i, (first, last) in enumerate(schema.lines) if first <= n <= last}
