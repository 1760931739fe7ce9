// `course sketch`: a scene of the reader's own, in the browser.

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/lock.hpp"
#include "base/text.hpp"
#include "base/watch.hpp"
#include "check/diagnosis.hpp"
#include "commands/commands.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"
#include "site/progress_script.hpp"
#include "site/share.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <iostream>
#include <nlohmann/json.hpp>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *about_sketch = R"(
A sketch is a small world of your own, exercises/sketches/moon.cpp. The first call writes one that runs; docs/sketches.md
says what else there is. It may call every function of the course: yours where you've done it, ours elsewhere.
--from begins with a scene of the book, or with a sketch of its gallery.

Example: ./course sketch moon --watch
         ./course sketch splash --from "11/with walls"
         ./course sketch mine --from nails
         ./course sketch moon --share moon.html)";

struct SketchOptions {
    std::string name, from;
    fs::path share;
    bool watch = false, yes = false;
};

/// A reader's scene: its file, and what's made of it.
struct Sketch {
    Sketch(const Workspace &workspace, std::string its_name) : name{std::move(its_name)} {
        file = workspace.sketches() / (name + ".cpp");
        play = workspace.build / "play" / "sketches";
    }
    fs::path packed() const { return play / (name + ".js"); }
    /// The reader's answers, which sketches may call.
    fs::path answers() const { return play / "answers.js"; }
    fs::path page() const { return play / (name + ".html"); }
    /// Where docs/play.js looks for news, beside the page.
    fs::path news() const { return play / "demos" / (name + "_mine.js"); }

    std::string name;
    fs::path file, play;
};

// What it begins with

/// The files of a section's scenes, by the name that a place of its chapter has for each.
std::vector<std::pair<std::string, fs::path>> scenes_of(const Workspace &workspace, const Section &section) {
    std::vector<std::pair<std::string, fs::path>> scenes;
    const fs::path folder = workspace.root / "chapters" / section.name / "scenes";
    if (!fs::exists(folder)) return scenes;
    for (const auto &entry : fs::directory_iterator{folder}) {
        const std::string text = read_file(entry.path()), before = "std::string_view name = \"";
        if (const auto at = text.find(before); at != text.npos)
            scenes.emplace_back(
                text.substr(at + before.size(), text.find('"', at + before.size()) - at - before.size()), entry.path());
    }
    std::ranges::sort(scenes);
    return scenes;
}

/// The code of a sketch of the gallery.
std::string gallery_sketch(const Workspace &workspace, const std::string &name) {
    std::string names;
    for (const GallerySketch &each : gallery(workspace)) {
        if (each.name == name) return read_file(each.file);
        names += (names.empty() ? ": " : ", ") + each.name;
    }
    throw UserError{"--from names a section and a scene of it, as 4/lands does, or a sketch of the gallery" + names};
}

/// One of the book's scenes as a sketch: what it shares with others stays where it is.
std::string sketch_of(const Workspace &workspace, const std::string &from) {
    const auto slash = from.find('/');
    if (slash == from.npos) return gallery_sketch(workspace, from);
    const Section section = workspace.section(from.substr(0, slash));
    const auto scenes = scenes_of(workspace, section);
    const std::string wanted = from.substr(slash + 1);
    const auto scene = std::ranges::find_if(
        scenes, [&](const auto &each) { return contains(each.first, wanted) || each.second.stem() == wanted; });
    if (scene == scenes.end()) {
        std::string names;
        for (const auto &each : scenes) names += (names.empty() ? "" : ", ") + each.first;
        throw UserError{"section " + section.short_number() + " has no scene `" + wanted + "`"
                        + (names.empty() ? " that could be copied yet" : "; it has " + names)};
    }
    std::string text = read_file(scene->second);
    const auto replace = [&](const std::string &old, const std::string &by) {
        if (const auto at = text.find(old); at != text.npos) text.replace(at, old.size(), by);
    };
    replace("#pragma once\n", "#include \"sketch.hpp\"\n");
    for (const fs::path &beside : files_in(scene->second.parent_path(), ".hpp"))
        replace("#include \"" + beside.filename().string() + '"',
                "#include \"" + section.name + "/scenes/" + beside.filename().string() + '"');
    const auto type = text.find("struct "), end = text.find(" : ", type);
    return text + "SKETCH(play::" + text.substr(type + 7, end - type - 7) + ", \"" + scene->first + "\")\n";
}

