// The one way in which `course` writes files: whole or not at all, and said in one sentence if not.

#include "base/errors.hpp"
#include "base/files.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <random>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using namespace course;
namespace fs = std::filesystem;

namespace {

struct Folder : OwnFolder {
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator{path}, fs::directory_iterator{}));
    }
};

struct Unmount {
    const fs::path &path;
    ~Unmount() { ::umount(path.c_str()); }
};

/// No file of this process may be longer, as long as this lives.
struct SmallFiles {
    explicit SmallFiles(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{bytes, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallFiles() {
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, signal_before);
    }
    SmallFiles(const SmallFiles &) = delete;
    SmallFiles &operator=(const SmallFiles &) = delete;

    rlimit before{};
    void (*signal_before)(int) = std::signal(SIGXFSZ, SIG_IGN); // an error, please, and not the end
};

mode_t mode(const fs::path &file) {
    struct stat is {};
    ::stat(file.c_str(), &is);
    return is.st_mode & 07777;
}

} // namespace

TEST_CASE("a file is written with the folders above it, and read byte for byte") {
    const Folder folder;
    const fs::path file = folder.path / "new/folder/file";
    const std::string bytes{"a\r\nb\0\xFF\n", 7};

    CHECK(write_file(file, bytes));
    CHECK(read_file(file) == bytes);
    CHECK(write_file(file, ""));
    CHECK(read_file(file).empty());
}

TEST_CASE("a file that has the text already keeps its date") {
    const Folder folder;
    const fs::path file = folder.path / "file";
    write_file(file, "text");
    const auto date = fs::file_time_type::clock::now() - std::chrono::hours{5};
    fs::last_write_time(file, date);

    CHECK_FALSE(write_file(file, "text"));
    CHECK(fs::last_write_time(file) == date);
    CHECK(write_file(file, "texts"));
    CHECK(fs::last_write_time(file) > date);
}

TEST_CASE("a link stays a link, and what it names is written") {
    const Folder folder;
    write_file(folder.path / "real", "old");
    fs::create_symlink("real", folder.path / "link");

    CHECK(write_file(folder.path / "link", "new"));
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(read_file(folder.path / "real") == "new");
}

TEST_CASE("a link to a file that is not there yet makes that file") {
    const Folder folder;
    fs::create_symlink("real", folder.path / "link");

    CHECK(write_file(folder.path / "link", "new"));
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(read_file(folder.path / "real") == "new");
}

TEST_CASE("a file keeps its mode, and a new one has the usual") {
    const Folder folder;
    const fs::path script = folder.path / "script";
    write_file(script, "#!/bin/sh\n");
    const mode_t mask = ::umask(0);
    ::umask(mask);
    CHECK(mode(script) == (0666 & ~mask));

    ::chmod(script.c_str(), 0750);
    write_file(script, "#!/bin/sh\necho\n");
    CHECK(mode(script) == 0750);
}

TEST_CASE("a folder that cannot be written is named in one sentence") {
    const Folder folder;
    write_file(folder.path / "file", "text");
    SECTION("a file where a folder should be") {
        const fs::path file = folder.path / "file/inside";
        CHECK_THROWS_MATCHES(
            write_file(file, "new"), UserError,
            MessageMatches(ContainsSubstring("cannot write " + file.string()) && ContainsSubstring("; ")));
    }
    SECTION("a folder that is nobody's to write, root's neither") {
        CHECK_THROWS_MATCHES(write_file("/proc/self/course/file", "new"), UserError,
                             MessageMatches(ContainsSubstring("cannot write /proc/self/course/file")));
    }
    CHECK(read_file(folder.path / "file") == "text");
    CHECK(folder.files() == 1);
}

