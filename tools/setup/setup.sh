# shellcheck shell=sh
# What a machine must have, and how it gets it. Read by ./course; it says what it does through steps.sh.

# The table: key | name | least version | packages of Debian and Ubuntu that may have it, best first | why.
needs() {
    cat <<'END'
compiler|C++20 compiler|12|g++|compiles your answers and everything else (or Clang 14)
cmake|CMake|3.25|cmake|describes the build
ninja|Ninja|1.10|ninja-build|does the build, and only what has changed
eigen|Eigen|3.4|libeigen3-dev|vectors and matrices, in the chapters and in your answers
catch2|Catch2|3.0|libcatch2-dev catch2|the tests are written with it
cli11|CLI11|2.1|libcli11-dev|the command line of ./course
json|nlohmann JSON|3.9|nlohmann-json3-dev|what the course keeps: your progress, lists of exercises
cmark|cmark|0.30|libcmark-dev|reads the chapters, to prove that text and code agree
pugixml|pugixml|1.12|libpugixml-dev|writes test reports, checks figures
gmp|GMP with gmpxx|6.2|libgmp-dev|exact fractions, against which some tests judge
gnuplot|gnuplot|5.4|gnuplot-nox|draws the figures
doxygen|Doxygen|1.9.4|doxygen|makes pages of chapters and headers, for the book's site
gumbo|Gumbo|0.10|libgumbo-dev|reads the site's pages, to finish them and to check their links
node|Node.js|18|nodejs|runs KaTeX and lunr, while the site is built
katex|KaTeX|0.16|libjs-katex|typesets the site's formulas
lunr|lunr|2.3|libjs-lunr|the site's search
END
}

# found KEY: prints the version that this machine has, or nothing.
found() {
    case $1 in
    compiler) compiler ;;
    cmake) cmake --version 2>/dev/null | sed -n 's/^cmake version //p' ;;
    ninja) ninja --version 2>/dev/null ;;
    gnuplot) gnuplot --version 2>/dev/null | sed -n 's/^gnuplot \([0-9.]*\) patchlevel /\1./p' ;;
    eigen) defined EIGEN_WORLD_VERSION EIGEN_MAJOR_VERSION EIGEN_MINOR_VERSION in \
        eigen3/Eigen/src/Core/util/Macros.h Eigen/src/Core/util/Macros.h eigen3/Eigen/Version Eigen/Version ;;
    catch2) defined CATCH_VERSION_MAJOR CATCH_VERSION_MINOR CATCH_VERSION_PATCH in \
        catch2/catch_version_macros.hpp catch2/catch.hpp ;;
    cli11) defined CLI11_VERSION in CLI/Version.hpp CLI11/CLI11.hpp ;;
    json) defined NLOHMANN_JSON_VERSION_MAJOR NLOHMANN_JSON_VERSION_MINOR NLOHMANN_JSON_VERSION_PATCH in \
        nlohmann/detail/abi_macros.hpp nlohmann/json.hpp ;;
    cmark) defined CMARK_VERSION_STRING in cmark_version.h ;;
    pugixml) defined PUGIXML_VERSION in pugixml.hpp | sed 's/^\([0-9]\)\([0-9][0-9]\).*/\1.\2/' ;; # 1130 is 1.13
    gmp) [ -z "$(header gmpxx.h)" ] ||
        defined __GNU_MP_VERSION __GNU_MP_VERSION_MINOR __GNU_MP_VERSION_PATCHLEVEL in gmp.h ;;
    doxygen) doxygen --version 2>/dev/null | sed 's/ .*//' ;;
    gumbo)
        file=$(beside lib/pkgconfig/gumbo.pc 'lib/*-linux-gnu*/pkgconfig/gumbo.pc')
        [ -z "$file" ] || sed -n 's/^Version: //p' "$file"
        ;;
    node) { node --version || nodejs --version; } 2>/dev/null | sed 's/^v//' ;;
    katex) script katex.js katex | grep -o '{version:"[0-9.]*"' | sed 's/[^0-9.]//g' ;;
    lunr) script lunr.js lunr | sed -n 's/^ \* lunr - .* - \([0-9.]*\)$/\1/p' ;;
    esac
}

# The compiler that CMake will take: CXX, or the first of these.
compiler() {
    for cxx in ${CXX:-c++ g++ clang++}; do
        command -v "$cxx" >/dev/null || continue
        # shellcheck disable=SC2046 # five words: the version of Clang, if it is one, and that of GCC
        set -- $(echo __clang_major__ __clang_minor__ __GNUC__ __GNUC_MINOR__ __GNUC_PATCHLEVEL__ |
            "$cxx" -E -P -x c++ - 2>/dev/null)
        case ${1-} in
        '') ;;
        __clang_major__) echo "GCC $3.$4.$5" ;;
        *) echo "Clang $1.$2" ;;
        esac
        return
    done
}

