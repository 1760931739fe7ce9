#include "judge/runner/session.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"
#include "course.hpp"
#include "judge/runner/describe.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <sstream>
#include <sys/wait.h>

namespace course {
namespace {

/// Nobody's fault but the machine's: then nothing is judged.
constexpr const char *too_busy =
    "this machine is so busy that your code got too little of the processor to answer; try "
    "again when less is going on. Nothing was judged";
constexpr const char *no_answer = "Something other than your function's result came back. Does your code start another "
                                  "process, or write to a file descriptor that it didn't open?";

std::string leave_sentence(int code, bool before_main) {
    return "Your code ended the program"
           + std::string{before_main ? " before the first test, in the constructor of a global variable" : ""}
           + " (exit code " + std::to_string(code) + "). An exercise returns its answer; it must not call exit().";
}

std::string fault_sentence(std::uint64_t address, wire::Crash why) {
    if (why == wire::Crash::floating_trap)
        return "Your code turned on floating-point traps, and one went off. Take out `feenableexcept`: then you see "
               "where infinity, or a number that isn't one, comes from.";
    if (why == wire::Crash::full_stack)
        return "Your code crashed: a function called itself, again and again, until the stack was full. When does it "
               "stop?";
    if (address < 4096) return "Your code crashed: it used a null pointer, or an empty vector's elements.";
    return "Your code crashed: it used memory that isn't its own. An index beyond the end? A reference to something "
           "that's gone?";
}

/// Whether an answer has a number so large or so small that no calculation of this course gives it: what a variable
/// without a value holds (see -ftrivial-auto-var-init in cmake/Flags.cmake), or what comes of it.
bool has_strange_number(const std::string &answer) {
    for (const char *exponent : {"e+29", "e+30", "e-29", "e-30"}) // with one digit more: 290 to 309
        for (std::size_t at = 0; (at = answer.find(exponent, at)) != answer.npos; at += 4)
            if (at > 0 && is_digit(answer[at - 1]) && at + 4 < answer.size() && is_digit(answer[at + 4])) return true;
    return false;
}

std::string as_sentence(const std::string &words) {
    return words.empty() || std::string_view{".?!"}.find(words.back()) == std::string_view::npos ? words + '.' : words;
}

std::optional<double> as_number(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional{number} : std::nullopt;
}

/// "…, but is -nan", as course::require says it.
std::string in_words(std::string refusal) {
    for (const std::string_view nan : {" but is -nan", " but is nan"})
        if (refusal.ends_with(nan)) return refusal.erase(refusal.size() - nan.size()) + " but isn't a number";
    return refusal;
}

/// The exercise of a function that isn't started: of an earlier section's it says "motion::step_all".
const ExerciseLine *exercise_of(std::string_view function) {
    const std::size_t colons = function.find("::");
    const bool is_earlier = colons != function.npos;
    const std::string_view section = function.substr(0, is_earlier ? colons : 0),
                           name = function.substr(is_earlier ? colons + 2 : 0);
    const auto &lines = is_earlier ? earlier_exercise_lines() : exercise_lines();
    const auto line = std::ranges::find_if(lines, [&](const ExerciseLine *one) {
        return one->function == name && (!is_earlier || one->section == section);
    });
    return line == lines.end() ? nullptr : *line;
}

} // namespace

Session *&session() {
    static Session *only = nullptr;
    return only;
}

std::string explain_exception(const std::string &what) {
    if (what == "bad optional access" || what == "bad_optional_access") // GNU's library, and LLVM's
        return "Your code answered \"nothing\" where there's something.";
    return "Your code refused this input with std::invalid_argument (" + what + "), but the header accepts it."
           + (session()->is_computed(what) ? " That number isn't in the input: your code computed it. Did it then "
                                             "call a function that refuses it?"
                                           : "");
}

Session::Session(std::filesystem::path subject_, TimeLimits limits_, std::string answer_)
    : program{std::move(subject_)}, answer{std::move(answer_)}, limits{limits_} {}

void Session::begin(std::string exercise, std::string test) {
    const double least = std::min(0.2, limits.a_case); // [s] still far more than working code takes
    const bool hurry = exercise == hung_exercise || spent_in_all > 2 * limits.all;
    allowance = hurry ? least : std::clamp((limits.all - spent_hanging) / 5, least, limits.a_case);
    large = false;
    verdict = {.exercise = std::move(exercise), .test = std::move(test)};
    calls = 0;
    called_exercises.clear();
    last_result.clear();
    last_exercise = nullptr;
    noted.reset();
    accepted.clear();
}

void Session::allow(double seconds) {
    if (!large)
        allowance *= seconds / TimeLimits{}.a_case; // a case with generated values says it again for each of them
    large = true;
    renew_allowance();
}

/// From now on the running case has the whole allowance again.
void Session::renew_allowance() {
    if (!subject) return;
    const double now = subject->spent();
    spent_in_all += now - spent_before;
    spent_before = now;
}

Deadline Session::deadline() const {
    constexpr double clock = 20; // [s] the twentieth part of a core is enough
    return {spent_before + allowance, clock * std::max(allowance, 1.0)};
}

void Session::refuse_nameless() {
    if (last_exercise != nullptr && verdict.passed()
        && !own) // before the first call a test looks at numbers of the test itself
        end_case(Outcome::no_verdict,
                 "This check compares something that the test computed, and doesn't name it: a mistake "
                 "of ours, not of yours.");
}

void Session::accept(const std::string &input, const std::string &value) {
    std::string what = input;
    if (input.empty() && last_exercise != nullptr)
        for (const std::string &argument : last_exercise->describe_arguments(*last_exercise, last_arguments))
            what += (what.empty() ? "" : ", ") + argument;
    auto entry = std::ranges::find_if(accepted, [&](const auto &one) { return one.first == what; });
    if (entry == accepted.end()) entry = accepted.insert(entry, {what, {}});
    std::vector<std::string> &values = entry->second;
    if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(value);
}

bool Session::is_computed(std::string_view refusal) const {
    constexpr std::string_view but = ", but is";
    const std::size_t at = refusal.rfind(but);
    if (at == refusal.npos || last_exercise == nullptr) return false;
    const std::string_view rest = refusal.substr(at + but.size()); // " 5", or "n't a number", which no input is
    const auto refused = as_number(rest.substr(rest.starts_with(' ') ? 1 : 0));
    for (std::string argument : last_exercise->describe_arguments(*last_exercise, last_arguments)) {
        if (contains(argument, "… ")) return false; // a long list: not all of it is there
        std::ranges::replace_if(
            argument,
            [](char c) {
                return contains("[](){},", {&c, 1});
            },
            ' ');
        std::istringstream words{argument};
        for (std::string word; words >> word;)
            if (refused && as_number(word) == refused) return false;
    }
    return true;
}

void Session::note_verdict(Outcome kind, std::string sentence) {
    if (!verdict.passed()) return;
    verdict.kind = kind;
    verdict.sentence = std::move(sentence);
    if (last_exercise == nullptr || !greeted) return;
    verdict.call = Call{std::string{last_exercise->function},
                        last_exercise->describe_arguments(*last_exercise, last_arguments), static_cast<int>(calls) - 1,
                        last_result.empty() ? "" : last_exercise->describe_result(*last_exercise, last_result)};
}

void Session::end_case(Outcome kind, std::string sentence) {
    note_verdict(kind, std::move(sentence));
    throw CaseOver{};
}

/// The process has ended without being stopped: what does the exit code or signal tell?
void Session::judge_end(int status, bool before_main) {
    const std::string where = before_main ? "Before the first test, in the constructor of a global variable: " : "";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ)
        note_verdict(Outcome::printed_too_much, where + "Your code printed more than "
                                                    + std::to_string(print_limit >> 20)
                                                    + " MB and was stopped: does it print in a loop that never ends?");
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        note_verdict(Outcome::too_long, where + "Your code used two minutes of computing time.");
    else if (WIFSIGNALED(status))
        note_verdict(Outcome::crashed, where + "Your code " + meaning_of_signal(WTERMSIG(status)) + '.');
    else if (WIFEXITED(status) && WEXITSTATUS(status) == wire::pipe_is_gone)
        note_verdict(Outcome::out_of_turn,
                     where + "Your code closed a file that it had not opened, and its answer was lost.");
    else note_verdict(Outcome::left, leave_sentence(WEXITSTATUS(status), before_main));
}

