#include "class/pool.hpp"

#include "ground/complaint.hpp"
#include "ground/kernel.hpp"
#include "ground/process.hpp"
#include "verdict/tests/subject.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace course {
namespace {

using Number = unsigned;

[[noreturn]] void work(int queue, int ended, const std::function<void(std::size_t)> &job) {
    end_with_parent(SIGTERM); // which ends what it runs, too
    try {
        for (Number number = 0; ::read(queue, &number, sizeof number) == sizeof number;) {
            job(number);
            if (::write(ended, &number, sizeof number) != sizeof number) break;
        }
        ::_exit(all_well);
    } catch (...) { // Ctrl-C, or something that the job has left no word of
        ::_exit(our_fault);
    }
}

extern "C" void on_stop(int signal) {
    constexpr std::string_view words =
        "\nStopped. What's judged is kept: the same command once more goes on from here.\n";
    (void)!::write(STDERR_FILENO, words.data(), words.size());
    ::_exit(128 + signal); // which ends the others, too
}

} // namespace

void in_parallel(std::size_t count, const std::function<void(std::size_t)> &job, const std::function<void()> &done) {
    auto [queue, filling] = make_pipe(); // of all numbers: what one process reads from it, no other one gets
    ::fcntl(filling, F_SETFL, O_NONBLOCK);
    for (Number number = 0; number < count; ++number)
        if (::write(filling, &number, sizeof number) != sizeof number)
            throw Complaint{std::to_string(count)
                            + " submissions are too many at once: take a part, as in --shard 1/8"};
    filling.close();
    auto [ends, ended] = make_pipe();
    std::vector<pid_t> processes;
    for (std::size_t i = 0; i < std::min(cores().size(), count); ++i) {
        processes.push_back(::fork());
        if (processes.back() == 0) work(queue, ended, job);
        if (processes.back() < 0) processes.pop_back();
    }
    if (processes.empty() && count > 0) throw MachineTrouble{"no process can be started; close some programs"};
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, on_stop);
    ended.close();
    Number number = 0;
    while (::read(ends, &number, sizeof number) == sizeof number) done();
    for (const pid_t process : processes) ::waitpid(process, nullptr, 0);
    catch_signals();
}

} // namespace course
