// What a subject is kept from, each time with the protection, and once without it: then the attack must succeed, or the
// test of the protection would show nothing.

#ifdef __linux__ // elsewhere nothing shuts a subject in
#include "base/files.hpp"
#include "base/kernel.hpp"
#include "judge/runner/student_process.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace course;
namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Catch::Matchers::StartsWith;

namespace {

bool prepared() {
    static const bool once = (prepare_for_subjects(-1), true);
    return once;
}

std::string attack(const std::string &what, Protection protection) {
    const OwnFolder folder;
    const fs::path victim = folder.path / "victim"; // a file that is ours to write and read
    write_file(victim, "");
    StudentProcess subject{ATTACK, what + ':' + victim.string(), protection};
    subject.finish({5});
    return subject.printed();
}

std::string children() {
    std::string all;
    std::getline(std::ifstream{"/proc/self/task/" + std::to_string(::getpid()) + "/children"}, all);
    return all;
}

/// Shuts this process itself in once more, as if it were a subject; false when the kernel has had enough.
bool shut_in_for_good() {
    return Sandbox{allowed_paths(ATTACK), {.calls = false, .privileges = false, .descriptors = false}}.shut(
        STDERR_FILENO);
}

#ifndef __SANITIZE_ADDRESS__ // whose leak checker must see
/// Whether a child of a process can read what /proc has of that process; both are nobody, if we are root.
bool child_sees_parent(bool hidden) {
    const pid_t parent = ::fork();
    if (parent != 0) {
        int status = -1;
        ::waitpid(parent, &status, 0);
        REQUIRE((status == 0 || status == 0x100));
        return status == 0;
    }
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(2);
    ::prctl(PR_SET_DUMPABLE, 1); // which a change of user has taken away
    if (hidden) hide_from_other_processes();
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(::open(("/proc/" + std::to_string(::getppid()) + "/environ").c_str(), O_RDONLY) >= 0 ? 0 : 1);
    int status = -1;
    ::waitpid(child, &status, 0);
    ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : 2);
}
#endif

} // namespace

TEST_CASE("a subject can write, delete and create no file, and read and run only its own") {
    if (!protection_of_this_kernel().files) SKIP("this kernel has no Landlock, or a sanitizer is in the way");
    const std::string what = GENERATE("write", "read", "delete", "make", "execute");
    CAPTURE(what, prepared());
    CHECK(attack(what, {}) == "Permission denied\n");
    CHECK(attack(what, {.files = false}) == "done\n");
}

TEST_CASE(
    "no process is started, reached or outlived by a subject, and nothing is left in memory or asked of the net") {
    if (!protection_of_this_kernel().calls) SKIP("this kernel has no seccomp, or a sanitizer is in the way");
    const std::string what = GENERATE("change mode", "trace", "signal", "signal by a pipe", "limit", "outlive",
                                      "share memory", "connect", "wait for the disk", "lock", "lock a part");
    CAPTURE(what, prepared());
    CHECK(attack(what, {}) == "Operation not permitted\n");
    // Landlock keeps a process from tracing others and signalling them as well.
    CHECK(attack(what, {.files = false, .calls = false}) == "done\n");
}

TEST_CASE("a subject starts no thread and no process, which no limit of its memory would count") {
    if (!protection_of_this_kernel().calls) SKIP("this kernel has no seccomp, or a sanitizer is in the way");
    const std::string what = GENERATE("fork", "thread");
    CAPTURE(what, prepared());
    CHECK(attack(what, {}) == "Resource temporarily unavailable\n");
    CHECK(attack(what, {.calls = false}) == "done\n");
}

TEST_CASE("a kernel whose Landlock doesn't see it empties no file for a subject either") {
    if (!protection_of_this_kernel().calls) SKIP("this kernel has no seccomp, or a sanitizer is in the way");
    const std::string what = GENERATE("empty by name", "empty by reading", "empty by looking");
    CAPTURE(what, prepared());
    CHECK(attack(what, {.files = false}) == "Operation not permitted\n");
    CHECK(attack(what, {.files = false, .calls = false}) == "done\n");
}

TEST_CASE("what newer kernels can do, a subject can't") {
    if (!protection_of_this_kernel().calls) SKIP("this kernel has no seccomp, or a sanitizer is in the way");
    CAPTURE(prepared());
    if (attack("new attribute", {.calls = false}) != "done\n") SKIP("this kernel, or its disk, can't do it either");
    CHECK(attack("new attribute", {}) == "Function not implemented\n");
}

