#include "base/hash.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/process.hpp"

namespace course {
namespace fs = std::filesystem;

std::vector<std::string> sha256_of(const std::vector<fs::path> &files) {
    std::vector<std::string> command{"sha256sum", "--"}, all;
    for (const fs::path &file : files) command.push_back(file.string());
    if (files.empty()) return all;
    const Finished done = run(command);
    for (const Line &line : split_lines(done.out)) all.emplace_back(line.text.substr(0, 64));
    if (done.code != 0 || all.size() != files.size())
        throw UserError{"sha256sum can't read what is to be judged: " + done.err};
    return all;
}

std::string sha256(std::string_view text) {
    const Scratch scratch{temporary_files() / "course-hash"};
    if (scratch.folder.empty()) throw EnvironmentError{"no folder can be made for a text; is the disk full?"};
    write_file(scratch.folder / "text", std::string{text});
    return sha256_of({scratch.folder / "text"}).front();
}

} // namespace course
