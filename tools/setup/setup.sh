# shellcheck shell=sh
# What a machine must have, and how it gets it. Read by ./course; it says what it does through steps.sh.

# The table of what is needed: name | least version | packages | why.
needs() { grep -v '^#' "$root/tools/setup/needs"; }

# Lists in $lacking the lines of the table that this machine does not satisfy, each followed by what was found.
# CMake does the looking: cmake/Dependencies.cmake. Without a compiler, Ninja or a new enough CMake it cannot, and all
# counts as missing; what is there after all apt-get leaves alone.
find_lacking() {
    look=$(mktemp -d) || complain 2 "cannot make a temporary folder. Make ${TMPDIR:-/tmp} writable, then type $again again"
    cmake -S "$root" -B "$look" -G Ninja -DCOURSE_LOOK=ON >/dev/null 2>&1
    found=$(cat "$look/found" 2>/dev/null)
    rm -rf "$look"
    lacking=$(needs | while IFS='|' read -r name rest; do
        verdict=$(verdict_on "$name")
        case $verdict in fine*) ;; *) printf '%s|%s|%s\n' "$name" "$rest" "${verdict#*|}" ;; esac
    done)
}

# verdict_on NAME: `fine|3.25.1`, `too old|3.18`, `missing|`, or nothing if it was not looked for.
verdict_on() { printf '%s\n' "$found" | sed -n "s/^$1|//p"; }

each_lacking() { [ -z "$lacking" ] || printf '%s\n' "$lacking"; }
lacking_names() { each_lacking | cut -d'|' -f1 | paste -sd, - | sed 's/,/, /g'; }

# wanted NAME LEAST: the least version, for people.
wanted() { case $1 in compiler) echo 'GCC 12 or Clang 14' ;; *) echo "$2" ;; esac; }

# What `./course doctor` prints: found X, need Y, and if that is not enough: type Z.
doctor() {
    find_lacking
    needs | while IFS='|' read -r name least packages _; do
        verdict=$(verdict_on "$name")
        version=${verdict#*|}
        case $verdict in fine*) remedy= ;; *) remedy=", $(remedy)" ;; esac
        printf '%-11s found %s, need %s%s\n' "$name" "${version:-nothing}" "$(wanted "$name" "$least")" "$remedy"
    done
    [ -n "$found" ] || echo 'A compiler, Ninja or CMake 3.25 is missing. Only with them can the others be found.'
    [ ! -x "$build/course-tool" ] || "$build/course-tool" doctor
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
    each_lacking | while IFS='|' read -r name least packages why version; do
        printf '  %-11s %-7s %-19s %s\n' "$name" "$least" "$(echo "${packages%% *}" | sed 's/,.*//')" "$why${version:+; found here: $version}"
    done >&3
    announce_backports
    may_we
    become_root
    if [ "${without:- Catch2}" != ' Catch2' ] || [ -z "$codename" ]; then
        try 'lists of packages' apt update || :
        choose_all
    fi
    [ "$without" != ' Catch2' ] || add_backports
    [ -z "$without" ] || not_to_be_had
    fetch || { grep -Eq '404 |Hash Sum mismatch' "$log" && try 'lists of packages' apt update && fetch; } || explain
    try 'installing packages' install_whole || explain
    find_lacking
    [ -z "$lacking" ] ||
        complain 2 "the packages are installed, but $(lacking_names) are still not found or too old; perhaps older ones stand first in PATH. See ./course doctor"
}

ask_for_it_by_name() {
    say 'Only where apt-get is (Debian, Ubuntu and their kin) can the course install what it needs. Please install:'
    each_lacking | while IFS='|' read -r name least _ why version; do
        printf '  %-11s %-7s %s\n' "$name" "$least" "$why${version:+; found here: $version}"
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
    as_root='Let root type, in this folder: COURSE_BUILD="$(mktemp -d)" ./course setup; then type ./course again'
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

# choose LEAST PACKAGES: the first of them that this system offers in a version that will do. (`a,b`: b belongs to a.)
choose() {
    for package in $2; do
        offered=$(LC_ALL=C apt-cache policy "${package%%,*}" 2>/dev/null | sed -n 's/^ *Candidate: //p')
        if at_least "${offered#*:}" "$1"; then # without the epoch
            echo "$package" | tr , ' '
            return
        fi
    done
    return 1
}

# at_least HAVE WANT: compares 3.25.1-1 with 3.25.
at_least() { [ "$(printf '%s\n' "$1" "$2" | sort -V | head -n 1)" = "$2" ]; }

# Of $lacking: the packages that will do in $chosen, the names of those without one in $without.
choose_all() {
    chosen=
    without=
    while IFS='|' read -r name least packages _; do
        if package=$(choose "$least" "$packages"); then chosen="$chosen $package"; else without="$without $name"; fi
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
    case $without in *Catch2*) ;; *) return 0 ;; esac
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
    *Catch2*)
        $sudo_if_needed rm -f "$backports_file"
        known_trouble
        complain 2 "$address has no $codename-backports with Catch2 3, so the added source was taken away again (the log: $log). Install Catch2 3 in another way, then type ./course again"
        ;;
    esac
}

# After all lists were read, something is still not on offer.
not_to_be_had() {
    known_trouble
    complain 2 "apt's sources on this machine have no$(each_lacking | while IFS='|' read -r name least _; do
        case " $without " in *" $name "*) printf ', %s %s' "$name" "$least" ;; esac
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
