#include "loop/includes.hpp"

#include <algorithm>
#include <string>

namespace course {
namespace fs = std::filesystem;
namespace {

/// The files of a rule for make, which writes `\ ` for a blank, `\#` for # and `$$` for $, and ends lines with `\`.
std::vector<std::string> files_of(std::string_view rule) {
    std::vector<std::string> files(1);
    const auto next = [&](std::size_t i) { return i + 1 < rule.size() ? rule[i + 1] : '\0'; };
    rule.remove_prefix(std::min(rule.find(": "), rule.size()));
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const bool escaped =
            (rule[i] == '\\' && (next(i) == ' ' || next(i) == '#')) || (rule[i] == '$' && next(i) == '$');
        if (escaped) files.back() += rule[++i];
        else if (rule[i] == ' ' || rule[i] == '\n' || (rule[i] == '\\' && next(i) == '\n')) files.emplace_back();
        else files.back() += rule[i];
    }
    files.front().clear(); // the colon
    std::erase(files, "");
    return files;
}

bool is_below(const fs::path &file, const fs::path &folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

} // namespace

std::optional<fs::path> included_from_elsewhere(std::string_view rule, const fs::path &file, const fs::path &from,
                                                const std::vector<fs::path> &allowed) {
    std::error_code ignored;
    std::vector<fs::path> folders;
    for (const fs::path &folder : allowed) folders.push_back(fs::weakly_canonical(folder, ignored));
    const fs::path own = fs::weakly_canonical(file, ignored);
    for (const std::string &name : files_of(rule)) {
        const fs::path read = fs::weakly_canonical(from / name, ignored);
        const auto is_home = [&](const fs::path &folder) { return is_below(read, folder); };
        if (read != own && std::none_of(folders.begin(), folders.end(), is_home)) return read;
    }
    return {};
}

} // namespace course
