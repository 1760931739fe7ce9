// Puts all of a section's mutants and variants into one C++ file, and lists how each is to be judged.
//
//     answers-in-one ROOT NN_slug UNIT LIST CLAIMS KIND...
//     answers-in-one ROOT NN_slug BUGS
//     answers-in-one ROOT NN_slug
//
// The second form writes those of tests/bugs.txt alone, for demos. The third prints each wrong one of mutants.diff as a file
// that a student could have written, below a line `>>> 8.1 decompose_swapped`. The first one:
//
// It writes UNIT, the C++ file; LIST, for the section's tests: a line `NAME EXERCISE EXPECTED` for each answer; and
// CLAIMS, a line `NAME EXERCISE what you did` for each wrong one whose claim begins with "you", since `check` says that to
// a reader, and `NAME EXERCISE what is special about it` for each right one: `mytests` says both. A KIND is `mutants`
// or `variants`. An answer is a file, tests/NN_slug/KIND/name.cpp, or an entry in tests/NN_slug/KIND.diff, of which
// tools/check/differences.hpp knows the form.
// With `7.2 meet_leaves_the_ends_open, 8 of 13, yours t = 0.5: ...` exactly so many of the tests must pass, and the first
// that does not must show that answer: a chapter says so. One of the two may be left out.

#include "check/differences.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace course::differences;

namespace {

struct Exercise {
    std::string number, function;
};

/// The exercises of a header, in its order.
std::vector<Exercise> exercises_of(const fs::path &header) {
    static const std::regex form{R"re(COURSE_EXERCISE\(\s*"(\d+\.\d+)",\s*\w+,\s*\w+,\s*(\w+))re"};
    std::string text;
    for (const Line &line : read(header)) text += line.text + '\n';
    std::vector<Exercise> all;
    for (std::sregex_iterator found{text.begin(), text.end(), form}, end; found != end; ++found)
        all.push_back({found->str(1), found->str(2)});
    if (all.empty()) throw std::runtime_error{header.string() + " has no line COURSE_EXERCISE(\"7.1\", ...)"};
    return all;
}

void write(std::ostream &out, const Lines &lines) {
    const Line *last = nullptr;
    for (const Line &line : lines) {
        if (last == nullptr || last->file != line.file || last->number + 1 != line.number)
            out << "#line " << line.number << ' ' << *line.file << '\n'; // the compiler's words name that place
        out << line.text << '\n';
        last = &line;
    }
}

/// What is made of a section.
class Unit {
  public:
    Unit(fs::path root_, std::string section_)
        : root{std::move(root_)},
          section{std::move(section_)},
          slug{section.substr(3)},
          solution_file{root / "solutions" / (section + ".cpp")},
          solution{solution_file},
          exercises{exercises_of(root / "chapters" / section / (slug + ".hpp"))} {
        write(code, solution.includes);
        // The solution itself, exercise by exercise: what the differences start from is right.
        for (const Exercise &exercise : exercises) {
            std::string name = "variant_solution_" + exercise.number;
            std::replace(name.begin(), name.end(), '.', '_');
            add_lines(name, exercise.number, solution.of(exercise.number), read(solution_file)[0]);
            note(name, exercise.number, "our solution");
        }
    }

    void add(const std::string &kind) {
        const fs::path folder = root / "tests" / section / kind, differences = fs::path{folder} += ".diff";
        const std::string prefix = kind.substr(0, kind.size() - 1) + '_'; // "mutant_", "variant_"
        if (fs::exists(differences))
            for (const Answer &answer : read_differences(differences)) {
                add_lines(prefix + answer.name, answer.exercise, solution.with(answer), answer.head, answer.verdict);
                note(prefix + answer.name, answer.exercise, answer.claim);
            }
        std::set<fs::path> files;
        if (fs::exists(folder))
            for (const auto &entry : fs::directory_iterator{folder})
                if (entry.path().extension() == ".cpp") files.insert(entry.path());
        for (const fs::path &file : files) add_file(prefix + file.stem().string(), file);
    }

    std::string code_of_all() const { return "#include \"choose.hpp\"\n" + code.str(); }
    /// How each answer is to be judged, by its name: "7.2 red".
    const std::map<std::string, std::string> &judgements() const { return judged; }
    /// What a reader did who gave such an answer, by its name: "7.2 you leave the ends open".
    const std::map<std::string, std::string> &claims() const { return told; }

  private:
    void add_lines(const std::string &name, const std::string &exercise, const Lines &lines, const Line &head,
                   const std::string &verdict = "") {
        code << "\nnamespace " << name << " {\nusing namespace " << slug << ";\n";
        write(code, lines);
        code << "}\n";
        list(name, exercise, head, verdict);
    }

    void add_file(const std::string &name, const fs::path &file) {
        static const std::regex head{R"(// (\d+\.\d+): (.+))"};
        const Lines lines = read(file);
        std::smatch found;
        if (lines.empty() || !std::regex_match(lines[0].text, found, head))
            throw std::runtime_error{
                file.string()
                + ":1: must begin with its exercise and what is special about it, as `// 7.2: only "
                  "the boxes are asked`"};
        code << "\nnamespace " << name << " { using namespace " << slug << "; }\n#define " << slug << ' ' << name
             << "\n#include " << file << "\n#undef " << slug << '\n';
        list(name, found[1], lines[0]);
        note(name, found[1], found[2]);
    }

