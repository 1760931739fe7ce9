#!/bin/sh
# The script ./course and its decisions, on machines made of fakes: what it would install, from where, in which order it
# builds, what it says when something is wrong, and with which code it leaves. The real thing: tests/fresh_machine.sh.
# Usage: course_script_test.sh [CHECKOUT]
set -u
checkout=$(cd "${1:-$(dirname "$0")/../..}" && pwd -P)
lab=$(cd "$(mktemp -d)" && pwd -P)
trap 'rm -rf "$lab"' EXIT
checks=0
failures=0

# ---- a machine: tools in bin/, what CMake finds in found, apt's answers in files -------------------------------------

machine() { # machine CLAIM: a new one, with everything installed, nothing built
    claim=$1
    rm -rf "${lab:?}"/*
    tree="$lab/frame by frame"
    build="$tree/build/default"
    bin=$lab/bin
    mkdir -p "$tree/tools/setup" "$tree/tools/commands" "$tree/cmake" "$tree/chapters" "$bin" "$lab/sources"
    cp "$checkout/course" "$tree/"
    cp "$checkout"/tools/setup/* "$tree/tools/setup/"
    echo '{}' >"$tree/CMakePresets.json"
    : >"$tree/CMakeLists.txt"
    : >"$tree/chapters/course.hpp"
    for tool in sh env cat sed awk grep cut head tail tr paste mkdir mv rm cp ls find date sleep sort install readlink flock touch getconf mktemp tr iconv; do
        ln -s "$(command -v "$tool")" "$bin/$tool" 2>/dev/null
    done

    fake id 'echo "$FAKE_ID"'
    fake ctest 'echo "ctest: $*"; exit "${FAKE_CTEST:-0}"'
    sed -n '/^[^#]/s/|.*/|fine|99/p' "$checkout/tools/setup/needs" >"$lab/found"
    fake cmake '
        case "$*" in
        *-DCOURSE_LOOK=ON*) [ ! -e "$LAB/found" ] || cp "$LAB/found" "$4/found" ;;
        *--preset*) echo "cmake: $*" >>"$LAB/did"
            for build; do :; done
            [ "$build" != --fresh ] || { echo fresh >>"$LAB/did"; build="$LAB/frame by frame/build/default"; }
            [ ! -e "$LAB/fails.configure" ] || { echo the configuring went wrong; exit 1; }
            echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"$build/CMakeCache.txt"; : >"$build/build.ninja" ;;
        *--build*) build=$2; target=${4:-all}; echo "build $target" >>"$LAB/did"
            [ ! -e "$LAB/slow.$target" ] || { : >"$LAB/slowly"; sleep 1.2; }
            [ ! -e "$LAB/fails.$target" ] || { cat "$LAB/fails.$target"; exit 1; }
            if [ "$target" = course-tool ]; then
                printf "%s\n" "#!/bin/sh" "printf \"tool\"" "printf \" [%s]\" \"\$@\"" "echo; exit \${FAKE_TOOL:-0}" >"$build/course-tool"
                chmod +x "$build/course-tool"
            fi ;;
        esac'
    ln -s "$(command -v chmod)" "$bin/chmod"
}

fake() {
    printf '#!/bin/sh\n%s\n' "$2" >"$bin/$1"
    chmod +x "$bin/$1"
}

# with_apt: Debian 12 as it comes. `install` brings the tools back that `without` took away.
with_apt() {
    fake apt-config "echo \"folder='$lab/sources/'\""
    fake apt-cache 'sed -n "s/^$2 /$2:\n  Candidate: /p" "$LAB/offers"'
    fake apt-get '
        case "$*" in *indextargets*) [ ! -e "$LAB/targets" ] || cat "$LAB/targets"; exit ;; esac
        echo "apt-get $*" >>"$LAB/did"
        [ ! -e "$LAB/fails.apt" ] || { cat "$LAB/fails.apt" >&2; exit 100; }
        case "$*" in
        *update*frame-by-frame*) cp "$LAB"/sources/frame-by-frame* "$LAB/source.seen"
            [ -e "$LAB/no-backports" ] || echo "libcatch2-dev 3.7.1-0.4~bpo12+1" >>"$LAB/offers" ;;
        *update*) [ ! -e "$LAB/offers.later" ] || mv "$LAB/offers.later" "$LAB/offers"
            [ ! -e "$LAB/targets.later" ] || mv "$LAB/targets.later" "$LAB/targets" ;;
        *--download-only*) ;;
        *install*) sed "s/|.*/|fine|99/" "$LAB/all" >"$LAB/found" ;;
        esac'
    cat >"$lab/offers" <<'END'
