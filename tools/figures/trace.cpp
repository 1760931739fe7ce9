#include "figures/trace.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace course {
namespace {

constexpr std::uintmax_t most_read = 64u << 20; // [bytes] a figure has thousands of rows, so a larger file is a mistake

/// What is between the tabs.
std::vector<std::string> between_tabs(std::string_view line) {
    std::vector<std::string> parts;
    for (std::size_t end; (end = line.find('\t')) != line.npos; line.remove_prefix(end + 1))
        parts.emplace_back(line.substr(0, end));
    parts.emplace_back(line);
    return parts;
}

/// Whether a column's title is a name and a unit: "x[m]".
bool has_unit(std::string_view title) {
    const std::size_t open = title.find('[');
    return open != title.npos && open > 0 && title[open - 1] != ' ' && title.find(']') == title.size() - 1
           && open + 2 < title.size() && title.find('[', open + 1) == title.npos;
}

std::vector<std::string> parse_header(std::string_view line, const std::string &name) {
    std::vector<std::string> columns;
    if (line.starts_with("# ")) columns = between_tabs(line.substr(2));
    for (const std::string &title : columns)
        if (!has_unit(title))
            throw TraceFault{
                TraceFault::malformed,
                fmt::format("{}, line 1: the column \"{}\" has no unit; write its name and unit, as in x[m]", name,
                            title)};
    if (columns.empty())
        throw TraceFault{TraceFault::malformed,
                         name + ", line 1: a trace begins with its columns, as in \"# t[s]<tab>x[m]\""};
    return columns;
}

double parse_number(const std::string &word, const std::string &column, const std::string &where) {
    char *end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0')
        throw TraceFault{TraceFault::malformed,
                         fmt::format("{}, column {}: \"{}\" is no number; write one", where, column, word)};
    if (!std::isfinite(number))
        throw TraceFault{TraceFault::not_finite,
                         fmt::format("{}, column {}: {} cannot be drawn; write an empty line where a curve has a gap",
                                     where, column, word),
                         column, word};
    return number;
}

Trace::Row parse_row(std::string_view line, std::size_t number, const Trace &trace, const std::string &name) {
    if (line.empty()) return {number, {}};
    const std::string where = fmt::format("{}, line {}", name, number);
    const std::vector<std::string> words = between_tabs(line);
    if (words.size() != trace.columns.size())
        throw TraceFault{
            TraceFault::malformed,
            fmt::format("{} has {} numbers, but line 1 names {} columns; write one for each, with tabs between them",
                        where, words.size(), trace.columns.size())};
    Trace::Row row{number, {}};
    for (std::size_t i = 0; i < words.size(); ++i)
        row.values.push_back(parse_number(words[i], trace.columns[i], where));
    return row;
}

std::string six_digits(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); } // no negative zero

/// How far two values of this column may be apart.
double tolerance(double kept, double largest_value) {
    const double digit = kept == 0 ? 0 : std::pow(10, std::floor(std::log10(std::abs(kept))) - 5);
    return std::max(digit, 1e-12 * largest_value)
           * (1 + 1e-9); // exactly one unit still passes, however that was rounded
}

std::vector<double> largest_values(const Trace &trace) {
    std::vector<double> values(trace.columns.size(), 0);
    for (const Trace::Row &row : trace.rows)
        for (std::size_t i = 0; i < row.values.size(); ++i) values[i] = std::max(values[i], std::abs(row.values[i]));
    return values;
}

} // namespace

Trace parse_trace(std::string_view text, const std::string &name) {
    const std::vector<Line> lines = split_lines(text);
    if (lines.empty())
        throw TraceFault{TraceFault::empty, name + " is empty; a trace has a header and two rows or more"};

    Trace trace{parse_header(lines.front().text, name), {}};
    std::size_t filled = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        trace.rows.push_back(parse_row(lines[i].text, i + 1, trace, name));
        if (!trace.rows.back().values.empty()) ++filled;
    }
    if (filled < 2)
        throw TraceFault{TraceFault::empty, fmt::format("{} has {} {}; a figure needs two or more", name, filled,
                                                        filled == 1 ? "row" : "rows")};
    return trace;
}

Trace read_trace(const std::filesystem::path &path, const std::string &name) {
    std::error_code trouble;
    const std::uintmax_t size = std::filesystem::file_size(path, trouble);
    if (trouble)
        throw TraceFault{TraceFault::missing,
                         name + " is not there; the section's program writes it when it is run with --out"};
    if (size > most_read) throw TraceFault{TraceFault::malformed, name + " is larger than 64 MB; write fewer rows"};
    return parse_trace(read_file(path), name);
}

std::string rounded(const Trace &trace) {
    std::string text = fmt::format("# {}\n", fmt::join(trace.columns, "\t"));
    for (const Trace::Row &row : trace.rows) {
        std::vector<std::string> words;
        for (double value : row.values) words.push_back(six_digits(value));
        text += fmt::format("{}\n", fmt::join(words, "\t"));
    }
    return text;
}

std::string difference(const Trace &kept, const Trace &now, const std::string &name) {
    if (kept.columns != now.columns)
        return fmt::format("{}, the columns: they were {}, they are {}", name, fmt::join(kept.columns, ", "),
                           fmt::join(now.columns, ", "));

    const std::vector<double> largest_of_column = largest_values(kept);
    for (std::size_t row = 0; row < std::min(kept.rows.size(), now.rows.size()); ++row) {
        const auto &was = kept.rows[row].values, &is = now.rows[row].values;
        const std::string where = fmt::format("{}, row {}", name, row + 1);
        if (was.size() != is.size())
            return where + ": it was " + (was.empty() ? "a gap, it is a row" : "a row, it is a gap");
        for (std::size_t i = 0; i < was.size(); ++i)
            if (!(std::abs(was[i] - is[i]) <= tolerance(was[i], largest_of_column[i])))
                return fmt::format("{}, column {}: it was {}, it is {:.9g}", where, kept.columns[i], six_digits(was[i]),
                                   is[i]);
    }
    if (kept.rows.size() == now.rows.size()) return "";
    return fmt::format("{}: it had {} rows, it has {}", name, kept.rows.size(), now.rows.size());
}

} // namespace course