TEST_CASE("a folder without leave to write is named, and what to do") {
    if (::geteuid() == 0) SKIP("root may write everywhere");
    const Folder folder;
    write_file(folder.path / "file", "text");
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);

    CHECK_THROWS_MATCHES(write_file(folder.path / "file", "new"), UserError,
                         MessageMatches(ContainsSubstring("make " + folder.path.string() + " writable")));
    CHECK(read_file(folder.path / "file") == "text");
    fs::permissions(folder.path, fs::perms::owner_all);
}

TEST_CASE("a file that is not there, and a folder, cannot be read, and are named") {
    const Folder folder;
    CHECK_THROWS_MATCHES(read_file(folder.path / "none"), UserError,
                         MessageMatches(ContainsSubstring("cannot read " + (folder.path / "none").string())));
    CHECK_THROWS_AS(read_file(folder.path), UserError);
}

TEST_CASE("a full disk is reported in one sentence; the old file stays, and no draft is left") {
    const Folder folder;
    if (::mount("tmpfs", folder.path.c_str(), "tmpfs", 0, "size=64k") != 0)
        SKIP("only root can make a small disk to fill");
    const Unmount when_done{folder.path};
    const fs::path file = folder.path / "file";
    write_file(file, "old");

    CHECK_THROWS_MATCHES(write_file(file, std::string(200'000, 'x')), UserError,
                         MessageMatches(ContainsSubstring("cannot write " + file.string() + ": the disk is full")));
    CHECK(read_file(file) == "old");
    CHECK(folder.files() == 1);
    CHECK(write_file(file, "new")); // and with room, all is well
}

TEST_CASE("a file-size limit is reported as a full disk, and the old file stays") {
    const Folder folder;
    const fs::path file = folder.path / "file";
    write_file(file, "old");
    const SmallFiles until_done{64 * 1024};

    CHECK_THROWS_MATCHES(write_file(file, std::string(200'000, 'x')), UserError,
                         MessageMatches(ContainsSubstring("the disk is full")));
    CHECK(read_file(file) == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("writing that is killed at any moment leaves the old text or the new one") {
    const Folder folder;
    const fs::path file = folder.path / "file";
    const std::string texts[] = {std::string(3'000'000, 'a'), std::string(4'000'000, 'b')};
    write_file(file, texts[0]);

    std::mt19937 chance{7};
    int with_a_draft = 0;
    for (int round = 0; round < 60; ++round) {
        const pid_t child = ::fork();
        if (child == 0)
            for (std::size_t i = 1;; ++i) write_file(file, texts[i % 2]);
        while (folder.files() == 1) std::this_thread::yield(); // until it writes
        std::this_thread::sleep_for(std::chrono::microseconds{std::uniform_int_distribution<>{0, 20'000}(chance)});
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const std::string now = read_file(file);
        REQUIRE((now == texts[0] || now == texts[1]));
        with_a_draft += folder.files() > 1;
        write_file(file, texts[now == texts[0] ? 1 : 0]); // over the draft
        REQUIRE(folder.files() == 1);
    }
    CHECK(with_a_draft > 0); // or it was never hit while writing
}

TEST_CASE("a draft that is being written is waited for, a left one is written over, and no other file is touched") {
    const Folder folder;
    const fs::path file = folder.path / "file", draft = folder.path / ".file.draft";
    write_file(folder.path / "file.draft", "mine");
    write_file(folder.path / ".other.draft", "mine");
    std::ofstream{draft} << "what a kill has left, which is longer";
    const int writer = ::open(draft.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    REQUIRE(::flock(writer, LOCK_EX) == 0);
    std::thread other{[&] { write_file(file, "new"); }};
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    CHECK_FALSE(fs::exists(file));
    fs::rename(draft, file);
    ::close(writer);
    other.join();
    CHECK(read_file(file) == "new");
    std::ofstream{draft} << "left by a kill, and read-only";
    fs::permissions(draft, fs::perms::owner_read);
    write_file(file, "newer");
    CHECK(read_file(file) == "newer");
    CHECK(folder.files() == 3);
}