    void list(const std::string &name, const std::string &number, const Line &head, const std::string &verdict = "") {
        const auto exercise = std::find_if(exercises.begin(), exercises.end(),
                                           [&](const Exercise &each) { return each.number == number; });
        if (exercise == exercises.end()) throw BadAnswer{head, "there is no exercise " + number + " in this section"};
        const std::string expected = !name.starts_with("mutant_") ? "all" : verdict.empty() ? "red" : verdict;
        if (!judged.emplace(name, number + ' ' + expected).second)
            throw BadAnswer{head, "there is an answer of this name already: choose another one"};
        code << "#line " << head.number << ' ' << *head.file << "\nconst Answer " << name << "_{\"" << name << "\", "
             << exercise - exercises.begin() << ", &" << slug << "::" << exercise->function << ", &" << name
             << "::" << exercise->function << "};\n";
    }

    void note(const std::string &name, const std::string &exercise, const std::string &claim) {
        if (!name.starts_with("mutant_") || claim.starts_with("you ")) told[name] = exercise + ' ' + claim;
    }

    fs::path root;
    std::string section, slug;
    fs::path solution_file;
    Solution solution;
    std::vector<Exercise> exercises;
    std::ostringstream code;
    std::map<std::string, std::string> judged, told;
};

std::string as_lines(const std::map<std::string, std::string> &entries) {
    std::string text;
    for (const auto &[name, rest] : entries) text += name + ' ' + rest + '\n';
    return text;
}

/// The bugs that tests/bugs.txt lists of a section, for a page, which calls one as "wrong 8.3 resolve_collision": the first
/// of each exercise.
std::string bugs_for_pages(const fs::path &root, const std::string &section) {
    const std::string slug = section.substr(3);
    const Solution solution{root / "solutions" / (section + ".cpp")};
    const std::vector<Answer> answers = read_differences(root / "tests" / section / "mutants.diff");
    std::map<std::string, std::string> functions;
    for (const Exercise &each : exercises_of(root / "chapters" / section / (slug + ".hpp")))
        functions[each.number] = each.function;
    std::ostringstream code;
    write(code, solution.includes);
    for (const Line &line : read(root / "tests" / "bugs.txt")) {
        const std::string exercise = line.text.substr(0, line.text.find(' '));
        const auto function = functions.find(exercise);
        if (function == functions.end()) continue; // of another section, another word, or there is one of it
        const auto answer = std::ranges::find_if(
            answers, [&](const Answer &each) { return each.exercise + ' ' + each.name == line.text; });
        if (answer == answers.end()) throw BadAnswer{line, "this is no wrong answer of section " + section};
        code << "\nnamespace mutant_" << answer->name << " {\nusing namespace " << slug << ";\ndecltype(" << slug
             << "::" << function->second << ") " << function->second << " COURSE_WRONG(\"" << exercise << ' '
             << function->second << "\");\n";
        write(code, solution.with(*answer));
        code << "}\n";
        functions.erase(function);
    }
    return code.str();
}

std::string as_files(const fs::path &root, const std::string &section) {
    const std::string slug = section.substr(3);
    const Solution solution{root / "solutions" / (section + ".cpp")};
    const std::vector<Exercise> exercises = exercises_of(root / "chapters" / section / (slug + ".hpp"));
    std::string text;
    const auto add = [&](const Lines &lines) {
        for (const Line &line : lines) text += line.text + '\n';
    };
    for (const Answer &answer : read_differences(root / "tests" / section / "mutants.diff")) {
        text += ">>> " + answer.exercise + ' ' + answer.name + '\n';
        add(solution.includes);
        text += "namespace " + slug + " {\n";
        add(solution.with(answer));
        for (const auto &[number, function] : exercises)
            if (number != answer.exercise) add(solution.only_of(number));
        text += "}\n";
    }
    return text;
}

void write(const fs::path &file, const std::string &text) {
    if (!(std::ofstream{file} << text << std::flush)) throw std::runtime_error{file.string() + " cannot be written"};
}

} // namespace

int main(int argc, char **argv) try {
    if (argc == 3) {
        std::cout << as_files(argv[1], argv[2]);
        return 0;
    }
    if (argc == 4) {
        write(argv[3], bugs_for_pages(argv[1], argv[2]));
        return 0;
    }
    if (argc < 7) {
        std::cerr << "usage: answers-in-one ROOT NN_slug UNIT LIST CLAIMS KIND...\n"
                     "       answers-in-one ROOT NN_slug BUGS\n"
                     "       answers-in-one ROOT NN_slug\n";
        return 2;
    }
    Unit unit{argv[1], argv[2]};
    for (int kind = 6; kind < argc; ++kind) unit.add(argv[kind]);

    write(argv[3], unit.code_of_all());
    write(argv[4], as_lines(unit.judgements()));
    write(argv[5], as_lines(unit.claims()));
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
