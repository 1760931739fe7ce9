// Puts all of a section's wrong and right answers into one C++ file, and lists how each is to be judged.
//
//     answers-in-one ROOT NN_slug UNIT LIST MISTAKES KIND...
//
// It writes UNIT, the C++ file; LIST, for the section's tests: a line `NAME EXERCISE EXPECTED` for each answer; and
// MISTAKES, a line `NAME EXERCISE what you did` for each whose claim begins with "you": `check` says that to a reader. A
// KIND is `wrong` or `right`. An answer is a file, tests/KIND/NN_slug/name.cpp, or an entry in tests/KIND/NN_slug.diff:
//
//     7.2 meet_leaves_the_ends_open: a touch is no meeting
//     -    return low > 0 || high < 0;
//     +    return (low >= 0 && high > 0) || (low < 0 && high <= 0);
//
// An entry says which lines of the solution go (-), which come (+), and, where more is needed to find the place, which
// stay ( ). A blank line ends a change; an answer may have several. Indentation and comments are not compared.
// With `7.2 meet_leaves_the_ends_open, 8 of 13, yours t = 0.5: ...` exactly so many of the tests must pass, and the first
// that does not must show that answer: a chapter says so. One of the two may be left out.

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

namespace {

/// A line of code, and where it was written.
struct Line {
    std::string text;
    const fs::path *file;
    int number;
};
using Lines = std::vector<Line>;

/// What is wrong with somebody's file, and where.
struct Complaint : std::runtime_error {
    Complaint(const Line &line, const std::string &what)
        : runtime_error{line.file->string() + ':' + std::to_string(line.number) + ": " + what} {}
};

Lines read(const fs::path &file) {
    static std::set<fs::path> names; // which lines point to
    std::ifstream in{file};
    if (!in) throw std::runtime_error{file.string() + " cannot be read"};
    const fs::path *name = &*names.insert(file).first;
    Lines lines;
    for (std::string text; std::getline(in, text);) lines.push_back({text, name, static_cast<int>(lines.size()) + 1});
    return lines;
}

/// What of a line is compared: no comment, no indentation.
std::string code_of(const std::string &text) {
    std::string rest = text.substr(0, text.starts_with("//") ? 0 : text.find(" //"));
    rest.erase(rest.find_last_not_of(" \t\r") + 1);
    return rest.erase(0, std::min(rest.find_first_not_of(" \t"), rest.size()));
}

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

/// A solution, cut at its `//> Solution 7.2: title`. A chunk without a number belongs to every exercise.
struct Solution {
    Lines includes;
    std::vector<std::pair<std::string, Line>> chunks; // each line with the number of its exercise, or with ""

    explicit Solution(const fs::path &file) {
        static const std::regex title{R"(//>.* (\d+\.\d+)\b.*)"};
        std::string number;
        bool inside = false;
        for (const Line &line : read(file)) {
            std::smatch found;
            if (line.text.starts_with("#include")) includes.push_back(line);
            else if (line.text.starts_with("//>")) {
                inside = line.text != "//>";
                number = std::regex_match(line.text, found, title) ? found[1].str() : "";
            } else if (inside) chunks.emplace_back(number, line);
        }
    }

