#!/bin/sh
# The compiler behind ccache: compiler.sh TREE CCACHE COMPILER ARGUMENT...
#
# Paths relative to the tree let a student's tree, the gates and the mutants share what is compiled once. pcg-cpp's header
# spells the time of day, for a seed that we never ask for: without time_macros ccache would know no file with random
# numbers again. pch_defines: no macro of a command line hides in a precompiled header. Such a header is known by a sum
# of what it was made of: two compilations of it differ in bytes, and 150 MB take longer to read than many a file to compile.
export CCACHE_BASEDIR="$1" CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1
shift
made=
for word; do
    case $word in
    *.gch) made=$word ;;
    *.gch.d) opened=$word ;;
    esac
done
[ -n "$made" ] || exec "$@"

rm -f "$made" "$made.sum"  # an older one would be read while the new one is made
"$@" || exit
command -v sha256sum >/dev/null || exit 0 # then ccache reads it all
{
    printf '%s\n' "$@" | grep -v /
    sed 's/^[^:]*://; s/\\$//' "$opened" | xargs cat
} | sha256sum >"$made.sum"
