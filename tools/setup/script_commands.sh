# shellcheck shell=sh
# The commands that work before anything is built. Read by ./course.

help() {
    cat <<'END'
Usage: ./course [command]

  ./course            installs what is missing (it asks first), builds, runs all programs, draws all figures,
                      checks the book, makes its site; --yes: without asking
  ./course setup      only the installing; --yes: without asking
  ./course doctor     one line for each tool: what was found, what is needed, what to type
  ./course test       shows that the course works here: the solutions pass, wrong answers fail, and each kind of mistake
                      gets its words. --all: also every wrong answer that we know of, and the tests of the course
                      program, some minutes more. What follows goes to ctest: ./course test -R 07_

  ./course --version  says which version of the course this is
  COURSE_BUILD=/some/folder ./course    builds there instead of in build/default

Exit codes: 0 all is well; 1 a test is not passed, or a check found a difference; 2 the call, a file or the machine
needs something, and the message says what; 3 the course itself is at fault; 4 the machine got in the way, as by a
full disk; 130 stopped by Ctrl-C.
END
}

help_all() {
    if [ -x "$build/course-tool" ]; then exec "$build/course-tool" --help; fi # an older one will do
    help
    echo
    echo 'There are more commands; they come with the program that ./course builds. Type ./course, then ./course --help'
}

# Everything a fresh machine needs, up to a checked book.
everything() {
    take_build_folder
    if [ ! -f "$build/.looked" ] || [ -n "$(find "$root/tools/setup/needs" -newer "$build/.looked")" ]; then
        install_missing
        : >"$build/.looked"
    fi
    configure
    make_the_program
    target 3 'programs' programs
    target 3 'tests of the sections' section-tests
    target 3 'figures' figures
    check_the_book
    target 1 'site' site
    leave_build_folder
    short=${build#"$root"/}
    plots=$short/plots
    [ ! -e "$root/HANDOUT.md" ] || plots=plots # without our programs they are as they were published
    echo
    if [ "$unlike" ]; then
        printf 'All is built and drawn. But the book and the code differ:\n%s\n\n' "$unlike"
    else
        echo 'All is built, drawn and checked.'
    fi
    cat <<END
  the book        $short/site/index.html, in your browser: ./course open
  the figures     $plots
  the exercises   exercises/, one file a section: they are yours to change
Next: type ./course open, open the first exercise in your editor, and type ./course check
END
}

# If the book does not show a chapter's code as it is, a student may have tried something there, as the chapters suggest.
# That is told at the end, in $unlike, and stops nothing; ./course dev weave --check is strict.
check_the_book() {
    unlike=
    try book cmake --build "$build" --target book && return
    unlike=$(differences) || give_up 1
}

# The tests of the sections and of what a student reads; with --all, whatever takes longer, and those of the course
# program and of this script, too. ctest's closing lines are the last.
run_tests() {
    wanted=checks
    case ${1-} in
    --all)
        shift
        wanted=all
        ;;
    *) set -- --label-exclude '^(slow|thorough|configure|wild)$' --exclude-regex '^tool-tests' "$@" ;;
    esac
    take_build_folder
    configure
    make_the_program
    target 3 'tests' "$wanted"
    leave_build_folder
    export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$(getconf _NPROCESSORS_ONLN)}"
    ctest --test-dir "$build" --output-on-failure --no-tests=error "$@"
    case $? in
    0) exit 0 ;;
    130) exit 130 ;;
    *) exit 1 ;; # ctest's own 8 among them
    esac
}

case $command in
-h | --help | help)
    help_all
    exit
    ;;
test)
    shift
    case ${1-} in -h | --help) help; exit ;; esac
    run_tests "$@"
    ;;
esac

# The others know one option.
yes=no
for word; do
    case $word in
    --yes) yes=yes ;;
    -h | --help) help; exit ;;
    setup | doctor) [ "$word" = "$command" ] || complain 2 "one command at a time: $word. Type ./course --help" ;;
    *) complain 2 "there is no '$word' to $again. Type ./course --help" ;;
    esac
done

case $command in
doctor) doctor ;;
setup)
    take_build_folder
    install_missing
    say 'Everything that the course needs is installed. Next: ./course'
    ;;
*) everything ;;
esac