void begin_sketch(const Workspace &workspace, const Sketch &sketch, const std::string &from) {
    if (fs::exists(sketch.file)) {
        if (!from.empty())
            throw UserError{workspace.relative_name(sketch.file) + " is there already: take another name for it"};
        return;
    }
    write_file(sketch.file, from.empty() ? first_sketch(sketch.name) : sketch_of(workspace, from));
    std::cout << "Written: " << workspace.relative_name(sketch.file) << '\n';
}

// Its page

/// What is wrong with it; "" if it could be compiled.
std::string trouble_of(const Workspace &workspace, const Sketch &sketch, const Finished &built) {
    if (built.code == 0) return "";
    const std::string printed = built.out + '\n' + built.err, name = workspace.relative_name(sketch.file);
    const Verdict verdict = diagnose_compiler(printed, sketch.file, name);
    if (verdict.line == 0) return "it can't be built: " + first_error(printed);
    return verdict.file + ':' + std::to_string(verdict.line) + ": " + verdict.sentence;
}

/// A line of the page's script: `self.playable["moon/mine"] = value;`
std::string playable(const std::string &name, const std::string &value) {
    return "self.playable[" + nlohmann::json(name).dump() + "] = " + value + ";\n";
}

/// What's compiled, for both sides of the page's switch.
std::string compiled_script(const Sketch &sketch) {
    return read_file(sketch.packed()) + read_file(sketch.answers())
           + playable(sketch.name + "/mine", "self.playable[\"sketches/mine\"]");
}

/// @return whether it could be compiled
bool build_sketch(const Workspace &workspace, const Sketch &sketch) {
    const Lock lock{workspace};
    const auto began = std::chrono::steady_clock::now();
    const std::string trouble = trouble_of(workspace, sketch, build_target(workspace, "sketch_" + sketch.name));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    std::cout << (trouble.empty() ? fmt::format("It's in the page ({:.1f} s).", took.count())
                                  : "Not in the page: " + trouble)
              << '\n'
              << std::flush;
    // A page that has heard of trouble, or of none, looks for news.
    const std::string told = playable(sketch.name + "/trouble", nlohmann::json(trouble).dump());
    write_file(sketch.news(),
               (trouble.empty() ? compiled_script(sketch) : "self.playable = self.playable || {};\n") + told);
    return trouble.empty();
}

