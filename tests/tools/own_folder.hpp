#pragma once
// A folder for one test, gone in the end.

#include <cstdlib>
#include <filesystem>
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

} // namespace course
