#include "site/build.hpp"

#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "ground/process.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"
#include "site/book_parts.hpp"
#include "site/demos.hpp"
#include "site/doxygen_page.hpp"
#include "site/draft.hpp"
#include "site/front.hpp"
#include "site/page_template.hpp"
#include "site/progress_script.hpp"
#include "site/search.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// A page of the site that is written as Markdown.
struct WrittenPage {
    std::string name; ///< without ".html"
    fs::path file;    ///< which its links are seen from, and its lines counted in
    std::string text;
};

/// The front page, the parts of book.md, the chapters, the other files beside book.md, and the page with all demos.
std::vector<WrittenPage> written_pages(const Tree &tree) {
    const fs::path book = tree.root / "book.md";
    std::vector<WrittenPage> pages{{"index", tree.root / "docs" / "front.md", front_page(tree)}};
    for (const BookPart &part : book_parts(read_file(book))) pages.push_back({part.name, book, part.text});
    for (const fs::path &file : markdown_pages(tree))
        if (file != book) pages.push_back({page_name(tree, file), file, read_file(file)});
    if (const std::string all = play_page(tree); !all.empty()) pages.push_back({"play", book, all});
    return pages;
}

class Builder {
  public:
    Builder(const Tree &tree_, const SiteTools &tools_) : tree{tree_}, tools{tools_} {}

    void build() {
        fs::remove_all(work);
        run_doxygen();
        known = interfaces(work / "names.tag");
        read_drafts();
        const std::vector<std::string> typeset = typeset_formulas();
        SiteFiles files;
        files["search-index.js"] = search_index();
        files["progress.js"] = progress_script(tree);
        add_pages(files, typeset);
        add_assets(files);
        keep_reachable(files);
        write_site(site_folder(tree), files);
    }

  private:
    /// Runs one of our tools; its error message becomes the complaint.
    std::string run_tool(const std::vector<std::string> &command, const std::string &what,
                         const fs::path &folder) const {
        const Finished finished = run(command, {.deadline = 300, .folder = folder});
        if (finished.timed_out) throw Complaint{what + " did not end within five minutes"};
        if (finished.code != 0)
            throw Complaint{what + " failed:\n" + without_root(finished.err.empty() ? finished.out : finished.err)};
        return finished.out;
    }

    std::string without_root(std::string text) const {
        for (const std::string &root : {work.string() + '/', tree.root.string() + '/'}) replace_all(text, root, "");
        return text;
    }

    // Doxygen

    /// Doxygen reads copies, by names relative to the folder that it runs in: in its settings a path of the machine's
    /// would be looked through for quotes and for `$(HOME)`.
    void run_doxygen() {
        std::string input;
        const auto add = [&](const std::string &name, const std::string &text) {
            write_file(work / name, text);
            input += " \\\n    " + name;
        };
        const auto page = [](const std::string &name) { return "pages/" + name + ".markdown"; };
        for (const WrittenPage &each : written)
            add(page(each.name), doxygen_page(tree, each.file, each.text, each.name));
        for (const fs::path &file : source_pages(tree)) {
            const std::string name = tree.shown(file), text = read_file(file);
            add(page(page_name(tree, file)), doxygen_source(tree, file, text));
            if (file.extension() == ".hpp" && name.starts_with("chapters/")) add(name, text); // an interface
        }
        write_file(work / "layout.xml", read_file(tree.root / "docs" / "layout.xml"));
        write_file(work / "Doxyfile", read_file(tree.root / "docs" / "Doxyfile")
                                          + "\nLAYOUT_FILE = layout.xml\nSTRIP_FROM_PATH = .\nOUTPUT_DIRECTORY = ."
                                            "\nGENERATE_TAGFILE = names.tag\nINPUT ="
                                          + input + '\n');
        run_tool({tools.doxygen, "Doxyfile"}, "Doxygen", work);
    }

    /// The pages that Doxygen has written, without its index pages.
    void read_drafts() {
        static const std::regex wanted{R"(source_.*|(namespace|struct|class|union).*)"};
        for (const fs::path &file : files_in(work / "html", ".html")) {
            const std::string name = file.stem().string();
            const bool is_list = name == "namespaces" || name.starts_with("namespacemembers") || name == "classes"
                                 || name.ends_with("-members");
            const bool own = std::ranges::find(written, name, &WrittenPage::name) != written.end();
            if (!is_list && (own || std::regex_match(name, wanted))) drafts.emplace_back(name, read_file(file));
        }
    }

