#pragma once
// The files of tests/verdicts and tests/hostile hold one exercise, and include rest.hpp for the others. A check allows
// no headers of one's own, so what is checked has them in the file. And what of a verdict is compared.

#include "base/files.hpp"

#include <filesystem>
#include <regex>
#include <string>

/// Where a check stands in its file may change, and each libstdc++ has its own lines: the verdict is the same.
inline std::string without_lines(const std::string &text) {
    static const std::regex line{R"((see {7}tests/\w+/tests\.cpp|\| [\w.]+(?=:\d+: Assertion)):\d+)"};
    return std::regex_replace(text, line, "$1:…");
}

/// The file with the rest of rest.hpp below it, and each of its own lines where it was.
inline std::string whole_answer(const std::filesystem::path &file, const std::filesystem::path &rest_file) {
    const std::string marker = "#include \"rest.hpp\"";
    std::string text = course::read_file(file);
    const std::size_t at = text.find(marker);
    if (at == text.npos) return text;
    const std::string rest = course::read_file(rest_file);
    const std::string declared =
        "namespace segment_intersection { std::optional<LineIntersection> right_answer(const Segment &, "
        "const Segment &); }";
    text.insert(text.find('\n', at) + 1, declared); // on the empty line below
    text.replace(at, marker.size(), "#include \"segment_intersection.hpp\"");
    return text + '\n' + rest.substr(rest.find("\nnamespace"));
}
