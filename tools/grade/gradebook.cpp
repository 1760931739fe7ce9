#include "grade/gradebook.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace course {
namespace {

using CsvRow = std::vector<CsvCell>;

std::string text_of_gradebook(const std::filesystem::path &file) {
    std::string text = read_file(file);
    constexpr auto remedy = "Download it again, or save it as CSV with the encoding UTF-8.";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") || contains(text, std::string_view{"\0", 1}))
        throw UserError{fmt::format("{} is UTF-16, or no text at all. {}", file.string(), remedy)};
    for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
        length = utf8_length(std::string_view{text}.substr(at));
        if (length == 0)
            throw UserError{fmt::format("{}, line {}, isn't UTF-8. {}", file.string(), line_at(text, at), remedy)};
    }
    return text;
}

std::optional<std::size_t> column_named(const CsvRow &header, std::string_view name) {
    const auto cell = std::ranges::find(header, name, &CsvCell::text);
    if (cell == header.end()) return {};
    return static_cast<std::size_t>(cell - header.begin());
}

std::string shown_cell(const CsvCell &cell) { return '`' + plain_line(cell.text, 100) + '`'; }

/// "`HW 5 (4711)`, `HW 6 (4712)`"
std::string shown_cells(const CsvRow &cells) {
    std::string all;
    for (const CsvCell &cell : cells) all += (all.empty() ? "" : ", ") + shown_cell(cell);
    return all.empty() ? "none" : all;
}

/// "10", "7.50", "7,5". Three digits behind a comma may be a thousand: "1,000" is no number that we'd trust.
std::optional<double> number_in(std::string_view cell) {
    std::string text{trim(cell)};
    const std::size_t sign = std::min(text.find_first_of(".,"), text.size());
    const std::string behind = text.substr(std::min(sign + 1, text.size()));
    if (!is_all_digits(text.substr(0, sign)) || (sign < text.size() && !is_all_digits(behind))) return {};
    if (sign < text.size() && text[sign] == ',' && behind.size() == 3) return {};
    std::ranges::replace(text, ',', '.');
    double value = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) return {};
    return value;
}

/// An assignment's title without the number that Canvas puts behind it: "HW 5" of "HW 5 (4711)"; nothing if it's none.
std::optional<std::string_view> canvas_assignment(std::string_view title) {
    const std::size_t open = title.rfind(" (");
    if (open == title.npos || !title.ends_with(')')) return {};
    if (!is_all_digits(title.substr(open + 2, title.size() - open - 3))) return {};
    return title.substr(0, open);
}

/// Whether this is the section's name and no more: "HW 5", "5 Inclined planes", "Section 05: inclined_planes". It's not
/// "Quiz 5", "Exercise 5.2", "Inclined planes quiz", and "Time-based motion" isn't `motion`.
bool names_section(std::string_view title, const Section &section) {
    std::string squeezed; // letters and digits, with a blank only between two numbers
    bool gap = false;
    for (const char c : lower(title)) {
        const bool counts = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (counts && gap && is_digit(c) && !squeezed.empty() && is_digit(squeezed.back())) squeezed += ' ';
        if (counts) squeezed += c;
        gap = !counts;
    }
    std::string_view rest = squeezed;
    for (const std::string_view kind : {"homework", "hw", "section", "chapter", "assignment", "exercises", "exercise"})
        if (squeezed.starts_with(kind)) rest = std::string_view{squeezed}.substr(kind.size());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits > 0 && leading_number(rest) != section.number()) return false;
    rest.remove_prefix(digits);
    std::string slug = section.slug();
    std::erase(slug, '_');
    return rest == slug || (digits > 0 && rest.empty());
}

/// The titles that `column` may mean: the whole one, else one without the number, else those that it's a part of.
CsvRow meant_by(const std::string &column, const CsvRow &header) {
    CsvRow whole, without_number, parts;
    for (const CsvCell &cell : header) {
        const auto name = canvas_assignment(cell.text);
        if (cell.text == column) whole.push_back(cell);
        if (name == column) without_number.push_back(cell);
        if (name && contains(lower(cell.text), lower(column))) parts.push_back(cell);
    }
    return !whole.empty() ? whole : !without_number.empty() ? without_number : parts;
}

