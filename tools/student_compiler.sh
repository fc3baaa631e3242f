#!/bin/sh
# The compiler of a student's tree: student_compiler.sh COMPILER ARGUMENT...
#
# At first it is as strict as everywhere, with the very same command, so that ccache knows a file from any other tree.
# What fails is compiled once more, with warnings that are no errors: a stub leaves parameters and helpers unused, and a
# warning that only the grader's compiler gives must not cost all points.
if output=$("$@" 2>&1); then
    [ -z "$output" ] || printf '%s\n' "$output" >&2
    exit 0
fi
exec "$@" -Wno-error -Wno-unused-parameter -Wno-unused-variable -Wno-unused-function -Wno-unused-but-set-variable