g++ 4:12.2.0-3
cmake 3.25.1-1
ninja-build 1.11.1-2
libeigen3-dev 3.4.0-4
catch2 2.13.10-1
libcli11-dev 2.1.2
nlohmann-json3-dev 3.11.2-2
libfmt-dev 9.1.0+ds1-2
libcmark-gfm-dev 0.29.0.gfm.6-6
libpugixml-dev 1.13-0.2
libzip-dev 1.7.3-1
gnuplot-nox 5.4.4
graphviz 2.42.2-7
doxygen 1.9.4-4
nodejs 18.20.4+dfsg-1
libjs-katex 0.16.4+~cs6.1.0-1
libjs-lunr 2.3.9~dfsg-2
END
    targets "$lab/sources/debian.sources:1"
    cat >"$lab/sources/debian.sources" <<'END'
Types: deb deb-src
URIs: http://mirror.example/debian
Suites: bookworm bookworm-updates
Components: main contrib
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
}

targets() { # where apt says that its lists come from: a third party's entry first
    cat >"$lab/targets" <<END
Chromium|main|Packages|stable|http://third.example/chromium|$lab/sources/third.list:1
Debian|main|Translations|bookworm|http://mirror.example/debian|$1
Debian|main|Packages|bookworm-updates|http://mirror.example/debian|$1
Debian|main|Packages|bookworm|http://mirror.example/debian|$1
END
}

offers() { # offers PACKAGE VERSION: the release has this one
    { grep -v "^$1 " "$lab/offers"; echo "$1 $2"; } >"$lab/offers.new"
    mv "$lab/offers.new" "$lab/offers"
}

without() { # without NAME...: CMake does not find it
    for name; do has_only "$name" 'missing|'; done
}
has_only() { # has_only NAME VERDICT: what CMake says of it
    cp "$lab/found" "$lab/all"
    sed "s/^$1|.*/$1|$2/" "$lab/all" >"$lab/found"
}

# course ARGUMENT...: types it there; what it says is in $out and $err, its code in $code.
course() {
    (cd "$tree" && env -i PATH="$bin" HOME="$lab" LAB="$lab" FAKE_ID="${who:-0}" FAKE_TOOL="${tool_leaves:-0}" \
        FAKE_CTEST="${ctest_leaves:-0}" COURSE_BUILD="${elsewhere-}" ./course "$@") >"$lab/${mine-}out" 2>"$lab/${mine-}err" </dev/null
    code=$?
    echo "$code" >"$lab/${mine-}code"
    out=$(cat "$lab/${mine-}out")
    err=$(cat "$lab/${mine-}err")
    did=$(cat "$lab/did" 2>/dev/null)
    rm -f "$lab/did"
}

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s: %s\n--- out\n%s\n--- err\n%s\n--- did\n%s\n\n' "$claim" "$1" "$out" "$err" "$did"
}
leaves_with() { checks=$((checks + 1)); [ "$code" = "$1" ] || fail "left with $code instead of $1"; }
has() { # has TEXT PART
    checks=$((checks + 1))
    case $1 in *"$2"*) ;; *) fail "lacks \"$2\"" ;; esac
}
has_not() {
    checks=$((checks + 1))
    case $1 in *"$2"*) fail "has \"$2\"" ;; esac
}
is() { # is GOT WANT
    checks=$((checks + 1))
    [ "$1" = "$2" ] || fail "got:
$1
instead of:
$2"
}

# ---- bringing it up ----------------------------------------------------------------------------------------------