/// "1 day 2 hours" of "Submitted for grading - 1 day 2 hours late - Graded". Moodle counts from what's due for this
/// student, with extensions.
std::string lateness_in(std::string_view status) {
    constexpr std::string_view dash = " - ", late = " late";
    while (!status.empty()) {
        const std::string_view part = status.substr(0, status.find(dash));
        if (part.ends_with(late)) return std::string{part.substr(0, part.size() - late.size())};
        status.remove_prefix(std::min(part.size() + dash.size(), status.size()));
    }
    return "";
}

/// A comment as Moodle reads it, which is HTML, and that no spreadsheet takes for a formula.
std::string harmless(const std::string &comment) {
    std::string line = escaped(plain_line(comment, 5000));
    replace_all(line, "&quot;", "\""); // reads better in the file
    const std::string_view start = trim(line).substr(0, 1);
    return is_any_of(start, {"=", "+", "-", "@"}) ? "'" + line : line;
}

} // namespace

Gradebook::Gradebook(const std::filesystem::path &file, const Section &section, const std::string &column)
    : file_{file.string()}, text{text_of_gradebook(file)}, csv{read_csv(text, file_)} {
    if (csv.rows.empty()) throw UserError{file_ + " is empty: download it again."};
    const auto has = [&](Words names) {
        return std::ranges::all_of(names, [&](auto name) { return column_named(csv.rows.front(), name).has_value(); });
    };
    if (has({"Student", "ID"}) || has({"LastName", "FirstName", "ID"})) read_canvas(section, column);
    else if (has({"Identifier", "Grade", "Maximum Grade", "Last modified (grade)"})) read_moodle(column);
    else if (has({"student_repository_name", "points_awarded"})) read_classroom(column);
    else
        throw UserError{fmt::format("{} is neither Canvas' gradebook, with columns `Student` and `ID`, nor Moodle's "
                                    "worksheet, with `Identifier`, "
                                    "`Grade`, `Maximum Grade` and `Last modified (grade)`, nor the grades of GitHub "
                                    "Classroom, with `student_repository_name`. Its columns are {}. Is it "
                                    "Moodle's, in another language? "
                                    "Set Moodle's language to English, and download the worksheet again.",
                                    file_, shown_cells(csv.rows.front()))};
    std::set<std::string> ids;
    for (std::size_t i = 0; i < people.size(); ++i) // in GitHub Classroom, a group has one repository
        if (!ids.insert(people[i].id).second && platform_ != Platform::classroom)
            complain(places[i].grade, people[i].id + " is there twice. Take one of the two rows out.");
}

void Gradebook::complain(const CsvCell &cell, const std::string &what) const {
    throw UserError{fmt::format("{}, line {}: {}", file_, line_at(text, cell.begin), what)};
}

void Gradebook::check_length(const std::vector<CsvCell> &row) const {
    const std::size_t want = csv.rows.front().size();
    if (row.size() != want)
        complain(row.front(),
                 fmt::format("{} instead of {}. Download the file again.", pluralize(row.size(), "cell"), want));
}

void Gradebook::learn_decimal_sign(const CsvCell &cell) {
    const std::size_t sign = cell.text.find_first_of(".,");
    if (sign == cell.text.npos || !number_in(cell.text)) return;
    if (decimal_sign != 0 && decimal_sign != cell.text[sign])
        complain(cell,
                 fmt::format("{} has its decimals behind a `{}`, and numbers above behind a `{}`. Make them the same.",
                             shown_cell(cell), cell.text[sign], decimal_sign));
    decimal_sign = cell.text[sign];
}

void Gradebook::set_most(const CsvCell &cell) {
    constexpr double too_many = 1e6; // and hundredths of it fit into any number
    most_ = number_in(cell.text).value_or(0);
    if (most_ > 0 && most_ < too_many) return;
    const bool canvas = platform_ == Platform::canvas;
    complain(
        cell,
        fmt::format("the {} should be a number above 0 and below 1000000, and is {}. {}, and download the file again.",
                    canvas ? "Points Possible of `" + plain_line(title, 100) + '`' : "Maximum Grade", shown_cell(cell),
                    canvas ? "Give the assignment points in Canvas"
                           : "Set the grade's type to points in Moodle, since there's no scale that we know"));
}