# header NAME...: the first of these headers where compilers and CMake look.
header() {
    for name; do
        set -- "$@" "include/$name" "include/*-linux-gnu*/$name"
        shift
    done
    beside "$@"
}

# beside FILE...: the first of these files below one of the places where things are installed.
beside() {
    IFS=:
    for prefix in ${CMAKE_PREFIX_PATH-} ${COURSE_PREFIXES:-/usr/local:/opt/homebrew:/usr}; do
        for name; do
            for file in "$prefix/"$name; do # a pattern, perhaps
                if [ -f "$file" ]; then
                    printf '%s\n' "$file"
                    break 3
                fi
            done
        done
    done
    unset IFS
}

# script FILE PACKAGE: the text of a library of JavaScript, as Debian or npm installs it.
script() {
    file=$(beside "share/javascript/$2/$1" "lib/node_modules/$2/dist/$1" "lib/node_modules/$2/$1")
    [ -z "$file" ] || cat "$file"
}

# defined MACRO... in HEADER...: the macros' values, with dots between them, in the first of the headers there is.
defined() {
    macros=
    while [ "$1" != in ]; do
        macros="$macros $1"
        shift
    done
    shift
    file=$(header "$@")
    [ -z "$file" ] || awk -v macros="$macros" '
        { sub(/^[ \t]*#[ \t]*define/, "#define") }
        $1 == "#define" && $3 != "" && !($2 in value) { value[$2] = $3; gsub(/"/, "", value[$2]) }
        END {
            n = split(macros, name, " ")
            for (i = 1; i <= n; i++) printf "%s%s", (i > 1 ? "." : ""), value[name[i]]
            print ""
        }' "$file"
}

# at_least HAVE WANT: compares 3.25.1 with 3.25.
at_least() {
    have=$1
    want=$2
    while [ -n "$want" ]; do
        h=${have%%.*}
        h=${h%%[!0-9]*}
        w=${want%%.*}
        [ "${h:-0}" -le "$w" ] || return 0
        [ "${h:-0}" -ge "$w" ] || return 1
        case $have in *.*) have=${have#*.} ;; *) have= ;; esac
        case $want in *.*) want=${want#*.} ;; *) want= ;; esac
    done
}

# enough KEY FOUND LEAST
enough() {
    case $1:$2 in
    *:) return 1 ;;
    compiler:Clang*) at_least "${2#* }" 14 ;;
    *) at_least "${2#GCC }" "$3" ;;
    esac
}

# wanted KEY LEAST: the same for people.
wanted() { case $1 in compiler) echo 'GCC 12 or Clang 14' ;; *) echo "$2" ;; esac; }

# Lists in $lacking the lines of the table that this machine does not satisfy, each with what was found behind it.
find_lacking() {
    lacking=
    while IFS='|' read -r key name least packages why; do
        version=$(found "$key")
        enough "$key" "$version" "$least" || lacking="$lacking$key|$name|$least|$packages|$why|$version
"
    done <<END
$(needs)
END
}

each_lacking() { printf '%s' "$lacking"; }
lacking_names() { each_lacking | cut -d'|' -f2 | paste -sd, - | sed 's/,/, /g'; }

# What `./course doctor` prints: found X, need Y, and if that is not enough: type Z.
doctor() {
    lacking=
    while IFS='|' read -r key name least packages _; do
        version=$(found "$key")
        if enough "$key" "$version" "$least"; then
            printf '%-15s found %s, need %s\n' "$name" "$version" "$(wanted "$key" "$least")"
        else
            printf '%-15s found %s, need %s, %s\n' "$name" "${version:-nothing}" "$(wanted "$key" "$least")" "$(remedy)"
            lacking=yes
        fi
    done <<END
$(needs)
END
    [ -z "$lacking" ] || exit 2
}

# What to type for the $packages of one line.
remedy() {
    if ! command -v apt-get >/dev/null; then
        echo "install $name $least or later"
    elif package=$(choose "$least" "$packages"); then
        if [ "$sudo_if_needed" ] && ! command -v sudo >/dev/null; then
            echo "let root type apt-get install $package"
        else
            echo "type ${sudo_if_needed}apt-get install $package"
        fi
    else
        echo 'type ./course setup'
    fi
}

if [ "$(id -u)" = 0 ]; then sudo_if_needed=''; else sudo_if_needed='sudo '; fi

# Before a build folder can be configured.
have_tools() {
    find_lacking
    [ -z "$lacking" ] ||
        complain 2 "missing here: $(lacking_names). Type ./course, which installs what is missing"
}

