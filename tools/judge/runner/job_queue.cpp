#include "judge/runner/job_queue.hpp"

#include "base/errors.hpp"
#include "base/kernel.hpp"
#include "base/lines.hpp"

#include <algorithm>
#include <fcntl.h>
#include <numeric>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace course {
namespace {

constexpr std::size_t most_reported = 64u << 20; // [bytes] by one process

/// A pipe with all numbers in it: what one process reads from it, no other one gets.
UniqueFd filled_pipe(const std::vector<unsigned> &numbers) {
    auto [reading, writing] = make_pipe();
    ::fcntl(writing, F_SETFL, O_NONBLOCK);
    for (const unsigned number : numbers)
        if (::write(writing, &number, sizeof number) != sizeof number)
            throw std::length_error{"so many jobs are too many at once"};
    return std::move(reading);
}

/// Such a process.
[[noreturn]] void work(const JobQueue &queue, int numbers, int ended, int core, AnonymousFile &lines,
                       AnonymousFile &troubles) try {
    end_with_parent(queue.end_signal);
    queue.prepare(core);
    for (unsigned number = 0; ::read(numbers, &number, sizeof number) == sizeof number;) {
        try {
            queue.job(number, lines);
            if (::write(ended, &number, sizeof number) != sizeof number) break;
        } catch (const std::exception &trouble) {
            troubles.append(std::string{trouble.what()} + '\n');
            if (!queue.goes_on) break;
        }
    }
    ::_exit(all_well);
} catch (...) { // Ctrl-C, or no room even for words
    ::_exit(our_fault);
}

} // namespace

std::vector<std::string> JobQueue::run(const std::vector<unsigned> &numbers) const {
    if (numbers.empty()) return {};
    const std::vector<int> core = cores();
    std::vector<AnonymousFile> lines(std::min({core.size(), most_processes, numbers.size()}));
    AnonymousFile troubles;
    const UniqueFd waiting = filled_pipe(numbers);
    for (bool again = true; std::exchange(again, false);) {
        auto ends = make_pipe();
        std::vector<pid_t> processes;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            processes.push_back(::fork());
            if (processes.back() == 0) work(*this, waiting, ends[1], core[i], lines[i], troubles);
            if (processes.back() > 0) continue;
            processes.pop_back();
            if (i == 0) throw EnvironmentError{"no process can be started; close some programs"};
        }
        ends[1].close();
        for (unsigned number = 0; ::read(ends[0], &number, sizeof number) == sizeof number;) job_ended();
        for (const pid_t process : processes) {
            int status = 0;
            ::waitpid(process, &status, 0);
            if (WIFEXITED(status) && WEXITSTATUS(status) == all_well) continue;
            if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL)
                again = true; // a job crashed: who does what's left?
            else troubles.append("a part of them was killed from outside; has the machine run out of memory?\n");
        }
    }
    if (const std::string words = troubles.text(most_reported); !words.empty())
        throw EnvironmentError{words.substr(0, words.find('\n'))};
    std::vector<std::string> all;
    for (const AnonymousFile &file : lines) {
        const std::string text = file.text(most_reported);
        for (const Line &line : split_lines(text)) all.emplace_back(line.text);
    }
    return all;
}

std::vector<std::string> JobQueue::run(std::size_t count) const {
    std::vector<unsigned> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return run(all);
}

} // namespace course
