#include "site/addresses.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/links.hpp"
#include "book/weaver.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

Addresses::Addresses(const Workspace &tree_)
    : workspace{tree_}, parts{book_parts(read_file(workspace.root / "book.md"))}, code{page_of_book(workspace).code} {
    for (const fs::path file : {"tests/section_test.hpp", "plots/style.gp"})
        if (fs::exists(workspace.root / file)) code.push_back(workspace.root / file);
    for (const Section &section : workspace.sections()) {
        markdown.push_back(workspace.chapter(section));
        const std::vector<fs::path> own = page_of(workspace, section).code;
        code.insert(code.end(), own.begin(), own.end());
    }
    for (const fs::path &folder : {workspace.root, workspace.root / "docs"})
        for (const fs::path &file : files_in(folder, ".md"))
            if (file.filename() != "book.md" && file.filename() != "front.md") markdown.push_back(file);
}

std::string page_name(const Workspace &workspace, const fs::path &file) {
    if (file.filename() == "README.md" && file.parent_path() != workspace.root)
        return "chapter_" + file.parent_path().filename().string();
    if (file == workspace.root / "book.md") return "index";
    const bool is_code = file.extension() != ".md";
    std::string name = is_code ? "source_" + workspace.relative_name(file) : file.stem().string();
    for (char &c : name)
        c = std::isalnum(static_cast<unsigned char>(c)) ? is_code ? c : static_cast<char>(std::tolower(c)) : '_';
    return name;
}

std::optional<std::string> Addresses::of(const fs::path &file, const std::string &url) const {
    const fs::path book = workspace.root / "book.md";
    if (is_on_the_web(url) || (url.starts_with('#') && file != book)) return url;
    const auto hash = std::min(url.find('#'), url.size());
    fs::path target = hash == 0 ? file : (file.parent_path() / unescaped(url.substr(0, hash))).lexically_normal();
    if (target == book) return book_address(parts, url.substr(std::min(hash + 1, url.size())));
    if (!target.has_filename()) target = target.parent_path();
    if (fs::is_directory(target)) target /= "README.md"; // which a forge shows there
    for (const auto *pages : {&markdown, &code})
        if (std::ranges::find(*pages, target) != pages->end())
            return page_name(workspace, target) + ".html" + url.substr(hash);
    if (target.extension() == ".svg" || target.extension() == ".png") return workspace.relative_name(target);
    return {};
}

} // namespace course