machine 'with all tools, ./course configures and builds in order'
course
leaves_with 0
is "$did" "cmake: --preset default -B $build
build course-tool
build programs
build section-tests
build figures
build book
build site"
has "$out" 'site/index.html'
has "$out" './course check'
course
has_not "$did" preset
is "$err" ''

claim='the program gets its arguments as they are, and its exit code is kept'
tool_leaves=1
course check 'a b' ''
leaves_with 1
is "$out" 'tool [check] [a b] []'
is "$did" ''
tool_leaves=0

claim='a newer source builds the program again, and only that; standard output stays the command'"'"'s'
touch -d '+2 seconds' "$tree/tools/commands/new.cpp" 2>/dev/null || { sleep 1; touch "$tree/tools/commands/new.cpp"; }
course list
is "$out" 'tool [list]'
is "$did" 'build course-tool'
has "$err" 'the course program'

claim='a source dated tomorrow is built once, and not with every command'
touch -d '+1 day' "$tree/tools/commands/new.cpp"
course list
is "$did" 'build course-tool'
course list
is "$did" ''

claim='presets dated tomorrow are configured with once'
touch -d '+1 day' "$tree/CMakePresets.json"
course list
has "$did" preset
course list
is "$did" ''

claim='without build.ninja any command configures again'
rm "$build/build.ninja"
course list
is "$did" "cmake: --preset default -B $build
build course-tool"
is "$out" 'tool [list]'

claim='help COMMAND is the help of that command'
course help check
is "$out" 'tool [check] [--help]'
course help dev weave
is "$out" 'tool [dev] [weave] [--help]'
course help doctor
leaves_with 0
has "$out" './course doctor'

claim='test: what shows that the course works is built and run, and ctest gets the further arguments'
course test -R 'a b'
leaves_with 0
has "$did" 'build checks'
has "$out" "ctest: --test-dir $build --output-on-failure --no-tests=error --label-exclude ^(slow|thorough|configure|wild)\$ --exclude-regex ^tool-tests -R a b"

claim='test --all: everything is built, all tests run, and a failure of ctest is 1'
ctest_leaves=8
course test --all -R 'a b'
leaves_with 1
has "$did" 'build all'
has "$out" "ctest: --test-dir $build --output-on-failure --no-tests=error -R a b"
ctest_leaves=0

claim='a path that a build cannot have is refused at the start, and named; blanks and other letters are fine'
for odd in 'a;b' 'a\\b' 'a"b' 'a#b' 'a[b' "$(printf 'a\nb')" "$(printf 'a\351b')"; do
    mv "$tree" "$lab/$odd"
    tree=$lab/$odd
    course --yes
    leaves_with 2
    has "$err" "the path $tree has one of"
    has_not "$did" cmake
done
mv "$tree" "$lab/främe by frame"
tree="$lab/främe by frame"
mkdir -p "$lab/frame by frame/build/default" # where the fake cmake writes
course --yes
leaves_with 0
rm -r "$lab/frame by frame"
mv "$tree" "$lab/frame by frame"
tree="$lab/frame by frame"

claim='a checkout that was moved is configured anew'
mv "$tree" "$tree moved"
tree="$tree moved"
mkdir -p "$lab/frame by frame/build/default" # where the fake cmake writes
course list
has "$did" '--fresh'

machine 'the build folder of another checkout is left alone'
course
mkdir "$lab/other"
cp -R "$tree/." "$lab/other/"
tree=$lab/other
elsewhere="$lab/frame by frame/build/default" course check
leaves_with 2
has "$err" "belongs to the checkout $lab/frame by frame"

