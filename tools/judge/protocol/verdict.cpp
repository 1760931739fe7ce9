#include "judge/protocol/verdict.hpp"

#include "base/plain.hpp"
#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <iterator>
#include <utility>

namespace course {
namespace {
constexpr std::string_view names[] = { // in the order of Outcome
    "passed",
    "wrong",
    "not started",
    "is empty",
    "can't be read",
    "does not compile",
    "does not link",
    "function missing",
    "threw",
    "crashed",
    "out of memory",
    "too long",
    "ended the program",
    "not a number",
    "answered out of turn",
    "left a process",
    "printed too much",
    "no verdict"};
static_assert(std::size(names) == static_cast<std::size_t>(Outcome::no_verdict) + 1);

/// A struct of structs that would be wider than a screen: each part on a line by itself, below the first.
std::string in_lines(const std::string &line, std::size_t before) {
    constexpr std::size_t widest = 100; // bytes, which are nearly columns
    const std::size_t opens = line.find('{');
    if (before + line.size() <= widest || opens == line.npos || !line.ends_with('}')) return line;
    if (opens != 0 && !line.substr(0, opens).ends_with(" = ")) return line; // a list of structs, for example
    std::string text;
    int depth = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '{') ++depth;
        if (line[i] == '}') --depth;
        const bool ends_part = line[i] == ',' && depth == 1 && line[i - 1] == '}';
        text += line[i];
        if (!ends_part) continue;
        text += '\n' + std::string(before + opens + 1, ' ');
        ++i; // the blank behind the comma
    }
    return text;
}

/// What a library says of a check that failed, without the name of the function, which fills the screen.
std::string short_assertion(std::string_view line) {
    const std::size_t at = line.find(" Assertion "), place = line.find(": ", line.find('/')),
                      name = line.rfind('/', place);
    if (at == line.npos || name == line.npos) return std::string{line};
    return std::string{line.substr(name + 1, place - name)} + std::string{line.substr(at)};
}

} // namespace

std::string_view name_of(Outcome kind) { return names[static_cast<std::size_t>(kind)]; }

static void to_json(nlohmann::json &json, Outcome kind) { json = name_of(kind); }
static void from_json(const nlohmann::json &json, Outcome &kind) {
    const auto name = std::ranges::find(names, json.get<std::string>());
    kind = name == std::end(names) ? Outcome::no_verdict : static_cast<Outcome>(name - names);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Call, function, arguments, before, answer)

} // namespace course

template <> struct nlohmann::adl_serializer<std::optional<course::Call>> {
    static void to_json(json &json, const std::optional<course::Call> &call) {
        if (call) json = *call; // else null
    }
    static void from_json(const json &json, std::optional<course::Call> &call) {
        if (!json.is_null()) call = json.get<course::Call>();
    }
};

namespace course {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Verdict, exercise, test, kind, sentence, call, accepted, label, yours, expected,
                                   tolerance, whole, since, off, file, line, printed, printed_more, needs)

std::string to_line(const Verdict &verdict) {
    return nlohmann::json(verdict).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::optional<Verdict> from_line(std::string_view line) try {
    return nlohmann::json::parse(line).get<Verdict>();
} catch (const nlohmann::json::exception &) {
    return {};
}

std::string explain(const Verdict &v, int indent) {
    const std::string margin(static_cast<std::size_t>(indent), ' ');
    std::string text;
    const auto say = [&](const std::string &line) { text += margin + line + '\n'; };

    if (!v.sentence.empty()) say(v.sentence);
    for (const auto &input : v.accepted) say("  " + input);
    const bool nothing_to_see = v.kind == Outcome::not_started || v.kind == Outcome::missing; // no input is to blame
    if (v.call && !nothing_to_see) {
        say("call      " + v.call->function + "()" + (v.call->arguments.empty() ? "" : " with")
            + (v.call->before == 0 ? "" : "   (call " + std::to_string(v.call->before + 1) + " of this test)"));
        for (const auto &argument : v.call->arguments) say("            " + in_lines(argument, margin.size() + 12));
        if (!v.call->answer.empty() && (v.call->answer != v.yours || !v.label.empty()))
            say("returned  " + in_lines(v.call->answer, margin.size() + 10));
    }
    if (!v.label.empty()) say(v.label + ':');
    if (!v.whole.empty()) say("expected  " + in_lines(v.whole, margin.size() + 10));
    if (!v.yours.empty()) say("yours     " + v.yours);
    if (!v.expected.empty()) say("expected  " + v.expected + (v.tolerance.empty() ? "" : " ± " + v.tolerance));
    if (!v.since.empty()) say("since     " + v.since);
    if (!v.file.empty() && !nothing_to_see) say("see       " + v.file + ':' + std::to_string(v.line));
    if (!v.printed.empty()) {
        say("It printed:");
        for (const auto &line : v.printed) say("  | " + line);
        if (v.printed_more > 0)
            say("  | … and " + std::to_string(v.printed_more) + (v.printed_more == 1 ? " more line" : " more lines"));
    }
    return text;
}

std::string meaning_of_signal(int signal) {
    switch (signal) {
    case SIGSEGV:
    case SIGBUS:
        return "crashed: it used memory that isn't its own; an index beyond the end, a null pointer, or a function "
               "that calls itself forever";
    case SIGABRT: return "was stopped by an uncaught exception, a failed assertion or a call of abort()";
    case SIGFPE: return "crashed: it divided a whole number by zero";
    case SIGILL:
        return "crashed: it came to the end of a function without `return`, or to an instruction that this machine "
               "lacks";
    case SIGXFSZ: return "wrote too much, and was stopped; does it write in a loop that never ends?";
    case SIGKILL: return "was killed from outside: it used up its memory or its time";
    default: return "crashed (signal " + std::to_string(signal) + ", " + ::strsignal(signal) + ')';
    }
}

std::string meaning_of_assertion(std::string_view printed) {
    const std::size_t at = std::min(printed.find(" Assertion "), printed.find(" assertion ")); // GNU's, and LLVM's
    if (at == printed.npos) return {};
    const std::string_view line = printed.substr(at, printed.find('\n', at) - at);
    if (contains_any(line, {"__n < this->size()", "index < size()", "out of bounds"})) return "an index beyond the end";
    if (contains_any(line, {"_M_is_engaged()", "disengaged"})) return "the value of an empty std::optional";
    if (contains_any(line, {"!this->empty()", "!empty()"})) return "an element of an empty vector";
    if (contains_any(line, {"!(__hi < __lo)", "std::clamp"})) return "std::clamp with its low end above its high end";
    return "see below";
}

std::pair<std::vector<std::string>, std::size_t> tidy(std::string_view printed, std::size_t lines) {
    constexpr std::size_t widest = 160; // characters: two lines of a terminal
    std::vector<std::string> first;
    std::size_t more = 0;
    while (!printed.empty()) {
        const std::size_t end = std::min(printed.find('\n'), printed.size());
        if (first.size() < lines) first.push_back(plain_line(short_assertion(printed.substr(0, end)), widest));
        else ++more;
        printed.remove_prefix(std::min(end + 1, printed.size()));
    }
    return {std::move(first), more};
}

} // namespace course
