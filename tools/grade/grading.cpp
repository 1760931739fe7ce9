#include "grade/grading.hpp"

#include "base/files.hpp"
#include "check/functions.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace course {
namespace {

constexpr std::size_t most_helpers = 3; ///< that don't compile: each costs a compilation

/// A student's file, of which functions are taken out one after the other.
class Remains {
  public:
    std::vector<Exercise> exercises;

    Remains(const Workspace &workspace, const Section &section, std::string text)
        : exercises{catalogue(workspace, section)},
          stub{read_file(workspace.stub(section))},
          of_stub{functions_of(Source{stub}, {})} {
        for (const Function &each : of_stub) known.push_back(each.name);
        read(std::move(text));
    }

    const std::string &text() const { return source_text; }
    const Source &source() const { return scanned; }
    const Function *find(const Exercise &exercise) const { return find_function(functions, exercise.function); }

    /// The exercise where the compiler stopped, or where a bracket is missing.
    const Exercise *broken(const Verdict &why) const {
        const Function *function = why.kind == Outcome::does_not_compile ? in_line(why.line) : nullptr;
        if (function == nullptr) return nullptr;
        const auto exercise = std::ranges::find(exercises, function->name, &Exercise::function);
        return exercise == exercises.end() ? nullptr : &*exercise;
    }

    /// Takes out what broke it and is no exercise's: a `main`, or the body of the helper where the compiler stopped.
    /// @return whether there's such a thing
    bool take_out_helper(const Verdict &why) {
        if (const Function *main = find_function(functions, "main");
            main != nullptr && why.kind == Outcome::does_not_link)
            replace(*main, "");
        else if (const Function *helper = why.kind == Outcome::does_not_compile ? in_line(why.line) : nullptr)
            replace(*helper, source_text.substr(helper->begin, helper->body - helper->begin)
                                 + "{ throw \"a helper of yours that doesn't compile\"; }");
        else return false;
        return true;
    }

    /// Puts something else where the function is, and takes out all others of that name.
    void replace(const Exercise &exercise, const std::string &with) {
        const Function *first = find_function(functions, exercise.function);
        std::string all;
        std::size_t at = 0;
        for (const Function &each : functions) {
            if (each.name != exercise.function || each.begin < at) continue;
            all += source_text.substr(at, each.begin - at) + in_place_of(each, &each == first ? with : "");
            at = each.end;
        }
        read(all + source_text.substr(at));
    }

    /// What stands for a function that doesn't compile: as the stub declares it, and not started.
    std::string empty(const Exercise &exercise) const {
        const Function *function = find_function(of_stub, exercise.function);
        if (function == nullptr) return "";
        return stub.substr(function->begin, function->body - function->begin) + "{ throw course::NotYet{\"\"}; }";
    }

  private:
    std::string stub;
    Functions of_stub;
    std::vector<std::string> known; ///< functions of the stub
    std::string source_text;
    Source scanned{""};
    Functions functions;

    void read(std::string text) {
        source_text = std::move(text);
        scanned = Source{source_text};
        functions = functions_of(scanned, known);
    }

    const Function *in_line(int line) const {
        if (line == 0) return nullptr;
        const std::size_t begins = scanned.line_begins(line), code = scanned.code.find_first_not_of(" \t", begins);
        return function_around(functions, std::min(code, scanned.code.size()));
    }

    /// With as many lines, so that all others stay where they are.
    std::string in_place_of(const Function &old, std::string with) const {
        const auto lines = std::count(source_text.begin() + long(old.begin), source_text.begin() + long(old.end), '\n')
                           - std::ranges::count(with, '\n');
        return with.append(static_cast<std::size_t>(std::max(lines, 0l)), '\n');
    }
    void replace(const Function &old, const std::string &with) {
        read(source_text.substr(0, old.begin) + in_place_of(old, with) + source_text.substr(old.end));
    }
};

bool fails(const Outcomes &outcomes, const std::string &exercise) {
    return std::ranges::any_of(outcomes.verdicts,
                               [&](const Verdict &v) { return v.exercise == exercise && !v.passed(); });
}

/// All failing exercises that this one calls, directly or by another failing one. They come before it: else two that
/// call each other would both be called right.
std::vector<const Exercise *> called_by(const Exercise &exercise, const Remains &remains, const Outcomes &outcomes) {
    std::vector<const Exercise *> all{&exercise};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Function *function = remains.find(*all[i]);
        if (function == nullptr) continue;
        for (const Exercise &other : remains.exercises)
            if (&other < &exercise && std::ranges::find(all, &other) == all.end() && fails(outcomes, other.number)
                && remains.find(other) != nullptr && calls(remains.source(), *function, other.function))
                all.push_back(&other);
    }
    all.erase(all.begin());
    return all;
}