/// No answer: because of time, because the process is gone, or because what came is not an answer.
void Session::end_case_in_silence() {
    const bool before_main = !greeted;
    if (subject->silence == StudentProcess::Silence::starved) end_case(Outcome::no_verdict, machine_trouble = too_busy);
    if (subject->silence == StudentProcess::Silence::late && before_main)
        end_case(
            Outcome::too_long,
            "Your code starts before the first test, in the constructor of a global variable, and doesn't come to an "
            "end.");
    if (subject->silence == StudentProcess::Silence::late) {
        hung_exercise = verdict.exercise;
        spent_hanging += subject->spent() - spent_before;
        end_case(
            Outcome::too_long,
            subject->slept() ? "Your code waits for something that never comes. An exercise computes its answer, and "
                               "never sleeps."
            : large ? "Your code takes far too long. This test's input is large: do you do more work than you must? Or "
                      "is there a loop that never stops?"
                    : "Your code gave no answer: look for a loop that never stops.");
    }
    if (subject->silence == StudentProcess::Silence::too_large || subject->silence == StudentProcess::Silence::nonsense)
        answered_nonsense(subject->silence == StudentProcess::Silence::too_large && !before_main);
    const auto status = subject->finish(deadline());
    if (!status)
        end_case(Outcome::out_of_turn, "Your code closed a file that it had not opened, and its answer was lost.");
    judge_end(*status, before_main);
    throw CaseOver{};
}