machine 'a step that fails shows the end of its log, names the log, and stops'
seq 100 >"$lab/fails.figures"
course
leaves_with 3
has "$err" '61
62'
has_not "$err" '60
61'
has "$err" "$build/log/figures.log"
has_not "$did" 'build book'
has_not "$out" 'All is built'
rm "$lab/fails.figures"
echo 'no program was built' >"$lab/fails.book"
course
leaves_with 1
has "$err" 'no program was built'
has_not "$did" 'build site'
echo 'write: No space left on device' >"$lab/fails.programs"
course
leaves_with 4
has "$err" 'the disk is full (seen while'
echo 'ar: unable to copy file; reason: Success' >"$lab/fails.programs"
course
leaves_with 3
fake df 'echo "Filesystem 1024-blocks Used Available Capacity Mounted on"; echo "none 50000 9040 40960 20% /"'
course
leaves_with 4
has "$err" 'reason: Success'
has "$err" 'and only 40 MB are free below'
rm "$bin/df"

machine 'a book that differs from the code, as after a change that a chapter suggests, is told, and stops nothing'
cat >"$lab/fails.book" <<'END'
[1/2] Checking that the book says what the code says
FAILED: book.stamp
cd /somewhere && course-tool dev weave --check
chapters/07/README.md:9: "A wall" differs here from chapters/07/wall.hpp:11.
To keep the code as it is now, type ./course dev weave; to bring back how it was, git restore chapters/07/wall.hpp
ninja: build stopped: subcommand failed.
END
course
leaves_with 0
has "$did" 'build site'
has "$out" '  book                      differs from the code
'
has "$out" 'All is built and drawn. But the book and the code differ:
chapters/07/README.md:9: "A wall" differs here from chapters/07/wall.hpp:11.
To keep the code as it is now, type ./course dev weave; to bring back how it was, git restore chapters/07/wall.hpp

'
has_not "$out" 'checked'
has_not "$out" FAILED
has "$out" 'Next: type ./course open'

machine 'an unwritable build folder is said in one sentence'
: >"$lab/file"
elsewhere=$lab/file course
leaves_with 2
is "$err" "course: cannot write to the build folder $lab/file. Make it yours, or name another one: COURSE_BUILD=/some/folder ./course"

machine 'the version is known before anything is built'
echo 'project(frame_by_frame VERSION 1.2.3 LANGUAGES CXX)' >"$tree/CMakeLists.txt"
course --version
leaves_with 0
is "$out" 'Frame by Frame 1.2.3'
is "$did" ''

machine 'wrong words'
course doctor now
leaves_with 2
has "$err" "./course --help"
course --yes --fast
leaves_with 2
course --help
leaves_with 0
has "$out" './course doctor'
has "$out" 'Type ./course, then'

for locker in flock perl; do
    command -v $locker >/dev/null || continue
    machine "of two at once the second waits, and says for whom ($locker)"
    rm -f "$bin/flock"
    ln -s "$(command -v $locker)" "$bin/$locker"
    : >"$lab/slow.programs"
    (mine=first. course) &
    while [ ! -e "$lab/slowly" ]; do sleep 0.05; done
    course setup
    leaves_with 0
    has "$out" 'Waiting for ./course (process '
    wait
    code=$(cat "$lab/first.code")
    leaves_with 0
done

# ---- what is missing ---------------------------------------------------------------------------------------------

machine 'doctor: all is there'
course doctor
leaves_with 0
is "$(grep -c found "$lab/out")" "$(grep -c '^[^#]' "$checkout/tools/setup/needs")"
has "$out" 'compiler    found 99, need GCC 12 or Clang 14'
has "$out" 'gnuplot     found 99, need 5.4'

claim='doctor: too old, missing, and what to type'
with_apt
without gnuplot Catch2
has_only CMake 'too old|3.9.12'
has_only compiler 'too old|Clang 13.1'
course doctor
leaves_with 2
has "$out" 'CMake       found 3.9.12, need 3.25, type apt-get install cmake'
has "$out" 'gnuplot     found nothing, need 5.4, type apt-get install gnuplot-nox'
has "$out" 'Catch2      found nothing, need 3, type ./course setup'
has "$out" 'found Clang 13.1, need GCC 12 or Clang 14, type apt-get install g++ clang'
who=1000 course doctor
has "$out" 'let root type apt-get install gnuplot-nox'
fake sudo 'exit 1'
who=1000 course doctor
has "$out" 'type sudo apt-get install gnuplot-nox'

