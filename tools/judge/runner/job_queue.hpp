#pragma once
// Jobs done side by side, in processes of this program that end with it.

#include "judge/runner/student_process.hpp"

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace course {

/// What a process does for one number of a list; it reports in lines, where no subject can reach them.
using Job = std::function<void(unsigned number, AnonymousFile &lines)>;

struct JobQueue {
    Job job;
    std::function<void(int core)> prepare;   ///< each process, before the first job; see cores()
    std::function<void()> job_ended = [] {}; ///< called here, after each job
    std::size_t most_processes = 1000;       ///< of which there are as many as cores at most
    int end_signal = SIGKILL;                ///< what these processes get when this one ends
    bool goes_on = false;                    ///< with other jobs, after one that has thrown

    /// Does the job for each of these numbers. One that crashes reports nothing, and the others go on.
    /// @return all lines that were reported
    /// @throws EnvironmentError with the words of the first job that has thrown, or if a process was killed from outside;
    ///         what other jobs have left in files is there. std::length_error if there are more than a pipe holds, 16,384
    std::vector<std::string> run(const std::vector<unsigned> &numbers) const;

    /// For all numbers below `count`.
    std::vector<std::string> run(std::size_t count) const;
};

} // namespace course
