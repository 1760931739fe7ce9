#include "site/build.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "site/addresses.hpp"
#include "site/demos.hpp"
#include "site/front.hpp"
#include "site/page_template.hpp"
#include "site/page_writer.hpp"
#include "site/progress_script.hpp"
#include "site/reference.hpp"

#include <nlohmann/json.hpp>

#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// The front page, the parts of book.md, the chapters, the other texts beside it and in docs, the page with all demos, and code.
std::vector<SitePage> our_pages(const Addresses &addresses) {
    const Workspace &workspace = addresses.workspace;
    const fs::path book = workspace.root / "book.md";
    std::vector<SitePage> pages{
        written_page(addresses, workspace.root / "docs" / "front.md", front_page(workspace), "index")};
    for (const BookPart &part : addresses.parts) pages.push_back(written_page(addresses, book, part.text, part.name));
    for (const fs::path &file : addresses.markdown)
        pages.push_back(written_page(addresses, file, read_file(file), page_name(workspace, file)));
    if (const std::string all = play_page(workspace); !all.empty())
        pages.push_back(written_page(addresses, book, all, "play"));
    for (const fs::path &file : addresses.code) pages.push_back(source_page(workspace, file));
    return pages;
}

/// What a server shows in the place of a page that it doesn't have.
constexpr const char *not_here = "<h1>This page isn't here</h1>\n<p>The link that led you here is an old one, or a "
                                 "letter of it got lost. Start at the "
                                 "<a href=\"index.html\">front page</a>, or search the book.</p>";

class Builder {
  public:
    Builder(const Workspace &tree_, const SiteTools &tools_) : workspace{tree_}, tools{tools_} {}

    void build() {
        fs::remove_all(work);
        run_doxygen();
        std::vector<SitePage> pages = our_pages(addresses);
        for (const SitePage &page : reference_pages(work / "html")) pages.push_back(page);
        SiteFiles files;
        files["search-index.js"] = finish(pages);
        files["progress.js"] = progress_script(workspace);
        pages.push_back({"404", "This page isn't here", "chapter", not_here, {}});
        add_pages(files, addresses, pages);
        add_assets(files);
        keep_reachable(files);
        write_site(site_folder(workspace), files);
    }

  private:
    /// Runs one of our tools; the error message becomes the complaint.
    std::string run_tool(const std::vector<std::string> &command, const std::string &what,
                         const fs::path &folder) const {
        const Finished finished = run(command, {.deadline = 300, .folder = folder});
        if (finished.timed_out) throw UserError{what + " did not end within five minutes"};
        if (finished.code != 0)
            throw UserError{what + " failed:\n" + without_root(finished.err.empty() ? finished.out : finished.err)};
        return finished.out;
    }

    std::string without_root(std::string text) const {
        for (const std::string &root : {work.string() + '/', workspace.root.string() + '/'})
            replace_all(text, root, "");
        return text;
    }

    /// Doxygen reads copies of the headers, by names relative to the folder that it runs in: in the settings a path of
    /// the machine's would be looked through for quotes and for `$(HOME)`.
    void run_doxygen() const {
        std::string input;
        for (const fs::path &file : addresses.code) {
            const std::string name = workspace.relative_name(file);
            if (file.extension() != ".hpp" || !name.starts_with("chapters/")) continue;
            write_file(work / name, read_file(file));
            input += " \\\n    " + name;
        }
        write_file(work / "layout.xml", read_file(workspace.root / "docs" / "layout.xml"));
        write_file(work / "Doxyfile", read_file(workspace.root / "docs" / "Doxyfile")
                                          + "\nLAYOUT_FILE = layout.xml\nSTRIP_FROM_PATH = .\nOUTPUT_DIRECTORY = ."
                                            "\nGENERATE_TAGFILE = names.tag\nINPUT ="
                                          + input + '\n');
        run_tool({tools.doxygen, "Doxyfile"}, "Doxygen", work);
    }

    /// The namespace whose names a page's code may link to: that of the section; "" without one.
    std::string space_of(const SitePage &page) const {
        for (const Section &section : workspace.sections())
            if (page.name.find(section.name) != std::string::npos) return section.slug();
        return "";
    }

    /// All that docs/finish.cjs does to the pages; returns the search's index.
    std::string finish(std::vector<SitePage> &pages) const {
        nlohmann::json input{{"names", declared_names(work / "names.tag")}};
        for (const SitePage &page : pages)
            input["pages"].push_back({{"name", page.name},
                                      {"title", page.title},
                                      {"kind", page.kind},
                                      {"space", space_of(page)},
                                      {"html", page.html}});
        write_file(work / "pages.json", input.dump());
        const std::string script = (workspace.root / "docs" / "finish.cjs").string();
        const auto finished = nlohmann::json::parse(run_tool({tools.node, script, (tools.katex / "katex.js").string(),
                                                              tools.lunr.string(), (work / "pages.json").string()},
                                                             "docs/finish.cjs", workspace.root));
        for (std::size_t at = 0; at < pages.size(); ++at) pages[at].html = finished["pages"][at];
        return finished["index"];
    }

    void add_assets(SiteFiles &files) {
        for (const char *kind : {".css", ".js"})
            for (const fs::path &file : files_in(workspace.root / "docs", kind))
                files[file.filename().string()] = read_file(file);
        for (const fs::path &file : files_in(workspace.root / "plots", ".svg"))
            files[workspace.relative_name(file)] = read_file(file);
        for (const Demo &demo : demos(workspace)) {
            files[demo_file(demo.section)] = read_file(workspace.root / demo_file(demo.section));
            for (std::size_t start = 0; start < demo.starts.size() && !demo.about.empty(); ++start) {
                const std::string picture = demo_picture_file(demo.section, start);
                files[picture] = read_file(workspace.root / picture);
            }
        }
        for (const GallerySketch &sketch : published_gallery(workspace))
            for (const std::string &file : {sketch.script(), sketch.picture()})
                files[file] = read_file(workspace.root / file);
        files["lunr.js"] = read_file(fs::path{tools.lunr}.replace_extension(".min.js"));
        // Every browser of the last ten years takes the first of the three formats.
        static const std::regex older{R"(,url\([^)]*\.(woff|ttf)\) format\([^)]*\))"};
        files["katex.css"] = std::regex_replace(read_file(tools.katex / "katex.min.css"), older, "");
        for (const fs::path &folder : {tools.katex / "fonts", workspace.root / "docs" / "fonts"})
            for (const char *kind : {".woff2", ".txt"})
                for (const fs::path &file : files_in(folder, kind))
                    files["fonts/" + file.filename().string()] = read_file(file);
    }

    const Workspace &workspace;
    const SiteTools &tools;
    const Addresses addresses{workspace};
    const fs::path work = workspace.build / "site.work";
};

} // namespace

void build_site(const Workspace &workspace, const SiteTools &tools) { Builder{workspace, tools}.build(); }

void write_site(const fs::path &folder, const SiteFiles &files) {
    for (const auto &[name, text] : files) write_file(folder / name, text);
    std::vector<fs::path> old;
    for (const auto &entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file() && !files.contains(entry.path().lexically_relative(folder).generic_string()))
            old.push_back(entry.path());
    for (const fs::path &file : old) fs::remove(file);
}

} // namespace course