void Session::answered_nonsense(bool too_large) {
    last_result.clear();
    if (too_large)
        end_case(Outcome::wrong, "Your answer is larger than " + std::to_string(wire::largest_frame >> 20)
                                     + " MB: does a loop add to the list too often?");
    end_case(Outcome::out_of_turn, no_answer);
}

/// Starting has another allowance: a hang elsewhere takes nothing from it.
void Session::start() {
    greeted = false;
    if (spent_starting > limits.all)
        end_case(
            Outcome::too_long,
            "Your code is started again for each test, and all these starts take too long: what does the constructor "
            "of a global variable do?");
    subject = std::make_unique<StudentProcess>(program, answer);
    const auto hello = subject->receive({limits.start});
    spent_before = subject->spent();
    spent_starting += spent_before;
    if (!hello) end_case_in_silence();
    if (hello->header.frame == wire::Frame::crashed) {
        subject->finish(deadline());
        end_case(Outcome::crashed,
                 "Before the first test, in the constructor of a global variable: your code crashed.");
    }
    wire::Reader reader{hello->payload};
    if (hello->header.frame != wire::Frame::hello || reader.take<std::uint32_t>() != exercise_lines().size()
        || !reader.finished())
        answered_nonsense();
    greeted = true;
}

/// The function that was called tells where to begin, or another one that it calls.
void Session::note_not_started(const std::string &hint, std::string_view function) {
    if (!verdict.passed()) return;
    const ExerciseLine *other = exercise_of(function);
    if (other != nullptr && other != last_exercise)
        verdict.needs = std::string{other->number} + ' ' + std::string{other->function};
    note_verdict(Outcome::not_started,
                 (verdict.needs.empty() ? "Not started." : "It calls " + verdict.needs + ", which isn't started.")
                     + " Where to begin: " + as_sentence(hint));
}

