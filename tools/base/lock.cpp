#include "base/lock.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <string>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace course {
namespace {

constexpr const char *variable = "COURSE_LOCKED"; // set for those whom the holder starts

bool try_for_a_moment(int file) {
    for (int attempt = 0; attempt < 10; ++attempt) {
        if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds{50});
    }
    return false;
}

std::string owner(const std::filesystem::path &lock) {
    std::ifstream text{lock};
    std::string line;
    std::getline(text, line);
    return line.empty() ? "another ./course" : line;
}

} // namespace

Lock::Lock(const Workspace &workspace) {
    const std::filesystem::path path = workspace.build / ".lock";
    if (const char *held = std::getenv(variable); held && *held) return;

    std::error_code trouble;
    std::filesystem::create_directories(workspace.build, trouble);
    file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
        throw UserError{"cannot write in the build folder " + workspace.build.string() + " (" + std::strerror(errno)
                        + "); make it writable, or build elsewhere with COURSE_BUILD=FOLDER"};

    if (!try_for_a_moment(file)) {
        std::cerr << "Waiting for " << owner(path) << ", which is at work in " << workspace.build.string() << ".\n";
        while (::flock(file, LOCK_EX) != 0)
            if (errno != EINTR)
                throw UserError{"cannot lock " + path.string() + " (" + std::strerror(errno)
                                + "); does its disk support locks?"};
    }
    const std::string name = "./course (process " + std::to_string(::getpid()) + ")\n";
    ::setenv(variable, "yes", 1);
    if (::ftruncate(file, 0) != 0 || ::write(file, name.data(), name.size()) < 0) errno = 0; // a courtesy, no more
}

Lock::~Lock() {
    if (file < 0) return;
    ::unsetenv(variable);
    if (::ftruncate(file, 0) != 0) errno = 0; // the lock goes with the file
}

UniqueFd short_lock(const std::filesystem::path &path) {
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    UniqueFd file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    while (file >= 0 && ::flock(file, LOCK_EX) != 0 && errno == EINTR) {}
    return file;
}

} // namespace course