    // Node

    std::string run_node(const char *script, const nlohmann::json &input, const fs::path &library) const {
        const fs::path file = work / (std::string{script} + ".json");
        write_file(file, input.dump());
        return run_tool({tools.node, (tree.root / "docs" / script).string(), library.string(), file.string()}, script,
                        tree.root);
    }

    /// All formulas of all drafts, in order, as HTML.
    std::vector<std::string> typeset_formulas() const {
        nlohmann::json input = nlohmann::json::array();
        for (const Draft &draft : drafts)
            for (const FormulaAt &formula : draft.formulas())
                input.push_back({{"tex", formula.tex}, {"display", formula.display}, {"from", formula.from}});
        return nlohmann::json::parse(run_node("formulas.cjs", input, tools.katex / "katex.js"));
    }

    std::string search_index() const {
        nlohmann::json documents = nlohmann::json::array();
        for (const Draft &draft : drafts)
            if (!draft.is_interface() && !draft.name().starts_with("source_"))
                for (const nlohmann::json &document : search_documents(draft)) documents.push_back(document);
        for (const auto &[space, interface] : known)
            for (const auto &[name, where] : interface.names)
                documents.push_back({{"page", "Interface: " + space},
                                     {"part", name + (where.is_function ? "()" : "")},
                                     {"address", where.address},
                                     {"text", ""},
                                     {"words", ""}});
        return run_node("search-index.cjs", documents, tools.lunr);
    }

    // Pages

    /// The namespace whose names a page's listings may link to: that of its section.
    const Interface *names_for(const Draft &draft) const {
        for (const Section &section : tree.sections())
            if (draft.name().find(section.name) != std::string::npos)
                if (const auto found = known.find(section.slug()); found != known.end()) return &found->second;
        return nullptr;
    }

    void add_pages(SiteFiles &files, const std::vector<std::string> &typeset) {
        const PageTemplate page{tree, known, read_file(tree.root / "docs" / "page.html")};
        auto from = typeset.begin();
        for (Draft &draft : drafts) {
            const auto to = from + static_cast<std::ptrdiff_t>(draft.formulas().size());
            files[draft.name() + ".html"] = page.around(draft, draft.finished({from, to}, names_for(draft)));
            from = to;
        }
    }

    void add_assets(SiteFiles &files) {
        for (const char *kind : {".css", ".js"})
            for (const fs::path &file : files_in(tree.root / "docs", kind))
                files[file.filename().string()] = read_file(file);
        for (const fs::path &file : files_in(tree.root / "plots", ".svg")) files[tree.shown(file)] = read_file(file);
        for (const Demo &demo : demos(tree)) {
            files[demo_file(demo.section)] = read_file(tree.root / demo_file(demo.section));
            for (std::size_t start = 0; start < demo.starts.size() && !demo.about.empty(); ++start) {
                const std::string picture = demo_picture_file(demo.section, start);
                files[picture] = read_file(tree.root / picture);
            }
        }
        files["lunr.js"] = read_file(fs::path{tools.lunr}.replace_extension(".min.js"));
        // Of its three formats every browser of the last ten years takes the first.
        static const std::regex older{R"(,url\([^)]*\.(woff|ttf)\) format\([^)]*\))"};
        files["katex.css"] = std::regex_replace(read_file(tools.katex / "katex.min.css"), older, "");
        for (const fs::path &folder : {tools.katex / "fonts", tree.root / "docs" / "fonts"})
            for (const char *kind : {".woff2", ".txt"})
                for (const fs::path &file : files_in(folder, kind))
                    files["fonts/" + file.filename().string()] = read_file(file);
    }

    const Tree &tree;
    const SiteTools &tools;
    const fs::path work = tree.build / "site.work";
    const std::vector<WrittenPage> written = written_pages(tree);
    std::map<std::string, Interface> known;
    std::vector<Draft> drafts;
};

} // namespace

void build_site(const Tree &tree, const SiteTools &tools) { Builder{tree, tools}.build(); }

void write_site(const fs::path &folder, const SiteFiles &files) {
    for (const auto &[name, text] : files) write_file(folder / name, text);
    std::vector<fs::path> old;
    for (const auto &entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file() && !files.contains(entry.path().lexically_relative(folder).generic_string()))
            old.push_back(entry.path());
    for (const fs::path &file : old) fs::remove(file);
}

} // namespace course
