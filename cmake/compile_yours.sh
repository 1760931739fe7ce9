#!/bin/sh
# compile_yours.sh OBJECT STAND_IN NAMESPACE NM OBJCOPY compiler and its words...
#
# Compiles a student's file for the sections that build on it, where there is no solution. One that doesn't compile mustn't
# keep a later section from being checked: in its place is a stand-in, whose functions say that they aren't started.
# And two files may have a helper of the same name, since each was a program of its own: whatever is outside of the section's
# namespace, which is named as compilers do, 6motion, is made local. (Inline functions are weak already.)
object=$1 stand_in=$2 namespace=$3 nm=$4 objcopy=$5
shift 5
printf '%s:\n' "$object" >"$object.d" # where the compiler doesn't get as far as that
"$@" -o "$object" 2>/dev/null || exec cp "$stand_in" "$object"
"$nm" -g --defined-only "$object" |
    awk -v own="^_?_Z(T[A-Z])?NK?$namespace" '$2 ~ /^[ABDRST]$/ && $3 !~ own { print $3 }' >"$object.local"
[ ! -s "$object.local" ] || exec "$objcopy" --localize-symbols="$object.local" "$object"