std::string_view Session::call(const ExerciseLine &exercise, std::string arguments) {
    if (!machine_trouble.empty()) end_case(Outcome::no_verdict, machine_trouble);
    if (!verdict.passed()) throw CaseOver{};
    if (never_starts) {
        const auto [test, of] = std::pair{verdict.test, verdict.exercise};
        verdict = *never_starts;
        verdict.test = test;
        verdict.exercise = of;
        throw CaseOver{};
    }
    if (!subject) {
        try {
            start();
        } catch (const CaseOver &) {
            never_starts = verdict;
            throw;
        } catch (const EnvironmentError &trouble) {
            machine_trouble = trouble.what();
            end_case(Outcome::no_verdict, machine_trouble);
        }
    }

    last_exercise = &exercise;
    called_exercises.emplace(exercise.number);
    last_arguments = std::move(arguments);
    last_result.clear();
    ++calls;
    auto reply =
        subject->send(calls, exercise.index, last_arguments, deadline()) ? subject->receive(deadline()) : std::nullopt;
    if (!reply) end_case_in_silence();
    if (reply->header.call != calls) answered_nonsense();

    wire::Reader in{reply->payload};
    if (reply->header.frame == wire::Frame::result) return last_result = std::move(reply->payload);
    if (reply->header.frame == wire::Frame::crashed) {
        const wire::Crash why{in.take<std::uint32_t>()};
        std::uint64_t address = 0;
        in.raw(&address, sizeof address);
        end_case(Outcome::crashed, fault_sentence(address, why));
    }
    constexpr std::size_t most = 4096; // [bytes] of words that anybody reads
    const auto first = in.take<std::string>().substr(0, most), second = in.take<std::string>().substr(0, most);
    if (!in.finished()) answered_nonsense();
    const auto tidied = [](const std::string &text) {
        const auto lines = tidy(text, 1).first;
        return lines.empty() ? std::string{} : lines.front();
    };
    switch (reply->header.frame) {
    case wire::Frame::refused: throw std::invalid_argument{in_words(tidied(first))};
    case wire::Frame::not_yet: note_not_started(tidied(first), second); throw CaseOver{};
    case wire::Frame::missing:
        end_case(Outcome::missing, "Your file has no function `" + std::string{exercise.function}
                                       + "` with the parameters that the header asks for.");
    case wire::Frame::no_memory:
        end_case(Outcome::no_memory, "Your code asked for more than " + std::to_string(memory_limit >> 20)
                                         + " MB of memory: does a loop add to a vector without an end?");
    case wire::Frame::threw:
        end_case(Outcome::threw,
                 "Your code threw " + tidied(first) + (second.empty() ? "" : ": " + tidied(second))
                     + ". An exercise throws nothing but std::invalid_argument, and only for bad input.");
    default: answered_nonsense();
    }
}

void Session::note_no_memory() {
    last_result.clear(); // which a verdict would unpack once more
    note_verdict(Outcome::no_verdict, machine_trouble =
                                          "no memory is left for the tests; end what needs much of it, and "
                                          "try again");
}

void Session::fail(Outcome kind, std::string sentence, const std::string &file, int line) {
    if (verdict.file.empty()) std::tie(verdict.file, verdict.line) = std::tie(file, line);
    if (!accepted.empty()) return; // the verdict is about these
    if (verdict.passed() && noted) {
        std::tie(verdict.label, verdict.yours, verdict.expected, verdict.whole, verdict.tolerance, verdict.since) =
            std::tie(noted->label, noted->yours, noted->expected, noted->whole, noted->tolerance, noted->since);
        verdict.off = noted->off;
        if (own) return note_verdict(kind, std::move(sentence));
        if (sentence.empty() && has_strange_number(noted->yours))
            sentence =
                "A strange number. Was a variable never given a value? Write `double sum = 0;`, not `double sum;`.";
        if (sentence.empty() && contains(noted->yours, "infinity") && !contains(noted->expected, "infinity"))
            sentence = "Your answer is infinite. Was something divided by zero? 1 / 2 is 0, too, as both are whole "
                       "numbers. Or did a "
                       "search start at infinity and find nothing?";
        if (noted->not_a_number) {
            kind = Outcome::not_a_number;
            sentence =
                "Your answer is \"not a number\": it comes from 0/0, infinity - infinity, the root of a negative "
                "number, an arcsine or arccosine beyond 1, or a Vec2 without a value.";
        }
    }
    note_verdict(kind, std::move(sentence));
}