machine 'a command on a machine without the tools says how to get them'
without CMake gnuplot
course check 7
leaves_with 2
is "$err" 'course: missing here: CMake, gnuplot. Type ./course, which installs what is missing'

machine 'without a compiler or CMake nothing can be looked for, so all is installed'
with_apt
offers libcatch2-dev 3.7.1-0.6
cp "$lab/found" "$lab/all"
rm "$lab/found"
course doctor
leaves_with 2
has "$out" 'Only with them can the others be found'
course setup
leaves_with 0
has "$did" ' g++ clang cmake ninja-build '
has "$did" 'libcmark-gfm-dev libcmark-gfm-extensions-dev'

machine 'another system: it lists names and versions, and stops'
without gnuplot Catch2
course
leaves_with 2
has "$out" 'Catch2      3'
has "$out" 'gnuplot     5.4'
is "$did" ''

# ---- installing --------------------------------------------------------------------------------------------------

installs='apt-get --quiet --yes install --no-install-recommends --no-remove'
machine 'only what is missing is installed, without reading lists or adding sources in vain'
with_apt
without gnuplot libzip
course --yes
leaves_with 0
has "$did" "$installs --download-only libzip-dev gnuplot-nox
$installs libzip-dev gnuplot-nox
cmake: --preset"
has_not "$did" update
is "$(ls "$lab/sources")" debian.sources

machine 'Catch2 from backports: the stanza of Debian in deb822, with its key'
with_apt
without Catch2
course setup
leaves_with 0
is "$did" "apt-get --quiet --yes update -o Dir::Etc::SourceList=$lab/sources/frame-by-frame.sources -o Dir::Etc::SourceParts=- -o APT::Get::List-Cleanup=0
$installs --download-only libcatch2-dev
$installs libcatch2-dev"
has "$out" "$lab/sources/frame-by-frame.sources, bookworm-backports from http://mirror.example/debian"
is "$(cat "$lab/sources/frame-by-frame.sources")" '# Catch2 3, for the course Frame by Frame
Types: deb
URIs: http://mirror.example/debian
Suites: bookworm-backports
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg'

machine 'deb822 with comments, a switched-off stanza, a key of several lines and other options'
with_apt
without Catch2
targets "$lab/sources/debian.sources:2"
cat >"$lab/sources/debian.sources" <<'END'
# Written by an installer

Enabled: no
Types: deb
URIs: http://third.example/x
Suites: stable

# the release
Types: deb
Uris: http://mirror.example/debian
# Suites: sid
Suites: bookworm
Components: main
 contrib
signed-by:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 mQ
Trusted: yes

Types: deb
URIs: http://mirror.example/debian-security
Suites: bookworm-security
END
course setup
is "$(sed 1d "$lab/source.seen")" 'Types: deb
URIs: http://mirror.example/debian
Suites: bookworm-backports
Components: main
signed-by:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 mQ
Trusted: yes'

machine 'one-line sources, with options and without'
with_apt
without Catch2
targets "$lab/sources.list:2"
printf '# deb cdrom:[Debian 12]/ bookworm main\ndeb [ arch=amd64 signed-by=/k/d.gpg ] http://mirror.example/debian bookworm main contrib # mine\n' >"$lab/sources.list"
course setup
is "$(sed 1d "$lab/sources/frame-by-frame.list")" 'deb [ arch=amd64 signed-by=/k/d.gpg ] http://mirror.example/debian bookworm-backports main'
machine 'one-line sources, without options'
with_apt
without Catch2
targets "$lab/sources.list:1"
echo 'deb http://mirror.example/debian/ bookworm main' >"$lab/sources.list"
course setup
is "$(sed 1d "$lab/sources/frame-by-frame.list")" 'deb http://mirror.example/debian bookworm-backports main'

machine 'a machine that has never read its lists: the source is announced as a possibility, then added'
with_apt
without Catch2
mv "$lab/offers" "$lab/offers.later"
mv "$lab/targets" "$lab/targets.later"
course setup
leaves_with 0
has "$out" 'If this release has no Catch2 3'
has "$out" 'adding the source bookworm-backports'

