#include "ground/repository.hpp"

#include "ground/files.hpp"
#include "ground/process.hpp"

#include <regex>

namespace course {

std::string version_of(const Tree &tree) {
    static const std::regex version{R"(project\(\w+ VERSION ([\d.]+))"};
    std::smatch found;
    const std::string text = read_file(tree.root / "CMakeLists.txt");
    if (!std::regex_search(text, found, version)) throw Complaint{"CMakeLists.txt has no project(… VERSION 1.2.3)"};
    return found[1];
}

std::string printed_by(const std::vector<std::string> &command, const std::filesystem::path &folder) {
    const Finished done = run(command, {.folder = folder});
    if (done.code != 0) throw Complaint{command[0] + ' ' + command[1] + " failed: " + done.err};
    return done.out;
}

std::string git_in(const std::filesystem::path &repository, std::vector<std::string> words) {
    const std::string what = words.front();
    words.insert(words.begin(), {"git", "-c", "user.name=Frame by Frame", "-c", "user.email=course@localhost", "-c",
                                 "commit.gpgsign=false"});
    const Finished done = run(words, {.folder = repository});
    if (done.code != 0) throw Complaint{"git " + what + " failed: " + done.err.substr(0, done.err.find('\n'))};
    return done.out;
}

void require_committed(const Tree &tree, const std::string &what) {
    if (const std::string changed = git_in(tree.root, {"status", "--porcelain"}); !changed.empty())
        throw Complaint{"commit first, since " + what + " is made of what is committed:\n" + changed};
}

} // namespace course
