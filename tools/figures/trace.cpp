#include "figures/trace.hpp"

#include "ground/files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace course {
namespace {

constexpr std::uintmax_t most_read = 64u << 20; // [bytes] a figure has thousands of rows; this is a program gone wild

std::vector<std::string> split(std::string_view line, char at) {
    std::vector<std::string> parts;
    for (std::size_t end; (end = line.find(at)) != line.npos; line.remove_prefix(end + 1))
        parts.emplace_back(line.substr(0, end));
    parts.emplace_back(line);
    return parts;
}

std::string_view without_return(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Whether a column's title is a name and a unit: "x[m]".
bool has_unit(std::string_view title) {
    const std::size_t open = title.find('[');
    return open != title.npos && open > 0 && title[open - 1] != ' ' && title.find(']') == title.size() - 1
           && open + 2 < title.size() && title.find('[', open + 1) == title.npos;
}

std::vector<std::string> parse_header(std::string_view line, const std::string &name) {
    std::vector<std::string> columns;
    if (line.starts_with("# ")) columns = split(line.substr(2), '\t');
    for (const std::string &title : columns)
        if (!has_unit(title))
            throw TraceFault{TraceFault::malformed, name + ", line 1: the column \"" + title
                                                        + "\" has no unit; write its name and unit, as in x[m]"};
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
                         where + ", column " + column + ": \"" + word + "\" is no number; write one"};
    if (!std::isfinite(number))
        throw TraceFault{TraceFault::not_finite,
                         where + ", column " + column + ": " + word
                             + " cannot be drawn; write an empty line where a curve has a gap",
                         column, word};
    return number;
}

Trace::Row parse_row(std::string_view line, std::size_t number, const Trace &trace, const std::string &name) {
    if (line.empty()) return {number, {}};
    const std::string where = name + ", line " + std::to_string(number);
    const std::vector<std::string> words = split(line, '\t');
    if (words.size() != trace.columns.size())
        throw TraceFault{TraceFault::malformed, where + " has " + std::to_string(words.size())
                                                    + " numbers, but line 1 names "
                                                    + std::to_string(trace.columns.size())
                                                    + " columns; write one for each, with tabs between them"};
    Trace::Row row{number, {}};
    for (std::size_t i = 0; i < words.size(); ++i)
        row.values.push_back(parse_number(words[i], trace.columns[i], where));
    return row;
}

std::string shown(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value); // no negative zero
    return text;
}

/// How far two values of this column may be apart.
double tolerance(double kept, double largest) {
    const double digit = kept == 0 ? 0 : std::pow(10, std::floor(std::log10(std::abs(kept))) - 5);
    return std::max(digit, 1e-12 * largest) * (1 + 1e-9); // exactly one unit still passes, whatever its own rounding
}

std::vector<double> largest_values(const Trace &trace) {
    std::vector<double> largest(trace.columns.size(), 0);
    for (const Trace::Row &row : trace.rows)
        for (std::size_t i = 0; i < row.values.size(); ++i) largest[i] = std::max(largest[i], std::abs(row.values[i]));
    return largest;
}

std::string joined(const std::vector<std::string> &words, const char *between) {
    std::string all;
    for (const std::string &word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

} // namespace

Trace parse_trace(std::string_view text, const std::string &name) {
    std::vector<std::string> lines = split(text, '\n');
    if (lines.back().empty()) lines.pop_back();
    if (lines.empty())
        throw TraceFault{TraceFault::empty, name + " is empty; a trace has a header and two rows or more"};

    Trace trace{parse_header(without_return(lines.front()), name), {}};
    std::size_t filled = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        trace.rows.push_back(parse_row(without_return(lines[i]), i + 1, trace, name));
        if (!trace.rows.back().values.empty()) ++filled;
    }
    if (filled < 2)
        throw TraceFault{TraceFault::empty, name + " has " + std::to_string(filled) + (filled == 1 ? " row" : " rows")
                                                + "; a figure needs two or more"};
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
    std::string text = "# " + joined(trace.columns, "\t") + '\n';
    for (const Trace::Row &row : trace.rows) {
        std::vector<std::string> words;
        for (double value : row.values) words.push_back(shown(value));
        text += joined(words, "\t") + '\n';
    }
    return text;
}

std::string difference(const Trace &kept, const Trace &now, const std::string &name) {
    if (kept.columns != now.columns)
        return name + ", the columns: they were " + joined(kept.columns, ", ") + ", they are "
               + joined(now.columns, ", ");

    const std::vector<double> largest = largest_values(kept);
    for (std::size_t row = 0; row < std::min(kept.rows.size(), now.rows.size()); ++row) {
        const auto &was = kept.rows[row].values, &is = now.rows[row].values;
        const std::string where = name + ", row " + std::to_string(row + 1);
        if (was.size() != is.size())
            return where + ": it was " + (was.empty() ? "a gap, it is a row" : "a row, it is a gap");
        for (std::size_t i = 0; i < was.size(); ++i)
            if (!(std::abs(was[i] - is[i]) <= tolerance(was[i], largest[i]))) {
                char today[32];
                std::snprintf(today, sizeof today, "%.9g", is[i]);
                return where + ", column " + kept.columns[i] + ": it was " + shown(was[i]) + ", it is " + today;
            }
    }
    if (kept.rows.size() == now.rows.size()) return "";
    return name + ": it had " + std::to_string(kept.rows.size()) + " rows, it has " + std::to_string(now.rows.size());
}

} // namespace course
