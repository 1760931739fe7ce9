// Writes what a class of sixty might hand in for section 5, from right answers to attacks: to try grading with.
//
//     class-of-sixty ROOT DIR
//
// It writes DIR/canvas.zip and DIR/moodle.zip, as those platforms would give out the same sixty students' files;
// DIR/canvas.csv and DIR/moodle.csv, their files of grades, with one more who has handed in nothing; and
// DIR/class.txt, a line `1021 wrong 5.4 incline_is_a_force` for each student. Ids are 1001 to 1061, names are
// invented, and the bytes are the same each time.

#include "../tools/made_zip.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "check/differences.hpp"
#include "grade/archive.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>

namespace fs = std::filesystem;
using namespace course;
using differences::Answer;
using differences::Lines;

namespace {

const std::string section = "05_inclined_planes", file_name = section + ".cpp";
const std::array<std::string, 8> exercises{"5.1", "5.2", "5.3", "5.4", "5.5", "5.6", "5.7", "5.8"};

/// What somebody hands in.
struct HandedIn {
    enum Outcome { file, link, zeros, text } kind = file;
    std::string name, bytes; ///< of a link: where it leads
    std::string what;        ///< for class.txt
    std::string older;       ///< bytes of an earlier upload, if there was one
};

std::string text_of(const Lines &lines) {
    std::string text;
    for (const differences::Line &line : lines) text += line.text + '\n';
    return text;
}

class Class {
  public:
    explicit Class(const fs::path &root_)
        : root{root_},
          ours{root / "solutions" / file_name},
          solution{read_file(root / "solutions" / file_name)},
          stub{read_file(root / "tests" / section / "stub.cpp")} {
        rights();
        wrongs();
        for (std::size_t done = 2; done < 7; ++done) add("half done: " + std::to_string(done), half_done(done));
        for (int times = 0; times < 2; ++times) add("untouched", stub);
        oddities();
    }

    std::vector<HandedIn> all;

  private:
    void add(const std::string &what, const std::string &bytes, const std::string &name = file_name) {
        all.push_back({HandedIn::file, name, bytes, what, ""});
    }

    /// All of the file with one answer that isn't ours.
    std::string with(const Answer &answer) const {
        std::string text = text_of(ours.includes) + "\nnamespace inclined_planes {\n\n" + text_of(ours.with(answer));
        for (const std::string &each : exercises)
            if (each != answer.exercise) text += text_of(ours.only_of(each));
        return text + "} // namespace inclined_planes\n";
    }

    std::vector<Answer> answers(const std::string &kind) const {
        return differences::read_differences(root / "tests" / section / (kind + ".diff"));
    }

    void rights() {
        add("right", solution);
        const std::vector<Answer> other = answers("variants");
        for (std::size_t i = 0; i < 19; ++i) {
            const Answer &answer = other.at(i * other.size() / 19);
            add("right " + answer.exercise + ' ' + answer.name, with(answer));
        }
    }

    void wrongs() {
        const std::vector<Answer> wrong = answers("mutants");
        for (std::size_t i = 0; i < 20; ++i) {
            const Answer &answer = wrong.at(i * wrong.size() / 20);
            add("wrong " + answer.exercise + ' ' + answer.name, with(answer));
        }
    }

    /// The first exercises are done, and the others are as they were.
    std::string half_done(std::size_t done) const {
        std::string text = solution;
        for (std::size_t i = done; i < exercises.size(); ++i)
            text.insert(body_of(text, exercises[i]), "    throw course::NotYet{\"what comes here?\"};\n");
        return text;
    }

    /// Where the lines of an exercise's function begin.
    static std::size_t body_of(const std::string &text, const std::string &exercise) {
        return text.find("{\n", text.find("//> Solution " + exercise)) + 2;
    }

    std::string changed(const std::string &from, const std::string &to) const {
        std::string text = solution;
        const std::size_t at = text.find(from);
        if (at == text.npos) throw std::runtime_error{"our solution has no " + from};
        return text.replace(at, from.size(), to);
    }

