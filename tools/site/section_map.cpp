#include "site/section_map.hpp"

#include "book/prerequisites.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"
#include "site/html.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace course {
namespace {

// As wide as a figure, so that its letters are as large as theirs.
constexpr double map_width = 480, box_width = 144, box_height = 46, slot_height = 56; // [px]

/// A line to a stop from one in the column before.
struct Join {
    int from = 0;
    bool in_part = false; ///< only one exercise needs what is there
};

/// A place in a column of the map: a section, or the place where a line passes from one column to the next but one.
struct Stop {
    int section = 0; ///< 0: a line passes
    std::vector<Join> joins;
    double y = 0; ///< of its middle [px]
};

/// Sections in columns: what needs nothing is in the first, and each other one is behind all that it needs.
class MapColumns {
  public:
    explicit MapColumns(const std::vector<Entry> &entries) {
        for (const Entry &entry : entries) place(entry);
        for (std::size_t k = 1; k < columns.size(); ++k) sort(k);
        for (auto &column : columns)
            for (std::size_t i = 0; i < column.size(); ++i)
                stops[static_cast<std::size_t>(column[i])].y =
                    height() * (static_cast<double>(i) + 0.5) / static_cast<double>(column.size());
    }

    std::size_t count() const { return columns.size(); }
    double height() const {
        std::size_t most = 0;
        for (const auto &column : columns) most = std::max(most, column.size());
        return slot_height * static_cast<double>(most);
    }
    /// The middle of a column.
    double x(std::size_t column) const {
        const double free = map_width - box_width;
        return box_width / 2
               + (count() < 2 ? 0 : free * static_cast<double>(column) / static_cast<double>(count() - 1));
    }
    template <class Visit> void each(Visit visit) const {
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (const int stop : columns[k]) visit(k, stops[static_cast<std::size_t>(stop)]);
    }
    const Stop &stop(int number) const { return stops[static_cast<std::size_t>(number)]; }

  private:
    struct Known {
        int stop = 0;
        std::size_t column = 0;
    };

    int add(std::size_t column, Stop stop) {
        if (columns.size() <= column) columns.resize(column + 1);
        stops.push_back(std::move(stop));
        columns[column].push_back(static_cast<int>(stops.size()) - 1);
        return columns[column].back();
    }

    void place(const Entry &entry) {
        std::size_t column = 0;
        const std::vector<Prerequisite> needed = read_needs(entry.needs);
        for (const auto &[section, exercise] : needed)
            if (known.contains(section)) column = std::max(column, known[section].column + 1);
        Stop stop{.section = entry.number, .joins = {}};
        for (const auto &[section, exercise] : needed) {
            if (!known.contains(section)) continue;
            int before = known[section].stop;
            for (std::size_t k = known[section].column + 1; k < column; ++k)
                before = add(k, {0, {{before, !exercise.empty()}}});
            stop.joins.push_back({before, !exercise.empty()});
        }
        known[entry.number] = {add(column, stop), column};
    }

    /// Beside what is before them, so that few lines cross.
    void sort(std::size_t k) {
        std::map<int, std::size_t> rank;
        for (std::size_t i = 0; i < columns[k - 1].size(); ++i) rank[columns[k - 1][i]] = i;
        const auto middle = [&](int number) {
            double sum = 0;
            for (const Join &join : stop(number).joins) sum += static_cast<double>(rank[join.from]);
            return sum / static_cast<double>(stop(number).joins.size());
        };
        std::stable_sort(columns[k].begin(), columns[k].end(), [&](int a, int b) { return middle(a) < middle(b); });
    }

    std::vector<Stop> stops;
    std::vector<std::vector<int>> columns; ///< of stops
    std::map<int, Known> known;            ///< by section
};

std::string line_between(double from_x, double from_y, double to_x, double to_y, bool in_part) {
    const double middle = (from_x + to_x) / 2;
    return fmt::format("<path{} d=\"M{:.0f} {:.0f}C{:.0f} {:.0f} {:.0f} {:.0f} {:.0f} {:.0f}\"/>\n",
                       in_part ? " class=\"in-part\"" : "", from_x, from_y, middle, from_y, middle, to_y, to_x, to_y);
}

/// In one line or in two, broken at the blank that is nearest to the middle.
std::string words_in_box(const std::string &words, double x, double y) {
    constexpr std::size_t longest_line = 15;
    std::size_t cut = words.npos;
    if (words.size() > longest_line)
        for (std::size_t at = words.find(' ', 3); at != words.npos; at = words.find(' ', at + 1))
            if (cut == words.npos || std::max(at, words.size() - at) < std::max(cut, words.size() - cut)) cut = at;
    const auto line = [&](const std::string &text, double below) {
        return fmt::format("<tspan x=\"{:.0f}\" y=\"{:.0f}\">{}</tspan>", x, y + below, escaped(text));
    };
    if (cut == words.npos) return "<text>" + line(words, 5) + "</text>";
    return "<text>" + line(words.substr(0, cut), -4) + ' ' + line(words.substr(cut + 1), 15) + "</text>";
}

std::string box_of_section(const Tree &tree, const Entry &entry, double x, double y) {
    const std::string words = std::to_string(entry.number) + ' ' + entry.title;
    const std::string label =
        words + (entry.chapter.empty() ? ", to come" : "") + (entry.needs.empty() ? "" : ": needs " + entry.needs);
    const std::string box = fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" rx=\"8\"/>",
                                        x - box_width / 2, y - box_height / 2, box_width, box_height)
                            + words_in_box(words, x, y);
    if (entry.chapter.empty()) return "<g class=\"to-come\"><title>" + escaped(label) + "</title>" + box + "</g>\n";
    return "<a href=\"" + page_name(tree, tree.root / entry.chapter) + ".html\" aria-label=\"" + escaped(label) + "\">"
           + box + "</a>\n";
}

} // namespace

std::string section_map(const Tree &tree, const std::vector<Entry> &entries) {
    const MapColumns columns{entries};
    if (columns.count() < 2) return "";
    std::string lines, boxes;
    columns.each([&](std::size_t k, const Stop &stop) {
        const double left = columns.x(k) - box_width / 2, right = columns.x(k) + box_width / 2;
        for (const auto &[from, in_part] : stop.joins)
            lines += line_between(columns.x(k - 1) + box_width / 2, columns.stop(from).y, left, stop.y, in_part);
        if (stop.section == 0) lines += line_between(left, stop.y, right, stop.y, stop.joins[0].in_part);
        const auto entry = std::ranges::find(entries, stop.section, &Entry::number);
        if (entry != entries.end()) boxes += box_of_section(tree, *entry, columns.x(k), stop.y);
    });
    return fmt::format(
               "<svg class=\"map\" viewBox=\"-2 0 {:.0f} {:.0f}\" role=\"group\" aria-label=\"Which section needs "
               "which\">\n",
               map_width + 4, columns.height())
           + lines + boxes + "</svg>";
}

} // namespace course
