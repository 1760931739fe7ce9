#include "class/grading.hpp"

#include "ground/files.hpp"
#include "loop/functions.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace course {
namespace {

constexpr std::size_t most_helpers = 3; ///< that don't compile: each costs a compilation

/// A student's file, of which functions are taken out one after the other.
struct Remains {
    std::string text;
    std::string stub;
    std::vector<Exercise> exercises;
    std::vector<std::string> functions;

    Remains(const Tree &tree, const Section &section, std::string text_)
        : text{std::move(text_)}, stub{read_file(tree.stub(section))}, exercises{catalogue(tree, section)} {
        for (const Exercise &exercise : exercises) functions.push_back(exercise.function);
    }

    std::optional<Definition> find(const Exercise &exercise) const {
        return definition_of(code_of(text), exercise.function, functions);
    }

    /// The exercise because of which it doesn't compile: one whose braces don't close, or else the one where the compiler
    /// stopped.
    const Exercise *broken(const Verdict &why) const {
        if (why.kind != Kind::does_not_compile || why.line == 0) return nullptr;
        const Exercise *its = nullptr;
        for (const Exercise &exercise : exercises)
            if (const auto found = find(exercise)) {
                if (!found->closed) return &exercise;
                if (found->holds(line_begins(text, why.line))) its = &exercise;
            }
        return its;
    }

    /// Takes out what broke it and is no exercise's: a `main`, or the body of the helper where the compiler stopped.
    /// @return whether there's such a thing
    bool take_out_helper(const Verdict &why) {
        const std::string code = code_of(text), before = text;
        if (const auto main = definition_of(code, "main", functions); main && why.kind == Kind::does_not_link)
            replace(*main, "");
        else if (why.kind == Kind::does_not_compile && why.line > 0)
            if (const auto its = function_around(code, line_begins(text, why.line)))
                replace(*its, text.substr(its->begin, its->body - its->begin)
                                  + "{ throw \"a helper of yours that doesn't compile\"; }");
        return text != before;
    }

    void replace(const Exercise &exercise, std::string with) { replace(*find(exercise), std::move(with)); }

    /// Puts something else where the function was, and leaves all lines where they are.
    void replace(const Definition &old, std::string with) {
        const auto lines = std::count(text.begin() + long(old.begin), text.begin() + long(old.end), '\n')
                           - std::ranges::count(with, '\n');
        with.append(static_cast<std::size_t>(std::max(lines, 0l)), '\n');
        text.replace(old.begin, old.end - old.begin, with);
    }

    /// What stands for a function that doesn't compile: as the stub declares it, and not started.
    std::string empty(const Exercise &exercise) const {
        const auto its = definition_of(code_of(stub), exercise.function, functions);
        if (!its) return "";
        return stub.substr(its->begin, its->body - its->begin) + "{ throw course::NotYet{\"\"}; }";
    }
};

bool fails(const Outcomes &outcomes, const std::string &exercise) {
    return std::ranges::any_of(outcomes.verdicts,
                               [&](const Verdict &v) { return v.exercise == exercise && !v.passed(); });
}

/// All failing exercises that this one calls, directly or by another failing one.
std::vector<const Exercise *> called_by(const Exercise &exercise, const Remains &remains, const Outcomes &outcomes) {
    const std::string code = code_of(remains.text);
    std::vector<const Exercise *> all{&exercise};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto its = remains.find(*all[i]);
        if (!its) continue;
        for (const Exercise &other : remains.exercises)
            if (std::ranges::find(all, &other) == all.end() && fails(outcomes, other.number) && remains.find(other)
                && calls(code, *its, other.function))
                all.push_back(&other);
    }
    all.erase(all.begin());
    return all;
}

/// Whether the function is still there when these others are taken out: with ours in their place, ours would be judged
/// in its place, too, if it's in another namespace, say, or takes something else.
bool is_their_own(const Tree &tree, const Section &section, const std::string &name, const Exercise &exercise,
                  Remains without, const std::vector<const Exercise *> &others, unsigned seed) {
    for (const Exercise *other : others) without.replace(*other, without.empty(*other));
    const Judgement judgement = judge(tree, section, name, without.text, {.seed = seed, .exercise = exercise.number});
    return !judgement.unbuilt && std::ranges::count(judgement.verdicts, Kind::missing, &Verdict::kind) == 0;
}