std::size_t Gradebook::column_of_assignment(const std::vector<CsvCell> &possible, const Section &section,
                                            const std::string &column) const {
    const CsvRow &header = csv.rows.front();
    CsvRow open, meant; // an assignment without points that we know is open, too: it may be the one that's meant
    for (std::size_t i = 0; i < header.size(); ++i) {
        const bool writable = !contains(possible[i].text, "read only");
        if (writable && canvas_assignment(header[i].text)) open.push_back(header[i]);
    }
    if (!column.empty()) meant = meant_by(column, header);
    else if (open.size() == 1) meant = open;
    else
        std::ranges::copy_if(open, std::back_inserter(meant), [&](const CsvCell &cell) {
            return names_section(*canvas_assignment(cell.text), section);
        });
    if (meant.size() != 1)
        throw UserError{fmt::format("{}: {} is {}. Say which one, with --column and its title: {}.", file_,
                                    meant.empty() ? "no column" : "more than one column",
                                    column.empty() ? "clearly that of section " + section.short_number()
                                                   : "what `" + plain_line(column, 100) + "` means",
                                    shown_cells(meant.empty() ? open : meant))};
    if (std::ranges::find(open, meant.front().begin, &CsvCell::begin) == open.end())
        throw UserError{fmt::format("{}: {} can't be written to, since it's read only, or no assignment. Say --column "
                                    "with one of these: {}.",
                                    file_, shown_cell(meant.front()), shown_cells(open))};
    return *column_named(header, meant.front().text);
}

void Gradebook::read_canvas(const Section &section, const std::string &column) {
    const CsvRow &header = csv.rows.front();
    const auto first_name = column_named(header, "FirstName");
    const std::size_t id = *column_named(header, "ID"),
                      name = *column_named(header, first_name ? "LastName" : "Student");
    const auto possible =
        std::ranges::find_if(csv.rows, [](const CsvRow &row) { return trim(row.front().text) == "Points Possible"; });
    if (possible == csv.rows.end())
        throw UserError{file_ + " has no row `Points Possible`: export the gradebook from Canvas again."};
    check_length(*possible); // of another length if a spreadsheet has split 20,00
    const std::size_t at = column_of_assignment(*possible, section, column);
    title = header[at].text;
    set_most((*possible)[at]);
    std::ranges::for_each(*possible, [&](const CsvCell &cell) { learn_decimal_sign(cell); });
    for (std::size_t i = 0; i < header.size(); ++i)
        if (i == at
            || is_any_of(header[i].text, {"Student", "LastName", "FirstName", "ID", "SIS User ID", "SIS Login ID",
                                          "Integration ID", "Root Account", "Section"}))
            kept.insert(i);
    for (const CsvRow &row : csv.rows) {
        const std::string number{row.size() > id ? trim(row[id].text) : ""};
        if (&row == &header || &row == &*possible || number.empty()) continue;
        check_length(row);
        if (!is_all_digits(number))
            complain(row[id],
                     fmt::format("the ID is {}, and should be a number. Has a spreadsheet changed it? Export the "
                                 "gradebook from Canvas again.",
                                 shown_cell(row[id])));
        learn_decimal_sign(row[at]);
        const std::string was = lower(trim(row[at].text));
        people.push_back({number, row[name].text + (first_name ? ", " + row[*first_name].text : ""), row[at].text, "",
                          was == "ex"    ? "is excused (EX)"
                          : was == "n/a" ? "isn't assigned this (N/A)"
                                         : ""});
        places.push_back({row[at], {}});
    }
    doubt_column();
}

void Gradebook::doubt_column() {
    for (const std::string_view words :
         {"Current Score", "Current Points", "Current Grade", "Final Score", "Final Points", "Final Grade",
          "Override Score", "Override Grade", "Override Status"})
        if (contains(title, words))
            doubts.push_back(fmt::format("Canvas won't import `{}`, since it passes over titles with `{}` in them. "
                                         "Rename the assignment there, and export again.",
                                         plain_line(title, 100), words));
    const auto worded = std::ranges::find_if(people, [](const Person &row) {
        const std::string_view was = trim(row.was);
        return row.locked.empty() && !was.empty() && was != "-" && !number_in(was);
    });
    if (worded != people.end())
        doubts.push_back(fmt::format("{} has `{}`, and Canvas may drop numbers there. Set the assignment's Display "
                                     "Grade as to Points, and export again.",
                                     worded->id, plain_line(worded->was, 20)));
}

