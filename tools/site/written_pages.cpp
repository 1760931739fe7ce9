#include "site/written_pages.hpp"

#include "ground/files.hpp"
#include "site/addresses.hpp"
#include "site/book_parts.hpp"
#include "site/demos.hpp"
#include "site/front.hpp"

namespace course {
namespace fs = std::filesystem;

std::vector<WrittenPage> written_pages(const Tree &tree) {
    const fs::path book = tree.root / "book.md";
    std::vector<WrittenPage> pages{{"index", tree.root / "docs" / "front.md", front_page(tree)}};
    for (const BookPart &part : book_parts(read_file(book))) pages.push_back({part.name, book, part.text});
    for (const fs::path &file : markdown_pages(tree))
        if (file != book) pages.push_back({page_name(tree, file), file, read_file(file)});
    if (const std::string all = play_page(tree); !all.empty()) pages.push_back({"play", book, all});
    return pages;
}

} // namespace course
