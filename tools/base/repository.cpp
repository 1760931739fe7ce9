#include "base/repository.hpp"

#include "base/files.hpp"
#include "base/process.hpp"

#include <fmt/format.h>
#include <regex>

namespace course {

std::string version_of(const Workspace &workspace) {
    static const std::regex version{R"(project\(\w+ VERSION ([\d.]+))"};
    std::smatch match;
    const std::string text = read_file(workspace.root / "CMakeLists.txt");
    if (!std::regex_search(text, match, version)) throw UserError{"CMakeLists.txt has no project(… VERSION 1.2.3)"};
    return match[1];
}

std::string address_of(const Workspace &workspace) {
    static const std::regex address{R"re(project\([^)]* HOMEPAGE_URL "([^"]*)")re"};
    std::smatch match;
    const std::string text = read_file(workspace.root / "CMakeLists.txt");
    return std::regex_search(text, match, address) ? match[1].str() : "";
}

std::string printed_by(const std::vector<std::string> &command, const std::filesystem::path &folder) {
    const Finished done = run(command, {.folder = folder});
    if (done.code != 0) throw UserError{command[0] + ' ' + command[1] + " failed: " + done.err};
    return done.out;
}

void pack(const std::filesystem::path &zip, const std::filesystem::path &folder,
          const std::vector<std::string> &names) {
    std::vector<std::string> command{"cmake",        "-E", "tar", "cf", std::filesystem::absolute(zip).string(),
                                     "--format=zip", "--"};
    command.insert(command.end(), names.begin(), names.end());
    printed_by(command, folder);
}

std::string with_size(const std::string &name, const std::filesystem::path &file) {
    return fmt::format("{}, {:.1f} MB\n", name, double(std::filesystem::file_size(file)) / 1e6);
}

std::string git_in(const std::filesystem::path &repository, std::vector<std::string> words) {
    const std::string what = words.front();
    words.insert(words.begin(), {"git", "-c", "user.name=Frame by Frame", "-c", "user.email=course@localhost", "-c",
                                 "commit.gpgsign=false"});
    const Finished done = run(words, {.folder = repository});
    if (done.code != 0) throw UserError{"git " + what + " failed: " + done.err.substr(0, done.err.find('\n'))};
    return done.out;
}

void require_committed(const Workspace &workspace, const std::string &what) {
    if (const std::string changed = git_in(workspace.root, {"status", "--porcelain"}); !changed.empty())
        throw UserError{"commit first, since " + what + " is made of what is committed:\n" + changed};
}

} // namespace course
