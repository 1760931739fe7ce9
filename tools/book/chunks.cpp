#include "book/chunks.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"

#include <regex>

namespace course {
namespace fs = std::filesystem;

std::optional<std::string> mark_title(std::string_view line) {
    line = trim(line);
    for (const std::string_view mark : {"//>", "#>"})
        if (line.starts_with(mark)) return std::string{trim(line.substr(mark.size()))};
    return {};
}

std::vector<Chunk> cut(const fs::path &file) {
    const std::string text = read_file(file);
    std::vector<Chunk> chunks;
    bool visible = false;
    int number = 0;
    for (const Line &line : split_lines(std::string_view{text}.substr(byte_order_mark(text).size()))) {
        ++number;
        const auto title = mark_title(line.text);
        if (title) visible = !title->empty();
        if (title && visible) chunks.push_back({*title, file, number, {}});
        if (visible && !trim(line.text).starts_with("COURSE_FIELDS(")) chunks.back().lines.emplace_back(line.text);
    }
    for (Chunk &chunk : chunks)
        while (trim(chunk.lines.back()).empty()) chunk.lines.pop_back();
    return chunks;
}

std::optional<Finding> unmarked_code(const fs::path &file) {
    static const std::regex start_of_a_file{
        R"(\s*(#\s*(include|pragma)\b.*|using\b.*|(inline )?namespace\b[^{]*\{?\s*|//.*)?)"};
    static const std::regex gnuplot_comment{R"(\s*(#.*)?)"};
    const std::regex &harmless = file.extension() == ".gp" ? gnuplot_comment : start_of_a_file;

    const std::string text = read_file(file);
    int number = 0;
    bool in_comment = false; // one of the kind /* ... */
    for (const Line &line : split_lines(std::string_view{text}.substr(byte_order_mark(text).size()))) {
        ++number;
        if (mark_title(line.text)) return {};
        const bool opens = trim(line.text).starts_with("/*");
        in_comment = in_comment || opens;
        if (!in_comment && !std::regex_match(line.text.begin(), line.text.end(), harmless))
            return Finding{file, number,
                           "this code is above the first mark, so no chapter can show it; put a line `"
                               + std::string{file.extension() == ".gp" ? "#>" : "//>"}
                               + " Title` above it, or the same without a title if it is to stay out."};
        if (without_blanks_behind(line.text).ends_with("*/")) in_comment = false;
    }
    return {};
}

} // namespace course
