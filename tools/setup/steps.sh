# shellcheck shell=sh
# How ./course does its steps: one line each, their noise in a log, one build at a time. Read by ./course.
# It knows $root and $build; progress goes to file descriptor 3.

export LC_ALL=C # logs are searched for English words
again="./course${*:+ $*}" # what was typed

# complain CODE SENTENCE: says what to do, and leaves.
complain() {
    printf 'course: %s\n' "$2" >&2
    exit "$1"
}

say() { printf '%s\n' "$*" >&3; }

animated() { [ -t 3 ] && [ "${TERM:-dumb}" != dumb ]; }

ticker=
stop_ticker() {
    [ -z "$ticker" ] && return
    kill -KILL "$ticker" 2>/dev/null # a newborn shell may lose any milder signal
    wait "$ticker" 2>/dev/null
    ticker=
}

# On a terminal, the line of the running step shows the seconds, and ninja's count out of its log.
start_ticker() {
    animated || return 0
    (
        while sleep 1 >/dev/null 3>&-; do
            now=$(date +%s)
            count=$(tail -n 1 "$log" | sed -n 's/.*\(\[[0-9]*\/[0-9]*\]\).*/\1 /p')
            printf '\r\033[K  %-26s%s%s' "$step" "$count" "$(seconds $((now - started)))" >&3
        done
    ) 2>/dev/null 9>&- &
    ticker=$!
}

seconds() {
    if [ "$1" -lt 60 ]; then echo "$1 s"; else echo "$(($1 / 60)) min $(($1 % 60)) s"; fi
}

# Ctrl-C reaches what is running as well; it is waited for, so nothing is left half done.
stopped() {
    stop_ticker
    printf '\nStopped. %s goes on from here.\n' "$again" >&3
    exit 130
}
trap stopped INT
trap 'stop_ticker; exit 143' TERM
trap 'stop_ticker; exit 129' HUP

# try STEP COMMAND...: runs the command with its output in a log; its exit code is the command's.
try() {
    step=$1
    shift
    log=$build/log/$(printf '%s' "$step" | tr ' ' '_').log
    started=$(date +%s)
    printf '  %-26s' "$step" >&3
    start_ticker
    "$@" >"$log" 2>&1 </dev/null
    code=$?
    stop_ticker
    took=$(seconds $(($(date +%s) - started)))
    [ "$code" = 0 ] || took="failed after $took"
    [ -z "$(differences)" ] || took='differs from the code'
    grep -q '^ninja: no work to do' "$log" && took='up to date'
    if animated; then printf '\r\033[K  %-26s' "$step" >&3; fi
    say "$took"
    return "$code"
}

# What the check of the book has found, if that is the step: places, and how they can be put right.
differences() { [ "$step" != book ] || grep -E '^[^ :]+:[0-9]+: |^To keep the code as it is' "$log"; }

# must CODE STEP COMMAND...: the same; if it fails, the end of its log is shown, and we leave with CODE.
must() {
    leave=$1
    shift
    try "$@" || give_up "$leave"
}

give_up() {
    if grep -q 'No space left on device' "$log"; then
        complain 4 "the disk is full (seen while writing below $build). Free some space, then type $again"
    fi
    if lacks=$(grep -o 'missing here: .*' "$log"); then # ninja has configured again, with a list of needs that is newer
        complain 2 "$lacks Type ./course, which installs what is missing"
    fi
    grep -v '^\[[0-9]*/[0-9]*\]' "$log" | tail -n 40 >&2 # without the steps of ninja that went well
    room=$(df -Pk "$build" 2>/dev/null | awk 'NR == 2 && $4 < 100000 { print int($4 / 1024) }')
    [ -z "$room" ] || # not every program that a full disk stops says so, and there may be no room for its words
        complain 4 "\"$step\" failed, as shown above, and only $room MB are free below $build, where a build takes hundreds. Free some space, then type $again; the whole log is $log"
    complain "$1" "\"$step\" failed, as shown above; the whole log is $log"
}

