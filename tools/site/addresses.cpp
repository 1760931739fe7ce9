#include "site/addresses.hpp"

#include "book/links.hpp"
#include "book/weaver.hpp"
#include "ground/files.hpp"
#include "ground/text.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

Addresses::Addresses(const Tree &tree_)
    : tree{tree_}, parts{book_parts(read_file(tree.root / "book.md"))}, code{page_of_book(tree).code} {
    for (const fs::path file : {"tests/section_test.hpp", "plots/style.gp"})
        if (fs::exists(tree.root / file)) code.push_back(tree.root / file);
    for (const Section &section : tree.sections()) {
        markdown.push_back(tree.chapter(section));
        const std::vector<fs::path> own = page_of(tree, section).code;
        code.insert(code.end(), own.begin(), own.end());
    }
    for (const fs::path &folder : {tree.root, tree.root / "docs"})
        for (const fs::path &file : files_in(folder, ".md"))
            if (file.filename() != "book.md" && file.filename() != "front.md") markdown.push_back(file);
}

std::string page_name(const Tree &tree, const fs::path &file) {
    if (file.filename() == "README.md" && file.parent_path() != tree.root)
        return "chapter_" + file.parent_path().filename().string();
    if (file == tree.root / "book.md") return "index";
    const bool is_code = file.extension() != ".md";
    std::string name = is_code ? "source_" + tree.shown(file) : file.stem().string();
    for (char &c : name)
        c = std::isalnum(static_cast<unsigned char>(c)) ? is_code ? c : static_cast<char>(std::tolower(c)) : '_';
    return name;
}

std::optional<std::string> Addresses::of(const fs::path &file, const std::string &url) const {
    const fs::path book = tree.root / "book.md";
    if (is_on_the_web(url) || (url.starts_with('#') && file != book)) return url;
    const auto hash = std::min(url.find('#'), url.size());
    fs::path target = hash == 0 ? file : (file.parent_path() / unescaped(url.substr(0, hash))).lexically_normal();
    if (target == book) return book_address(parts, url.substr(std::min(hash + 1, url.size())));
    if (!target.has_filename()) target = target.parent_path();
    if (fs::is_directory(target)) target /= "README.md"; // which a forge shows there
    for (const auto *pages : {&markdown, &code})
        if (std::ranges::find(*pages, target) != pages->end())
            return page_name(tree, target) + ".html" + url.substr(hash);
    if (target.extension() == ".svg" || target.extension() == ".png") return tree.shown(target);
    return {};
}

} // namespace course