void sketch_for(const Workspace &workspace, const SketchOptions &options) {
    if (options.name.empty()) {
        print_sketches(workspace);
        std::cout << "A new one: ./course sketch moon\n";
        return;
    }
    const bool named = std::ranges::all_of(
        options.name, [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
    if (!named || !std::islower(static_cast<unsigned char>(options.name.front())))
        throw UserError{"`" + options.name
                        + "` becomes a file and a struct: name it by small letters, as in: ./course sketch moon"};
    if (!options.share.empty() && options.share.extension() != ".html")
        throw UserError{options.share.string() + " would be a web page: give it a name that ends in .html"};
    const Sketch sketch{workspace, options.name};
    begin_sketch(workspace, sketch, options.from);
    need_page_compiler(workspace, options.yes);
    bring_up_site(workspace);
    if (!fs::exists(sketch.play / "page.o"))
        std::cout << "The first time this compiles the functions of all sections, which takes a while.\n" << std::flush;
    const bool fine = build_sketch(workspace, sketch);
    if (fine) {
        const auto script = [](const std::string &text) { return "<script>\n" + text + "</script>\n"; };
        const std::string progress = script(progress_script(workspace));
        write_file(sketch.page(),
                   sketch_page(workspace, sketch.name,
                               "<script src=\"demos/" + sketch.name + "_mine.js\"></script>\n" + progress, false));
        if (!options.share.empty()) {
            write_file(options.share,
                       sketch_page(workspace, sketch.name, script(compiled_script(sketch)) + progress, true));
            std::cout << "Written: " << options.share.string() << ", " << fs::file_size(options.share) / 1000
                      << " kB. Send it to a friend, who opens it with a double click.\n";
            return;
        }
        open_page(sketch.page());
    } else if (!options.share.empty()) {
        std::cout << options.share.string() << " was not written.\n";
    }
    if (options.watch) {
        std::cout << "Save your file, and the page takes it up. Ctrl-C ends this.\n" << std::flush;
        for (FileWatch saves{{sketch.file}}; saves.wait();) build_sketch(workspace, sketch);
    }
    if (!fine) throw ExitRequest{something_to};
}

/// For pages: what a sketch may begin with, as text: { "07_segment_intersection": { "bounces (7.4)": … }, "gallery": { … }, "new": … };
/// and "page", the one to send to a friend, where a place says what is compiled. The site must be there.
void print_scenes(const Workspace &workspace) {
    const std::string first = first_sketch("mine");
    nlohmann::json all{{"new", first.substr(first.find('\n') + 1)}, // its first line is about a terminal
                       {"page", sketch_page(workspace, "sketch", "<!-- compiled -->\n", true)}};
    for (const Section &section : workspace.sections())
        for (const auto &[name, file] : scenes_of(workspace, section))
            all[section.name][name] = sketch_of(workspace, section.short_number() + '/' + name);
    for (const GallerySketch &each : gallery(workspace)) all["gallery"][each.name] = read_file(each.file);
    std::cout << all.dump() << '\n';
}

} // namespace

std::string first_sketch(const std::string &name) {
    std::string type = with_capital(name);
    return fmt::format(
        R"(// `./course sketch {0} --watch` shows it, and again whenever you save; docs/sketches.md says what else there is.
#include "sketch.hpp"
using namespace demo;

struct {1} : Scene {{
    Slider pull = slider("pull", "1/s", 0.5, 9, 0.5, 3);
    Vec2 at{{8, 4.5}}; // [m], in a world of 16 m by 9 m

    View view() const override {{ return {{{{0, 0}}, {{16, 9}}, Stage::night}}; }}
    void step(double dt) override {{
        if (hand.inside) at += dt * pull * (hand.at - at);
    }}
    void draw(Canvas &canvas) const override {{ canvas.lamp(at, 1, Colour::amber); }}
}};
SKETCH({1}, "A disc that follows the pointer")
)",
        name, type);
}

bool print_sketches(const Workspace &workspace) {
    const std::vector<fs::path> files = files_in(workspace.sketches(), ".cpp");
    for (const fs::path &file : files) std::cout << "./course sketch " << file.stem().string() << '\n';
    return !files.empty();
}

void add_sketch(CLI::App &app, const Workspace &workspace) {
    const auto options = std::make_shared<SketchOptions>();
    CLI::App *command = app.add_subcommand("sketch", "Make a small world of your own, and see it in your browser");
    command->add_option("name", options->name, "what it's called; without it, the names of those that are there");
    command
        ->add_option("--from", options->from, "begin with a scene of the book, as 4/lands, or a sketch of its gallery")
        ->type_name("SCENE");
    command->add_flag("-w,--watch", options->watch, "again whenever you save; the open page takes it up");
    command->add_option("--share", options->share, "write one page with it, to send to a friend")->type_name("FILE");
    command->add_flag("--yes", options->yes, "install a compiler for pages without asking, if there is none");
    command->footer(about_sketch);
    command->callback([&workspace, options] { sketch_for(workspace, *options); });
    app.add_subcommand("make-scenes", "Print the book's scenes as sketches, for pages")
        ->group("")
        ->callback([&workspace] { print_scenes(workspace); });
}

} // namespace course
