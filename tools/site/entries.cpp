#include "site/entries.hpp"

#include "ground/lines.hpp"
#include "site/addresses.hpp"
#include "site/table.hpp"

#include <regex>

namespace course {

std::vector<Entry> entries(const Tree &tree, std::string_view book) {
    static const std::regex row{R"(\|\s*\d+\s*\|.*)"}, link{R"(\[([^\]]*)\]\(([^)#]*)\))"};
    std::vector<Entry> result;
    for (const Line &line : lines_of(book)) {
        if (!std::regex_match(line.text.begin(), line.text.end(), row)) continue;
        const std::vector<std::string> cells = cells_of(line.text);
        if (cells.size() < 2) continue;
        Entry entry{cells[0], cells[1], cells.size() > 3 ? cells[3] : "", ""};
        if (std::smatch found; std::regex_search(cells[1], found, link)) {
            entry.title = found[1];
            entry.page = page_name(tree, (tree.root / found[2].str()).lexically_normal());
        }
        result.push_back(entry);
    }
    return result;
}

} // namespace course
