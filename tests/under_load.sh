#!/usr/bin/env bash
# A verdict doesn't depend on what else the machine does. Judges our solutions all at once, then sixteen times section 5's,
# then answers that loop or sleep, four at once, beside five busy loops a core, and compares each verdict with the one of a
# quiet machine, byte for byte. At last all variants, eight times at once.
#
#     tests/under_load.sh [ROUNDS]      a round takes a minute or two on two cores, and the end five; needs ./course test --all
set -u
cd "$(dirname "$0")/.." || exit 2
rounds=${1:-20}
work=$(mktemp -d)
busy=()
quieten() { [ ${#busy[@]} = 0 ] || kill "${busy[@]}" 2>/dev/null; wait "${busy[@]}" 2>/dev/null; busy=(); }
trap 'quieten; rm -rf "$work"' EXIT

# Section 7's first function, with a statement in front of all that it does.
spoilt() {
    awk -v first="$2" '{ print } /^std::optional<LineIntersection> intersect_lines\(/ { print first }' solutions/07_*.cpp >"$work/$1"
    sed -i '1i #include <unistd.h>' "$work/$1"
}
spoilt loops.cpp 'for (volatile int forever = 1; forever != 0;) {}'
spoilt sleeps.cpp '::sleep(1000);'

# judge NAME SECTION FILE: leaves the verdict and its exit code in NAME.
judge() { ./course check "$2" --file "$3" >"$work/$1" 2>&1; echo "exit code $?" >>"$work/$1"; }
number() { local name=${1##*/}; echo $((10#${name%%_*})); }
same() { cmp -s "$work/quiet.$2" "$work/$1" || { differences=$((differences + 1)); cp "$work/$1" "$work/different.$differences"; }; judged=$((judged + 1)); }

./course check 1 --file solutions/01_motion.cpp >/dev/null || exit 2
for solution in solutions/*.cpp; do judge "quiet.$(number "$solution")" "$(number "$solution")" "$solution"; done
for answer in loops sleeps; do judge "quiet.$answer" 7 "$work/$answer.cpp"; done
grep -L 'exit code 0' "$work"/quiet.[0-9]* | grep . && { echo 'these fail on a quiet machine'; exit 1; }

judged=0 differences=0
for ((round = 1; round <= rounds; ++round)); do
    for ((loop = 0; loop < 5 * $(nproc); ++loop)); do
        while :; do :; done &
        busy+=($!)
    done
    jobs=()
    for solution in solutions/*.cpp; do
        n=$(number "$solution")
        judge "all.$n" "$n" "$solution" & jobs+=($!)
    done
    wait "${jobs[@]}"
    for solution in solutions/*.cpp; do same "all.$(number "$solution")" "$(number "$solution")"; done
    jobs=()
    for copy in {1..16}; do judge "copy.$copy" 5 solutions/05_*.cpp & jobs+=($!); done
    wait "${jobs[@]}"
    for copy in {1..16}; do same "copy.$copy" 5; done
    jobs=()
    for answer in loops sleeps; do for copy in 1 2; do judge "$answer.$copy" 7 "$work/$answer.cpp" & jobs+=($!); done; done
    wait "${jobs[@]}"
    for answer in loops sleeps; do for copy in 1 2; do same "$answer.$copy" "$answer"; done; done
    quieten
    echo "round $round: $judged judged by now, $differences different"
done
[ "$differences" = 0 ] || { cat "$work/different.1"; exit 1; }

build=${COURSE_BUILD:-build/default}
for list in "$build"/answers/*.txt; do
    section=$(basename "$list" .txt)
    grep '^right_' "$list" >"$work/right"
    jobs=()
    for copy in {1..8}; do
        "$build/author/$section" "$build/subjects/$section/answers" --answers "$work/right" >"$work/right.$copy" & jobs+=($!)
    done
    for copy in {1..8}; do wait "${jobs[copy - 1]}" || { cat "$work/right.$copy"; exit 1; }; done
    echo "$section: $(tail -n 1 "$work/right.1"), eight times at once"
done