# CMake, Ninja, JSON and web pages each give up at one of these signs, and say something else.
require_plain_path() {
    plain=yes
    case $root$build in *[\;\\\"\#\[]* | *'
'*) plain=no ;; esac
    ! command -v iconv >/dev/null || printf '%s' "$root$build" | iconv -f UTF-8 -t UTF-8 >/dev/null 2>&1 || plain=no
    [ "$plain" = yes ] ||
        complain 2 "the path $root has one of ; \\ \" # [ in it, a line break, or letters that aren't UTF-8, and can't be built in. Rename that folder, or move the course, then type $again again"
}

# The build folder, ready to be written to by us alone until we leave.
take_build_folder() {
    require_plain_path
    (mkdir -p "$build/log" && : >>"$build/.lock" && : >>"$build/log/ours") 2>/dev/null ||
        complain 2 "cannot write to the build folder $build. Make it yours, or name another one: COURSE_BUILD=/some/folder $again"
    [ -z "${COURSE_LOCKED-}" ] || return 0 # the process that started us has taken it
    exec 9>>"$build/.lock"
    if ! lock nowait; then
        IFS= read -r owner <"$build/.lock"
        say "Waiting for ${owner:-another ./course}, which is at work in this build folder."
        lock wait || complain 2 "cannot lock $build/.lock. Wait until the other ./course is done, then type $again"
    fi
    printf '%s (process %s)\n' "$again" "$$" >"$build/.lock"
    export COURSE_LOCKED="$$" # for the course program, when it is one of our steps
}

# An flock(2) on file descriptor 9. What we start inherits it: a build that outlives us keeps it to its end.
lock() {
    if command -v flock >/dev/null; then
        if [ "$1" = wait ]; then flock 9; else flock -n 9; fi
    elif command -v perl >/dev/null; then # macOS
        perl -MFcntl=:flock -e 'open(F, ">>&=9") && flock(F, LOCK_EX | ($ARGV[0] eq "wait" ? 0 : LOCK_NB)) or exit 1' "$1"
    fi # without either there is no lock, and one build at a time is up to you
}

leave_build_folder() {
    : >"$build/.lock"
    exec 9>&-
    unset COURSE_LOCKED
}

# A file dated tomorrow, by a clock that was wrong, would be newer than all that is built from it, and built again each
# time: it is dated now.
date_back() {
    : >"$build/.now"
    (cd "$root" && find . \( -name build -o -name .git -o -name node_modules \) -prune -o -type f -newer "$build/.now" \
        -exec touch -r "$build/.now" {} + ) 2>/dev/null # as far as they are ours
}

# Configures, unless that is done; anything later ninja sees to.
configure() {
    date_back
    stale=
    if [ -f "$build/CMakeCache.txt" ]; then
        home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
        if [ "$(CDPATH='' cd -- "$home" 2>/dev/null && pwd -P)" != "$root" ]; then
            case $build in "$root"/*) ;; *)
                [ ! -e "$home/course" ] ||
                    complain 2 "the build folder $build belongs to the checkout $home. Name another one: COURSE_BUILD=/some/folder $again"
                ;;
            esac
            stale=--fresh # the checkout has moved, or been copied
        fi
    fi
    if [ -z "$stale" ] && [ -f "$build/build.ninja" ] && [ -f "$build/.configured" ] &&
        [ -z "$(find "$root/CMakePresets.json" -newer "$build/.configured")" ]; then
        return
    fi
    have_tools
    : >"$build/.configuring"
    must 3 configuring in_checkout cmake --preset default -B "$build" $stale
    mv "$build/.configuring" "$build/.configured"
}

in_checkout() { (cd "$root" && exec "$@"); }

# target CODE STEP TARGET: one target of the build.
target() { must "$1" "$2" cmake --build "$build" --target "$3"; }

make_the_program() {
    printf '%s\n' "$root" >"$stamp.new"
    target 3 'the course program' course-tool
    mv "$stamp.new" "$stamp"
}

# For a command that needs no more than the program.
bring_up_the_program() {
    take_build_folder
    configure
    make_the_program
    leave_build_folder
}
