#pragma once
// A folder for one test, gone in the end; and a copy of the course for it.

#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>

namespace course {

struct OwnFolder {
    /// @param like  its name, where the six X are replaced by letters of its own
    explicit OwnFolder(const std::string &like = "a test XXXXXX") {
        std::string name = (std::filesystem::temp_directory_path() / like).string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error{"no folder for a test"};
        path = name;
    }
    ~OwnFolder() { std::filesystem::remove_all(path); }
    OwnFolder(const OwnFolder &) = delete;
    OwnFolder &operator=(const OwnFolder &) = delete;

    std::filesystem::path path;
};

/// A copy of the course as it is published: without what has been built, and the thousands of files of npm.
inline void copy_course(const std::filesystem::path &to) {
    namespace fs = std::filesystem;
    const std::set<std::string> left_out{"build", ".git", ".course", "node_modules"};
    fs::create_directories(to);
    for (fs::recursive_directory_iterator each{COURSE_ROOT}, end; each != end; ++each) {
        if (left_out.contains(each->path().filename().string())) {
            each.disable_recursion_pending();
            continue;
        }
        const fs::path copy = to / each->path().lexically_relative(COURSE_ROOT);
        if (each->is_directory()) fs::create_directory(copy);
        else fs::copy_file(each->path(), copy);
    }
}

} // namespace course