    void oddities() {
        add("empty", "");
        {
            const Scratch scratch{fs::temp_directory_path() / "class"};
            write_archive(scratch.folder / "inner.zip", {{file_name, solution}});
            add("zip in a zip", read_file(scratch.folder / "inner.zip"), section + ".zip");
        }
        std::string endless = solution;
        endless.insert(body_of(endless, "5.2"), "    for (volatile int i = 0;; i = i + 1) {}\n");
        add("endless loop in 5.2", endless);
        std::string wide = "\xff\xfe";
        for (const char c : solution)
            if (static_cast<unsigned char>(c) < 0x80) wide += {c, '\0'};
        add("UTF-16", wide);
        add("named $(id).cpp", solution, "$(id).cpp");
        all.push_back({HandedIn::link, file_name, "../../solutions/" + file_name, "symbolic link", ""});
        all.push_back({HandedIn::zeros, file_name, "", "bomb: a hundred megabytes of zeros", ""});
        std::string padded = solution;
        while (padded.size() < 10'000'000) padded += "// A line that says nothing, again and again.\n";
        add("10 MB", padded);
        add("no ; in 5.3", changed("mass * g * std::cos(angle);", "mass * g * std::cos(angle)"));
        add("own main", solution + "\nint main() { return 0; }\n");
        add("two uploads, the newer right", solution);
        all.back().older = stub;
        add("another section's file", read_file(root / "solutions/04_trajectories.cpp"), "04_trajectories.cpp");
        all.push_back({HandedIn::text, "", "<p>My code is on the computer in the lab.</p>\n", "typed text", ""});
    }

    fs::path root;
    differences::Solution ours;
    std::string solution, stub;
};

struct Person {
    std::string id, first, last;
    bool late;
};

Person person(std::size_t index) {
    const std::array<std::string, 10> first{"Alba", "Bero", "Cilo", "Dána", "Emlo",
                                            "Fïra", "Göta", "Halu", "Inbo", "Jélu"};
    const std::array<std::string, 6> last{"Ahorn", "Birke", "Distel", "Erle", "Fichte", "Grünholz"};
    return {std::to_string(1001 + index), first[index % 10], last[index / 10 % 6], index % 10 == 4};
}

void add(MadeZip &zip, const HandedIn &what, const std::string &name) {
    constexpr zip_uint64_t bomb = 100'000'000;
    if (what.kind == HandedIn::link) zip.link(name, what.bytes);
    else if (what.kind == HandedIn::zeros) zip.zeros(name, bomb);
    else zip.file(name, what.bytes);
}

void write_canvas(const std::vector<HandedIn> &all, const fs::path &to) {
    MadeZip zip;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Person who = person(i);
        const std::string start = lower(who.last + who.first) + (who.late ? "_LATE_" : "_") + who.id + '_';
        const std::size_t upload = 500'000 + i * 37 % 61 * 10; // in the order in which they were handed in
        if (all[i].kind == HandedIn::text) {
            zip.file(start + "text.html", all[i].bytes);
            continue;
        }
        if (!all[i].older.empty()) zip.file(start + std::to_string(upload) + '_' + all[i].name, all[i].older);
        std::string name = all[i].name;
        if (!all[i].older.empty()) name.insert(name.rfind('.'), "-1");
        add(zip, all[i], start + std::to_string(upload + 1) + '_' + name);
    }
    zip.write(to);
}

void write_moodle(const std::vector<HandedIn> &all, const fs::path &to) {
    MadeZip zip;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Person who = person(i);
        const std::string start = who.first + ' ' + who.last + '_' + who.id + "_assignsubmission_";
        if (all[i].kind == HandedIn::text) zip.file(start + "onlinetext_/onlinetext.html", all[i].bytes);
        else add(zip, all[i], start + "file_/" + all[i].name); // and of two uploads it gives out the newer
    }
    zip.write(to);
}

void write_grades(std::size_t people, const fs::path &folder) {
    std::string
        canvas = "Student,ID,SIS User ID,SIS Login ID,Section,Inclined planes (4711)\n"
                 "    Points Possible,,,,,10\n",
        moodle = "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be changed\","
                 "\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"\n";
    for (std::size_t i = 0; i < people; ++i) {
        const auto [id, first, last, late] = person(i);
        canvas += fmt::format("\"{}, {}\",{},S{},login{},Physics 1,\n", last, first, id, id, id);
        moodle += fmt::format("\"Participant {}\",\"{} {}\",login{}@example.org,\"Submitted for grading\",,10.00,Yes,"
                              "\"Tuesday, 24 November 2026, 9:00 PM\",-,\n",
                              id, first, last, id);
    }
    write_file(folder / "canvas.csv", canvas + "\"Student, Test\",9999,,test,Physics 1,\n");
    write_file(folder / "moodle.csv", moodle);
}

} // namespace

int main(int argc, char **argv) try {
    if (argc != 3) {
        std::cerr << "usage: class-of-sixty ROOT DIR\n";
        return 2;
    }
    const std::vector<HandedIn> all = Class{argv[1]}.all;
    const fs::path folder = argv[2];
    std::string list;
    for (std::size_t i = 0; i < all.size(); ++i) list += person(i).id + ' ' + all[i].what + '\n';
    write_file(folder / "class.txt", list);
    write_grades(all.size() + 1, folder);
    write_canvas(all, folder / "canvas.zip");
    write_moodle(all, folder / "moodle.zip");
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
