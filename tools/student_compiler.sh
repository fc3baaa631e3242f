#!/bin/sh
# The compiler of a student's tree: student_compiler.sh COMPILER ARGUMENT...
#
# At first it is as strict as everywhere, with the very same command, so that ccache knows a file from any other tree.
# What fails is compiled once more, with warnings that are no errors: a stub leaves parameters and helpers unused, and a
# warning that only the grader's compiler gives must not cost all points. A file with a stub would fail at first, each
# time anew, for ccache keeps no failures: it is compiled that way at once.
lenient="-Wno-error -Wno-unused-parameter -Wno-unused-variable -Wno-unused-function -Wno-unused-but-set-variable"
for word; do
    case $word in
    *.cpp) ! grep -qs '^ *throw NotImplemented("ex-' "$word" || exec "$@" $lenient ;;
    esac
done
if output=$("$@" 2>&1); then
    [ -z "$output" ] || printf '%s\n' "$output" >&2
    exit 0
fi
exec "$@" $lenient