/// Finds out which exercises fail only because of others.
void find_consequences(const Tree &tree, const Section &section, const std::string &name, const Remains &remains,
                       unsigned seed, Outcomes &outcomes) {
    for (const Exercise &exercise : remains.exercises) {
        if (!fails(outcomes, exercise.number) || outcomes.without.contains(exercise.number)) continue;
        const auto called = called_by(exercise, remains, outcomes);
        if (called.empty()) continue;
        Remains alone = remains;
        std::string numbers;
        for (const Exercise *other : called) {
            alone.replace(*other, "");
            numbers += (numbers.empty() ? "" : other == called.back() ? " and " : ", ") + other->number;
        }
        const Judgement again =
            judge(tree, section, name, alone.text, {.seed = seed, .exercise = exercise.number, .with_ours = true});
        if (again.all_passed() && is_their_own(tree, section, name, exercise, remains, called, seed))
            outcomes.because_of[exercise.number] = numbers;
    }
}

} // namespace

Outcomes outcomes_of(const Tree &tree, const Section &section, const std::string &name, const std::string &text,
                     unsigned seed) try {
    Outcomes outcomes;
    Remains remains{tree, section, text};
    Judgement judgement = judge(tree, section, name, remains.text, {.seed = seed});
    const std::optional<Verdict> first = judgement.unbuilt;
    while (judgement.unbuilt) {
        const Exercise *broken = remains.broken(*judgement.unbuilt);
        if (broken != nullptr && !outcomes.without.contains(broken->number)) {
            outcomes.without[broken->number] = *judgement.unbuilt;
            remains.replace(*broken, remains.empty(*broken));
        } else if (broken == nullptr && outcomes.taken_out.size() < most_helpers
                   && remains.take_out_helper(*judgement.unbuilt))
            outcomes.taken_out.push_back(*judgement.unbuilt);
        else return {.unbuilt = first};
        judgement = judge(tree, section, name, remains.text, {.seed = seed});
    }
    outcomes.verdicts = std::move(judgement.verdicts);
    if (judgement.our_fault()) outcomes.our_trouble = "a test of the section said nothing: the course is at fault";
    else find_consequences(tree, section, name, remains, seed, outcomes);
    return outcomes;
} catch (const MachineTrouble &trouble) {
    return {.our_trouble = trouble.what()};
}

std::string to_text(const Outcomes &outcomes) {
    nlohmann::json json{{"because_of", outcomes.because_of}, {"our_trouble", outcomes.our_trouble}};
    if (outcomes.unbuilt) json["unbuilt"] = to_line(*outcomes.unbuilt);
    json["verdicts"] = json["without"] = json["taken_out"] = nlohmann::json::array();
    for (const Verdict &verdict : outcomes.verdicts) json["verdicts"].push_back(to_line(verdict));
    for (const Verdict &verdict : outcomes.taken_out) json["taken_out"].push_back(to_line(verdict));
    for (const auto &[exercise, why] : outcomes.without) json["without"].push_back({exercise, to_line(why)});
    return json.dump(1) + '\n';
}

std::optional<Outcomes> outcomes_from(const std::string &text) try {
    const auto json = nlohmann::json::parse(text);
    Outcomes outcomes{.because_of = json.at("because_of"), .our_trouble = json.at("our_trouble")};
    if (const auto its = json.find("unbuilt"); its != json.end())
        outcomes.unbuilt = from_line(its->get<std::string>()).value();
    for (const auto &line : json.at("verdicts"))
        outcomes.verdicts.push_back(from_line(line.get<std::string>()).value());
    for (const auto &line : json.at("taken_out"))
        outcomes.taken_out.push_back(from_line(line.get<std::string>()).value());
    for (const auto &pair : json.at("without"))
        outcomes.without[pair.at(0)] = from_line(pair.at(1).get<std::string>()).value();
    return outcomes;
} catch (const std::exception &) { // of the parser, of a member, or of a verdict that is none
    return {};
}

} // namespace course