TEST_CASE("memory that a subject asks for isn't 0 by luck") {
    if (sanitized) SKIP("a sanitizer has memory of its own");
    CAPTURE(prepared());
    CHECK(attack("fresh memory is 0", {}) != "done\n");
}

TEST_CASE("run by root, a subject has nothing of what only root may do") {
    if (sanitized) SKIP("a sanitizer is in the way");
    CAPTURE(prepared());
    const std::string what = GENERATE("capability", "host name");
    if (attack(what, {.calls = false, .privileges = false}) != "done\n") SKIP("we may not do it ourselves");
    CHECK(attack(what, {}) == "Operation not permitted\n");
    CHECK(attack(what, {.calls = false}) == "Operation not permitted\n");
    // Without its filter a subject has no capability all the same, and with all of them the filter is there.
    if (what == "host name" && protection_of_this_kernel().calls)
        CHECK(attack(what, {.privileges = false}) == "Operation not permitted\n");
}

TEST_CASE("run by root, a subject is started where only root may look") {
    const OwnFolder folder;
    const fs::path closed = folder.path / "closed", program = closed / "attack";
    fs::create_directory(closed);
    fs::copy_file(ATTACK, program);
    if (::chown(closed.c_str(), 65534, 65534) != 0) SKIP("we may not give a folder away, to nobody");
    fs::permissions(closed, fs::perms::owner_all);
    CAPTURE(prepared());
    StudentProcess subject{program, "many files:", {.limits = false}};
    subject.finish({5});
    CHECK(subject.printed() == "done\n");
}

TEST_CASE("what the kernel says it can do and then refuses keeps a subject from starting") {
    if (!protection_of_this_kernel().files) SKIP("this kernel has no Landlock, or a sanitizer is in the way");
    int status = -1;
    if (const pid_t child = ::fork(); child != 0) ::waitpid(child, &status, 0);
    else {
        while (shut_in_for_good()) {} // a process can be shut in sixteen times
        try {
            const StudentProcess subject{ATTACK, "inherit:", {}};
            ::_exit(1);
        } catch (const EnvironmentError &trouble) {
            ::_exit(std::string_view{trouble.what()}.starts_with("cannot shut the student's process in") ? 0 : 2);
        }
    }
    CHECK(status == 0);
}

TEST_CASE("a subject has no descriptors but its own five") {
    const int ours = ::open("/dev/null", O_RDONLY); // inherited by every program that is started
    ::dup2(ours, 200);
    CAPTURE(prepared());
    CHECK(attack("inherit", {}) == "Bad file descriptor\n");
    CHECK(attack("inherit", {.descriptors = false}) == "done\n");
    ::close(ours);
    ::close(200);
}

TEST_CASE("a subject has a limit of memory, of open files, and of what it prints") {
    const auto [what, refused] = GENERATE(table<std::string, std::string>({
#ifndef __SANITIZE_ADDRESS__ // which reserves terabytes of addresses: there is no limit then
        {"memory", "Cannot allocate memory\n"},
#endif
        {"many files", "Too many open files\n"},
        {"print", "File too large\n"},
    }));
    CAPTURE(what, prepared());
    CHECK_THAT(attack(what, {}), StartsWith(refused));
    CHECK_THAT(attack(what, {.limits = false}), StartsWith("done\n"));
}

#ifndef __SANITIZE_ADDRESS__ // whose leak checker must see
TEST_CASE("the memory and files of a hidden process cannot be read by another one of the same user") {
    CHECK(child_sees_parent(false));
    CHECK_FALSE(child_sees_parent(true));
}
#endif

TEST_CASE("processes that a subject has started end with it, even if it was allowed to start them") {
    CAPTURE(prepared());
    {
        StudentProcess subject{ATTACK, "leave a daemon:", {.files = false, .calls = false}};
        CHECK(subject.finish({5}) == 0);
        CHECK_FALSE(children().empty());
        const bool asked = GENERATE(true, false);
        if (asked) CHECK(subject.left_processes());
        if (asked) CHECK_FALSE(subject.left_processes());
    }
    CHECK(children().empty());
}

TEST_CASE("a subject that has ended keeps its number until nobody looks for what it has left: another could get it") {
    CAPTURE(prepared());
    StudentProcess subject{ATTACK, "print", {}};
    subject.finish({5});
    CHECK_FALSE(children().empty());
    CHECK_FALSE(subject.left_processes());
    CHECK(children().empty());
}

#endif