void Gradebook::read_moodle(const std::string &column) {
    platform_ = Platform::moodle;
    title = "Grade";
    require_its_only_column(column);
    const CsvRow &header = csv.rows.front();
    const std::size_t id = *column_named(header, "Identifier"), at = *column_named(header, title),
                      most = *column_named(header, "Maximum Grade");
    const auto name = column_named(header, "Full name"), comment = column_named(header, "Feedback comments"),
               changeable = column_named(header, "Grade can be changed"), status = column_named(header, "Status");
    has_status = status.has_value();
    for (const CsvRow &row : csv.rows) {
        if (&row == &header || (row.size() == 1 && row.front().text.empty())) continue;
        check_length(row);
        constexpr std::string_view word = "Participant ";
        const std::string number = row[id].text.starts_with(word) ? row[id].text.substr(word.size()) : "";
        if (!is_all_digits(number))
            complain(row[id], fmt::format("the Identifier is {}, and should be like `Participant 1003`. Set Moodle's "
                                          "language to English, and download the worksheet again.",
                                          shown_cell(row[id])));
        const double above = most_;
        set_most(row[most]);
        if (above != 0 && above != most_)
            complain(row[most],
                     fmt::format("the Maximum Grade is {}, but {} above. Is this one assignment's worksheet? "
                                 "Download it again.",
                                 shown_cell(row[most]), above));
        for (const std::size_t cell : {most, at}) learn_decimal_sign(row[cell]);
        const bool locked = changeable && row[*changeable].text != "Yes";
        people.push_back({number, row[name.value_or(id)].text, row[at].text,
                          status ? lateness_in(row[*status].text) : "", locked ? "can't be changed in Moodle" : ""});
        places.push_back({row[at], comment ? row[*comment] : CsvCell{}});
    }
}

void Gradebook::read_classroom(const std::string &column) {
    platform_ = Platform::classroom;
    title = "points_awarded";
    require_its_only_column(column);
    const CsvRow &header = csv.rows.front();
    const std::size_t repository = *column_named(header, "student_repository_name"), at = *column_named(header, title);
    const auto name = column_named(header, "roster_identifier"), handle = column_named(header, "github_username");
    for (const CsvRow &row : csv.rows) {
        if (&row == &header || (row.size() == 1 && row.front().text.empty())) continue;
        check_length(row);
        if (row[repository].text.empty()) continue; // who hasn't accepted the assignment has no repository
        const std::string roster = name ? row[*name].text : "";
        people.push_back({row[repository].text, roster.empty() ? row[handle.value_or(repository)].text : roster,
                          row[at].text, "", ""});
        places.push_back({row[at], {}});
    }
}

void Gradebook::require_its_only_column(const std::string &column) const {
    if (!column.empty() && column != title)
        throw UserError{fmt::format("{} is from {}, where grades go to the column `{}`: leave out --column.", file_,
                                    name_of(platform_), title)};
}

std::string Gradebook::grade(double share) const {
    if (!(share >= 0 && share <= 1)) throw std::invalid_argument{"a share of the points is from 0 to 1"};
    const auto hundredths = static_cast<long long>(std::floor(share * most_ * 100 + 0.5 + 1e-6));
    std::string text_of_it = fmt::format("{}.{:02}", hundredths / 100, hundredths % 100);
    text_of_it.erase(text_of_it.find_last_not_of('0') + 1);
    if (text_of_it.ends_with('.')) text_of_it.pop_back();
    if (decimal_sign == ',') std::ranges::replace(text_of_it, '.', ',');
    return text_of_it;
}

std::string Gradebook::filled(const std::map<std::string, Entered> &grades) const {
    std::map<std::size_t, std::string> cells;
    for (std::size_t i = 0; i < people.size(); ++i) {
        const auto given = grades.find(people[i].id);
        if (given == grades.end() || !people[i].locked.empty()) continue;
        const std::string now = grade(given->second.share);
        if (number_in(people[i].was) != number_in(now)) cells[places[i].grade.begin] = now;
        if (places[i].comment.begin > 0 && !given->second.comment.empty())
            cells[places[i].comment.begin] = harmless(given->second.comment);
    }
    return with_cells(text, csv, cells, kept);
}

} // namespace course
