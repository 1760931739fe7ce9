#!/bin/sh
# Gradescope starts this once, when the image is built: it installs what the course needs, and grades our own solution, which
# must earn all points. If anything here fails, so does the image.
set -eu
at=${AUTOGRADER:-/autograder}
sh "$at/source/course/course" setup --yes
rehearsal=$(mktemp -d)
trap 'rm -rf "$rehearsal"' EXIT
mkdir "$rehearsal/submission" "$rehearsal/results"
ln -s "$at/source" "$rehearsal/source"
cp "$at/source/course/solutions/$(cat "$at/source/section").cpp" "$rehearsal/submission"
AUTOGRADER="$rehearsal" sh "$at/source/run_autograder"
if grep -q '"status": "failed"' "$rehearsal/results/results.json"; then
    cat "$rehearsal/results/results.json"
    echo "setup.sh: our own solution has not all points here, so nobody's would be right" >&2
    exit 1
fi