machine 'a release with Catch2 3 of its own: no source'
with_apt
without Catch2
offers libcatch2-dev 3.7.1-0.6
course setup
leaves_with 0
is "$(ls "$lab/sources")" debian.sources
has_not "$out" backports
machine 'Ubuntu names it otherwise'
with_apt
without Catch2
offers catch2 3.4.0-1
course setup
has "$did" "$installs catch2"

machine 'no backports to be had: said, and the source taken away again'
with_apt
without Catch2
: >"$lab/no-backports"
course setup
leaves_with 2
has "$err" 'course: http://mirror.example/debian has no bookworm-backports with Catch2 3'
is "$(ls "$lab/sources")" debian.sources

machine 'a release that is too old is found out before anything is installed'
with_apt
without CMake Catch2
offers cmake 3.18.4
course
leaves_with 2
has "$err" "have no CMake 3.25"
has_not "$did" ' install '

machine 'apt-get fails: one sentence each'
with_apt
without gnuplot
echo 'E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 77 (unattended-upgr)' >"$lab/fails.apt"
course
leaves_with 2
is "$err" 'course: another program (unattended-upgr, process 77) is installing packages just now. Wait until it is done, then type ./course again'
echo "E: Failed to fetch http://x/y  Temporary failure resolving 'x'" >"$lab/fails.apt"
course
leaves_with 2
has "$err" 'is there a network?'
echo "E: dpkg was interrupted, you must manually run 'dpkg --configure -a' to correct the problem." >"$lab/fails.apt"
course
has "$err" 'Type dpkg --configure -a, then ./course again'
echo 'E: Something else' >"$lab/fails.apt"
course
leaves_with 2
has "$err" 'E: Something else'

claim='not root: sudo, or what to do without'
rm "$lab/fails.apt"
who=1000 course
leaves_with 2
has "$err" 'there is no sudo here'
has "$err" 'COURSE_BUILD="$(mktemp -d)" ./course setup' # a folder that nobody else has prepared
fake sudo 'case $1 in -n | -v) exit ${NO_SUDO:-0} ;; esac; echo "sudo $*" >>"$LAB/did"; exec "$@"'
who=1000 course
leaves_with 0
has "$did" "sudo env DEBIAN_FRONTEND=noninteractive LC_ALL=C $installs gnuplot-nox"

# ---- on a terminal -----------------------------------------------------------------------------------------------

# on_terminal KEYS ARGUMENT...: the same, with these keys typed (printf's escapes; a pause before each word)
on_terminal() {
    keys=$1
    shift
    (for key in $keys; do sleep 0.4; printf '%b' "$key"; done; sleep 0.2) |
        (cd "$tree" && env -i PATH="$bin" SHELL=/bin/sh TERM=xterm HOME="$lab" LAB="$lab" FAKE_ID=0 \
            "$script" -qec "./course $*" /dev/null) >"$lab/out" 2>"$lab/err"
    code=$?
    out=$(tr -d '\r' <"$lab/out")
    err=''
    did=$(cat "$lab/did" 2>/dev/null)
    rm -f "$lab/did"
}

script=$(command -v script)
if script -qec true /dev/null >/dev/null 2>&1; then
    machine 'on a terminal it asks once, and takes no for an answer'
    with_apt
    without gnuplot
    on_terminal 'n\n' setup
    leaves_with 2
    has "$out" 'Install them with apt-get? [Y/n]'
    has "$out" 'nothing was installed'
    is "$did" ''
    on_terminal '\n' setup
    leaves_with 0
    has "$did" "$installs gnuplot-nox"

    machine 'Ctrl-C in a step: 130, and the next run goes on'
    : >"$lab/slow.programs"
    on_terminal '\003'
    leaves_with 130
    has "$out" 'Stopped. ./course goes on from here.'
    has_not "$did" 'build section-tests'
    rm "$lab/slow.programs"
    course
    leaves_with 0
fi

echo "$checks checks, $failures failed"
[ "$failures" = 0 ]