    Lines of(const std::string &exercise) const {
        Lines lines;
        for (const auto &[number, line] : chunks)
            if (number.empty() || number == exercise) lines.push_back(line);
        return lines;
    }
};

/// Lines that stand one after the other in the solution, each with what becomes of it, and those that come: - + or a blank.
using Change = std::vector<std::pair<char, Line>>;

struct Answer {
    Line head;
    std::string exercise, name, verdict; ///< if that matters: "8 of 13, yours t = 0.5"
    std::string claim;
    std::vector<Change> changes;
};

std::vector<Answer> read_differences(const fs::path &file) {
    static const std::regex head{
        R"((\d+\.\d+) ([a-z][a-z0-9_]*)(?:, (\d+ of \d+|(?:\d+ of \d+, )?yours [^:]+))?: (.+))"};
    std::vector<Answer> answers;
    bool open = false; // a change that further lines belong to
    for (const Line &line : read(file)) {
        std::smatch found;
        const char sign = line.text.empty() ? '\n' : line.text[0];
        if (std::regex_match(line.text, found, head)) {
            answers.push_back({line, found[1], found[2], found[3], found[4], {}});
            open = false;
        } else if (code_of(line.text).empty() || sign == '#') {
            open = false;
        } else if (answers.empty() || std::string_view{"-+ "}.find(sign) == std::string_view::npos) {
            throw Complaint{line,
                            "this is neither the head of an answer, as `7.2 meet_never: what is wrong with it`, nor "
                            "a line that goes (-), comes (+) or stays ( )"};
        } else {
            auto &changes = answers.back().changes;
            if (!open) changes.emplace_back();
            open = true;
            changes.back().emplace_back(sign, Line{line.text.substr(1), line.file, line.number});
        }
    }
    for (const Answer &answer : answers)
        if (answer.changes.empty()) throw Complaint{answer.head, "this answer changes nothing: which line goes?"};
    return answers;
}

/// Makes a change wherever its lines stand in the solution: once, or this is a mistake.
void apply(const Change &change, const Answer &answer, Lines &solution, const fs::path &file) {
    Lines before;
    for (const auto &[sign, line] : change)
        if (sign != '+') before.push_back(line);
    if (before.empty())
        throw Complaint{change[0].second, "where does this line come? Write the line before it, with a blank in front"};

    std::vector<std::size_t> places; // of the solution's own lines that have code
    for (std::size_t i = 0; i < solution.size(); ++i)
        if (*solution[i].file == file && !code_of(solution[i].text).empty()) places.push_back(i);
    const auto same = [&](std::size_t i, const Line &line) { return code_of(solution[i].text) == code_of(line.text); };
    auto place = places.end();
    int times = 0;
    for (auto at = places.begin();; ++at, ++times) {
        at = std::search(at, places.end(), before.begin(), before.end(), same);
        if (at == places.end()) break;
        place = at;
    }
    const std::string what = before.size() == 1 ? "this line" : "these lines, one after the other,";
    const std::string where = file.string() + ", in what belongs to exercise " + answer.exercise;
    if (times == 0) throw Complaint{before[0], what + " must be in " + where + ": copy from there what goes"};
    if (times > 1)
        throw Complaint{before[0], what + " must be once in " + where + ", not " + std::to_string(times)
                                       + " times: add a line before or after that stays, with a blank in front"};

    std::size_t next = *place;
    Lines changed{solution.begin(), solution.begin() + static_cast<long>(next)};
    for (const auto &[sign, line] : change) {
        if (sign == '+') {
            changed.push_back(line);
            continue;
        }
        for (; next < *place; ++next) changed.push_back(solution[next]);
        if (sign == ' ') changed.push_back(solution[next]);
        ++next;
        ++place;
    }
    for (; next < solution.size(); ++next) changed.push_back(solution[next]);
    solution = std::move(changed);
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
            std::string name = "right_solution_" + exercise.number;
            std::replace(name.begin(), name.end(), '.', '_');
            add_lines(name, exercise.number, solution.of(exercise.number), read(solution_file)[0]);
        }
    }

    void add(const std::string &kind) {
        const fs::path folder = root / "tests" / kind / section, differences = fs::path{folder} += ".diff";
        if (fs::exists(differences))
            for (const Answer &answer : read_differences(differences)) {
                Lines lines = solution.of(answer.exercise);
                for (const Change &change : answer.changes) apply(change, answer, lines, solution_file);
                add_lines(kind + '_' + answer.name, answer.exercise, lines, answer.head, answer.verdict);
                note(kind + '_' + answer.name, answer.exercise, answer.claim);
            }
        std::set<fs::path> files;
        if (fs::exists(folder))
            for (const auto &entry : fs::directory_iterator{folder})
                if (entry.path().extension() == ".cpp") files.insert(entry.path());
        for (const fs::path &file : files) add_file(kind + '_' + file.stem().string(), file);
    }

    std::string code_of_all() const { return "#include \"choose.hpp\"\n" + code.str(); }
    /// How each answer is to be judged, by its name: "7.2 red".
    const std::map<std::string, std::string> &judgements() const { return judged; }
    /// What a reader did who gave such an answer, by its name: "7.2 you leave the ends open".
    const std::map<std::string, std::string> &mistakes() const { return told; }

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
        if (exercise == exercises.end()) throw Complaint{head, "there is no exercise " + number + " in this section"};
        const std::string expected = !name.starts_with("wrong_") ? "all" : verdict.empty() ? "red" : verdict;
        if (!judged.emplace(name, number + ' ' + expected).second)
            throw Complaint{head, "there is an answer of this name already: choose another one"};
        code << "#line " << head.number << ' ' << *head.file << "\nconst Answer " << name << "_{\"" << name << "\", "
             << exercise - exercises.begin() << ", &" << slug << "::" << exercise->function << ", &" << name
             << "::" << exercise->function << "};\n";
    }

    void note(const std::string &name, const std::string &exercise, const std::string &claim) {
        if (name.starts_with("wrong_") && claim.starts_with("you ")) told[name] = exercise + ' ' + claim;
    }

    fs::path root;
    std::string section, slug;
    fs::path solution_file;
    Solution solution;
    std::vector<Exercise> exercises;
    std::ostringstream code;
    std::map<std::string, std::string> judged, told;
};

std::string lines_of(const std::map<std::string, std::string> &entries) {
    std::string text;
    for (const auto &[name, rest] : entries) text += name + ' ' + rest + '\n';
    return text;
}

} // namespace

int main(int argc, char **argv) try {
    if (argc < 7) {
        std::cerr << "usage: answers-in-one ROOT NN_slug UNIT LIST MISTAKES KIND...\n";
        return 2;
    }
    Unit unit{argv[1], argv[2]};
    for (int kind = 6; kind < argc; ++kind) unit.add(argv[kind]);

    for (const auto &[file, text] : {std::pair{argv[3], unit.code_of_all()},
                                     {argv[4], lines_of(unit.judgements())},
                                     {argv[5], lines_of(unit.mistakes())}})
        if (!(std::ofstream{file} << text << std::flush))
            throw std::runtime_error{std::string{file} + " cannot be written"};
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