# Installs what is missing, if anything is; asks before it does.
install_missing() {
    find_lacking
    [ -n "$lacking" ] || return 0
    command -v apt-get >/dev/null || ask_for_it_by_name
    choose_all
    find_origin
    say 'The course needs what this machine does not have yet:'
    each_lacking | while IFS='|' read -r _ name least packages why version; do
        printf '  %-15s %-7s %-19s %s\n' "$name" "$least" "${packages%% *}" "$why${version:+; found here: $version}"
    done >&3
    announce_backports
    may_we
    become_root
    if [ "${without:- catch2}" != ' catch2' ] || [ -z "$codename" ]; then
        try 'lists of packages' apt update || :
        choose_all
    fi
    [ "$without" != ' catch2' ] || add_backports
    [ -z "$without" ] || not_to_be_had
    fetch || { grep -Eq '404 |Hash Sum mismatch' "$log" && try 'lists of packages' apt update && fetch; } || explain
    try 'installing packages' install_whole || explain
    find_lacking
    [ -z "$lacking" ] ||
        complain 2 "the packages are installed, but $(lacking_names) are still not found or too old; perhaps older ones stand first in PATH. See ./course doctor"
}

ask_for_it_by_name() {
    say 'Only where apt-get is (Debian, Ubuntu and their kin) can the course install what it needs. Please install:'
    each_lacking | while IFS='|' read -r _ name least _ why version; do
        printf '  %-15s %-7s %s\n' "$name" "$least" "$why${version:+; found here: $version}"
    done >&3
    complain 2 'some tools are missing; they are listed above, each with the least version. Install them, then type ./course again'
}

may_we() {
    [ "$yes" = no ] && [ -t 0 ] && [ -t 3 ] || return 0
    printf 'Install them with apt-get? [Y/n] ' >&3
    IFS= read -r answer || answer=n
    case $answer in '' | [Yy]*) ;; *) complain 2 'nothing was installed. ./course doctor says what to type for each tool' ;; esac
}

become_root() {
    [ -n "$sudo_if_needed" ] || return 0
    as_root='Let root type, in this folder: COURSE_BUILD=/tmp/course-setup ./course setup; then type ./course again'
    command -v sudo >/dev/null || complain 2 "installing needs root, and there is no sudo here. $as_root"
    if [ -t 0 ]; then sudo -v; else sudo -n true 2>/dev/null; fi ||
        complain 2 "installing needs root, and sudo refuses (or needs a terminal to ask for your password). $as_root"
}

# Every call of apt-get that changes something. Its noise goes to the log of the step.
apt() (
    what=$1
    exec 3>&- 9>&-
    # shellcheck disable=SC2086 # sudo or nothing
    set -- $sudo_if_needed env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get --quiet --yes
    install='install --no-install-recommends --no-remove'
    backports_only="-o Dir::Etc::SourceList=$backports_file -o Dir::Etc::SourceParts=- -o APT::Get::List-Cleanup=0"
    # shellcheck disable=SC2086 # several words each
    case $what in
    update) exec "$@" update ;;
    update-backports) exec "$@" update $backports_only ;;
    download) exec "$@" $install --download-only $chosen ;;
    install) exec "$@" $install $chosen ;;
    esac
)

# dpkg must not stop half-way. In the background a shell has Ctrl-C ignored, and so have those it starts.
install_whole() {
    trap 'interrupted=yes; say "(Ctrl-C: stops when dpkg is done)"' INT
    interrupted=
    apt install &
    while :; do
        wait $!
        code=$?
        kill -0 $! 2>/dev/null || break
    done
    trap stopped INT
    [ -z "$interrupted" ] || stopped
    return $code
}

fetch() { try 'downloading packages' apt download; }