/// Finds out which exercises fail only because of others: with ours in the place of those, and of no others, they pass.
void find_consequences(const Workspace &workspace, const Section &section, const std::string &name,
                       const Remains &remains, unsigned seed, Outcomes &outcomes) {
    for (const Exercise &exercise : remains.exercises) {
        if (!fails(outcomes, exercise.number) || outcomes.without.contains(exercise.number)) continue;
        const auto called = called_by(exercise, remains, outcomes);
        if (called.empty()) continue;
        Remains alone = remains;
        std::string numbers;
        std::vector<std::string> lent;
        for (const Exercise *other : called) {
            alone.replace(*other, "");
            lent.push_back(other->function);
            numbers += (numbers.empty() ? "" : other == called.back() ? " and " : ", ") + other->number;
        }
        const JudgeResult again =
            judge(workspace, section, name, alone.text(), {.seed = seed, .exercise = exercise.number, .lent = lent});
        if (again.all_passed()) outcomes.because_of[exercise.number] = numbers;
    }
}

std::vector<std::string> lines_of(const std::vector<Verdict> &verdicts) {
    std::vector<std::string> lines;
    for (const Verdict &verdict : verdicts) lines.push_back(to_line(verdict));
    return lines;
}

std::vector<Verdict> verdicts_in(const std::vector<std::string> &lines) {
    std::vector<Verdict> verdicts;
    for (const std::string &line : lines) verdicts.push_back(from_line(line).value());
    return verdicts;
}

} // namespace

Outcomes outcomes_of(const Workspace &workspace, const Section &section, const std::string &name,
                     const std::string &text, unsigned seed) try {
    Outcomes outcomes;
    Remains remains{workspace, section, text};
    JudgeResult result = judge(workspace, section, name, remains.text(), {.seed = seed});
    const std::optional<Verdict> first = result.unbuilt;
    while (result.unbuilt) {
        const Exercise *broken = remains.broken(*result.unbuilt);
        if (broken != nullptr && !outcomes.without.contains(broken->number)) {
            outcomes.without[broken->number] = *result.unbuilt;
            remains.replace(*broken, remains.empty(*broken));
        } else if (broken == nullptr && outcomes.taken_out.size() < most_helpers
                   && remains.take_out_helper(*result.unbuilt))
            outcomes.taken_out.push_back(*result.unbuilt);
        else return {.unbuilt = first};
        result = judge(workspace, section, name, remains.text(), {.seed = seed});
    }
    if (result.our_fault()) return {.our_trouble = "a test of the section said nothing: the course is at fault"};
    outcomes.verdicts = std::move(result.verdicts);
    find_consequences(workspace, section, name, remains, seed, outcomes);
    return outcomes;
} catch (const EnvironmentError &trouble) {
    return {.our_trouble = trouble.what()};
}

std::string to_text(const Outcomes &outcomes) {
    nlohmann::json json{{"because_of", outcomes.because_of},
                        {"our_trouble", outcomes.our_trouble},
                        {"verdicts", lines_of(outcomes.verdicts)},
                        {"taken_out", lines_of(outcomes.taken_out)},
                        {"without", nlohmann::json::array()}};
    if (outcomes.unbuilt) json["unbuilt"] = to_line(*outcomes.unbuilt);
    for (const auto &[exercise, why] : outcomes.without) json["without"].push_back({exercise, to_line(why)});
    return json.dump(1) + '\n';
}

std::optional<Outcomes> outcomes_from(const std::string &text) try {
    const auto json = nlohmann::json::parse(text);
    Outcomes outcomes{.verdicts = verdicts_in(json.at("verdicts")),
                      .taken_out = verdicts_in(json.at("taken_out")),
                      .because_of = json.at("because_of"),
                      .our_trouble = json.at("our_trouble")};
    if (const auto unbuilt = json.find("unbuilt"); unbuilt != json.end())
        outcomes.unbuilt = from_line(unbuilt->get<std::string>()).value();
    for (const auto &pair : json.at("without"))
        outcomes.without[pair.at(0)] = from_line(pair.at(1).get<std::string>()).value();
    return outcomes;
} catch (const std::exception &) { // of the parser, of a member, or of a verdict that is none
    return {};
}

} // namespace course