/// What the last call answers in a new process, where no other came before it; nothing if it does not answer, or if
/// the machine has no room for another process.
std::optional<std::string> Session::ask_alone() const try {
    StudentProcess alone{program, answer};
    const Deadline most{limits.start + limits.a_case};
    const auto hello = alone.receive(most);
    if (!hello || hello->header.frame != wire::Frame::hello
        || !alone.send(1, last_exercise->index, last_arguments, most))
        return {};
    const auto reply = alone.receive(most);
    if (!reply || reply->header.frame != wire::Frame::result) return {};
    return reply->payload;
} catch (const EnvironmentError &) {
    return {};
}

/// Says so if the last call is answered differently without the calls before it. Asked twice: code that answers anything
/// at random remembers nothing.
void Session::look_for_memory() {
    constexpr double most = 6; // [s] of all cases: it's a hint, and code may be slow on purpose
    static double taken = 0;
    if (taken > most) return;
    const auto began = std::chrono::steady_clock::now();
    const auto alone = ask_alone();
    const bool is_remembered = alone && *alone != last_result && ask_alone() == alone;
    taken += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (!is_remembered) return;
    verdict.sentence += (verdict.sentence.empty() ? "" : " ") + std::string{"Called on its own, your function gives "}
                        + last_exercise->describe_result(*last_exercise, *alone)
                        + ": something is remembered from an earlier call. Look for `static`, or a global variable.";
}

Verdict Session::end(bool asserted_something) {
    if (verdict.passed() && !asserted_something)
        note_verdict(Outcome::no_verdict,
                     own ? "This test checks nothing: say with CHECK or CHECK_THAT what must come out."
                         : "This test asserts nothing: our mistake, not yours.");
    if (subject && verdict.passed()) {
        const auto status = subject->finish(deadline());
        if (!status && subject->silence == StudentProcess::Silence::starved)
            note_verdict(Outcome::no_verdict, machine_trouble = too_busy);
        else if (!status)
            note_verdict(Outcome::too_long, "Your code answered, but its process didn't end: did it start a thread?");
        else if (!WIFEXITED(*status)) judge_end(*status, false);
        else if (subject->said_more()) {
            last_result.clear();
            note_verdict(Outcome::out_of_turn, no_answer);
        }
        if (subject->left_processes())
            note_verdict(Outcome::left_process, "Your code started another process and left it running. An exercise "
                                                "computes a value, and starts nothing.");
    }
    if (!accepted.empty()) {
        verdict.kind = Outcome::wrong;
        verdict.sentence = "Your code accepted input that it must refuse with std::invalid_argument:";
        verdict.call.reset();
        constexpr std::size_t most = 20;
        for (const auto &[input, values] : accepted) {
            if (verdict.accepted.size() == most) break;
            std::string line = input;
            for (const std::string &value : values) line += (&value == &values.front() ? " = " : ", ") + value;
            verdict.accepted.push_back(line);
        }
        if (accepted.size() > most)
            verdict.accepted.push_back("and " + std::to_string(accepted.size() - most) + " more");
    }
    if (subject && !verdict.passed()) {
        const std::string printed = subject->printed();
        std::tie(verdict.printed, verdict.printed_more) = tidy(printed);
        const std::string meaning = verdict.kind == Outcome::crashed ? meaning_of_assertion(printed) : "";
        if (!meaning.empty())
            verdict.sentence = "Your code was stopped by a check of the library that it uses: " + meaning + '.';
    }
    if (never_starts && never_starts->printed.empty()) never_starts->printed = verdict.printed;
    renew_allowance();
    subject.reset();
    if (verdict.call && calls > 1 && !own && verdict.kind != Outcome::too_long) look_for_memory();
    return std::move(verdict);
}

std::string_view call(const ExerciseLine &exercise, std::string arguments) {
    return session()->call(exercise, std::move(arguments));
}
void answered_nonsense(bool too_large) { session()->answered_nonsense(too_large); }
void note_mismatch(const Mismatch &mismatch) { session()->note(mismatch); }
void note_accepted(const std::string &input, const std::string &value) { session()->accept(input, value); }
std::optional<std::string_view> unit_of_answer(std::string_view bytes) {
    if (session()->last_exercise == nullptr || session()->last_result != bytes) return {};
    return session()->last_exercise->unit;
}
void refuse_nameless() { session()->refuse_nameless(); }
void allow(double seconds) { session()->allow(seconds); }

} // namespace course