# choose LEAST PACKAGES: the first of them that this system offers in a version that will do.
choose() {
    for package in $2; do
        offered=$(LC_ALL=C apt-cache policy "$package" 2>/dev/null | sed -n 's/^ *Candidate: //p')
        offered=${offered#*:} # the epoch
        if at_least "${offered:-0}" "$1"; then
            echo "$package"
            return
        fi
    done
    return 1
}

# Of $lacking: the packages that will do in $chosen, the keys for which there is none in $without.
choose_all() {
    chosen=
    without=
    while IFS='|' read -r key name least packages _; do
        if package=$(choose "$least" "$packages"); then chosen="$chosen $package"; else without="$without $key"; fi
    done <<END
$(each_lacking)
END
}

# Debian's own entry among this machine's sources: $codename, $address, and $entry, file:number. $codename is empty
# before the first update. And where a source is added: $backports_file, in the same format.
find_origin() {
    # shellcheck disable=SC2016 # the names are apt's
    origin=$(apt-get indextargets \
        --format '$(ORIGIN)|$(COMPONENT)|$(CREATED_BY)|$(CODENAME)|$(SITE)|$(SOURCESENTRY)' 2>/dev/null |
        grep -E '^Debian\|main\|Packages\|[a-z]+\|' | grep -v '|cdrom:' | head -n 1 | cut -d'|' -f4-)
    codename=${origin%%|*}
    origin=${origin#*|}
    address=${origin%%|*}
    entry=${origin#*|}
    folder=/etc/apt/sources.list.d/
    eval "$(apt-config shell folder Dir::Etc::sourceparts/d)"
    backports_file=${folder%/}/frame-by-frame
    case $entry in *.sources:*) backports_file=$backports_file.sources ;; *) backports_file=$backports_file.list ;; esac
}

# The line or stanza for backports: the machine's own entry for the release, with all its options (its key, above
# all), but for this one suite and component.
backports_entry() {
    file=${entry%:*}
    number=${entry##*:}
    case $file in
    *.sources) awk -v n="$number" -v uri="$address" -v suite="$codename-backports" '
        BEGIN { RS = ""; FS = "\n" }
        {
            stanza = ""
            for (i = 1; i <= NF; i++) if ($i !~ /^#/) stanza = stanza $i "\n"
            if (stanza == "" || ++count != n) next
            print "Types: deb\nURIs: " uri "\nSuites: " suite "\nComponents: main"
            lines = split(stanza, line, "\n")
            for (i = 1; i < lines; i++) {
                if (line[i] ~ /^[^ \t]/) mine = tolower(line[i]) !~ /^(types|uris|suites|components|enabled):/
                if (mine) print line[i]
            }
        }' "$file" ;;
    *) sed -n "${number}p" "$file" | sed -n 's/^[ \t]*deb[ \t]*\(\[[^]]*\] *\).*/\1/p' | {
        IFS= read -r options || options=
        printf 'deb %s%s %s-backports main\n' "$options" "$address" "$codename"
    } ;;
    esac
}

# Says that a source will be added, before it is.
announce_backports() {
    case $without in *catch2*) ;; *) return 0 ;; esac
    if [ -n "$codename" ]; then
        say "Debian's release $codename has no Catch2 3, but its backports have. So one source is added to apt's, for Catch2"
        say "alone: $backports_file, $codename-backports from $address"
    else
        say "If this release has no Catch2 3 (Debian 12 has not), its backports are added to apt's sources, for Catch2 alone,"
        say "as ${backports_file%.*}"
    fi
}

# The one file that we ever write outside the checkout.
add_backports() {
    find_origin
    [ -n "$codename" ] || return 0 # no Debian
    say "  adding the source $codename-backports from $address as $backports_file"
    { echo '# Catch2 3, for the course Frame by Frame'; backports_entry; } >"$build/log/backports"
    $sudo_if_needed install -m 644 "$build/log/backports" "$backports_file" ||
        complain 2 "cannot write $backports_file. Install Catch2 3 in another way, then type ./course again"
    try 'list of backports' apt update-backports
    choose_all
    case $without in
    *catch2*)
        $sudo_if_needed rm -f "$backports_file"
        known_trouble
        complain 2 "$address has no $codename-backports with Catch2 3, so the added source was taken away again (the log: $log). Install Catch2 3 in another way, then type ./course again"
        ;;
    esac
}

# After all lists were read, something is still not on offer.
not_to_be_had() {
    known_trouble
    complain 2 "apt's sources on this machine have no$(each_lacking | while IFS='|' read -r key name least _; do
        case " $without " in *" $key "*) printf ', %s %s' "$name" "$least" ;; esac
    done | sed 's/^,//') or later. Install that in another way, then type ./course again"
}

# Why apt-get failed, by the log of the last step.
explain() {
    known_trouble
    give_up 2
}

known_trouble() {
    if grep -Eq 'is held by process|Could not get lock|Unable to (acquire|lock)' "$log"; then
        holder=$(sed -n 's/.*held by process \([0-9]*\) (\(.*\)).*/ (\2, process \1)/p' "$log" | head -n 1)
        complain 2 "another program$holder is installing packages just now. Wait until it is done, then type $again again"
    elif grep -q 'dpkg was interrupted' "$log"; then
        complain 2 "an earlier installation was cut short. Type ${sudo_if_needed}dpkg --configure -a, then $again again"
    elif grep -Eq "$no_network" "$log"; then
        complain 2 "apt-get cannot reach its packages: is there a network? Then type $again again; what was there stays (the log: $log)"
    elif grep -q 'Packages need to be removed but remove is disabled' "$log"; then
        complain 2 "apt-get would have to remove packages of yours, which the course does not do (the log: $log). Type ${sudo_if_needed}apt-get install$chosen and decide"
    fi
}
no_network='Temporary failure resolving|Could not (resolve|connect)|Cannot initiate the connection|Network is unreachable|Connection (refused|timed out|failed|reset)|No route to host'
