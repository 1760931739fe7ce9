#include "grade/process_pool.hpp"

#include "base/errors.hpp"
#include "base/process.hpp"
#include "judge/runner/job_queue.hpp"

#include <stdexcept>
#include <string_view>
#include <unistd.h>

namespace course {
namespace {

extern "C" void on_stop(int signal) {
    constexpr std::string_view words =
        "\nStopped. What's judged is kept: the same command once more goes on from here.\n";
    (void)!::write(STDERR_FILENO, words.data(), words.size());
    ::_exit(128 + signal); // which ends the others, too
}

} // namespace

void in_parallel(std::size_t count, const std::function<void(std::size_t)> &job,
                 const std::function<void()> &done) try {
    const JobQueue queue{.job = [&](unsigned number, AnonymousFile &) { job(number); },
                         .prepare = [](int) { catch_signals(); },
                         .job_ended = done,
                         .end_signal = SIGTERM, // which ends what a job runs, too
                         .goes_on = true};
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, on_stop);
    queue.run(count);
    catch_signals();
} catch (const std::length_error &) {
    throw UserError{std::to_string(count) + " submissions are too many at once: take a part, as in --shard 1/8"};
} catch (const EnvironmentError &trouble) {
    catch_signals();
    throw EnvironmentError{"not everything was judged; what was is kept, and the same command once more goes on. "
                           + std::string{trouble.what()}};
}

} // namespace course
