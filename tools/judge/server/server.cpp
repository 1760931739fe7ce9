// Runs beside a student's code, in the student's process: reads calls, makes them, answers.
// Compiled once for each section; COURSE_SECTION names the header. All of it has internal linkage, and reading,
// writing and leaving are bare system calls: nothing that a student defines, a `struct Server` or a global variable
// `write`, can take their place.

#include "judge/server/calls.hpp"

#include <csignal>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using wire::Arrived, wire::largest_frame, wire::pipe_is_gone, wire::reply_fd, wire::request_fd;

#ifdef __linux__
long system_write(int file, const void *data, std::size_t size) { return ::syscall(SYS_write, file, data, size); }
long system_read(int file, void *data, std::size_t size) { return ::syscall(SYS_read, file, data, size); }
[[noreturn]] void leave(int code) {
    for (;;) ::syscall(SYS_exit_group, code);
}
#else
long system_write(int file, const void *data, std::size_t size) { return ::write(file, data, size); }
long system_read(int file, void *data, std::size_t size) { return ::read(file, data, size); }
[[noreturn]] void leave(int code) { ::_exit(code); }
#endif

/// Our caller is gone, or a student has closed the pipe: nothing can be answered any more.
void write_all(const char *data, std::size_t size) {
    while (size > 0) {
        const long written = system_write(reply_fd, data, size);
        if (written <= 0) leave(pipe_is_gone);
        data += written;
        size -= static_cast<std::size_t>(written);
    }
}

Arrived arrived;

bool read_all(void *data, std::size_t size) {
    char *to = static_cast<char *>(data);
    while (!arrived.take(to, size)) {
        const long got = system_read(request_fd, arrived.room.data(), arrived.room.size());
        if (got <= 0) return false;
        arrived.came(static_cast<std::size_t>(got));
    }
    return true;
}

/// Says which kind of crash this is before it happens: from outside, a null pointer and a recursion without end look alike.
void on_crash(int signal, siginfo_t *info, void *) {
    const auto fault = reinterpret_cast<std::uintptr_t>(info->si_addr);
    rlimit stack{};
    ::getrlimit(RLIMIT_STACK, &stack);
    const std::uintptr_t depth = reinterpret_cast<std::uintptr_t>(::environ) - fault; // the stack grows down from there
    const bool ran_out = depth > stack.rlim_cur / 2 && depth < stack.rlim_cur + (1u << 20);
    const auto why = signal == SIGFPE ? wire::Crash::floating_trap
                     : ran_out        ? wire::Crash::full_stack
                                      : wire::Crash::memory;
    const struct {
        Header header;
        wire::Crash why; // in this order there are no gaps
        std::uint64_t fault;
    } message{{wire::Frame::crashed, call_number, 12}, why, fault};
    static_assert(sizeof message == sizeof(Header) + 12);
    // Of a whole number that was divided by zero the signal itself tells.
    if (signal != SIGFPE || info->si_code != FPE_INTDIV)
        write_all(reinterpret_cast<const char *>(&message), sizeof message);
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

char handlers_stack[64 << 10]; // the handler's own: the student's may be what ran out

/// Before the student's global objects: their crashes and their printing count as well.
__attribute__((constructor(101))) void prepare() {
    std::setvbuf(stdout, nullptr, _IONBF, 0); // what was printed before a crash is what the student looks for
    stack_t own{};
    own.ss_sp = handlers_stack;
    own.ss_size = sizeof handlers_stack;
    ::sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_sigaction = on_crash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE}) ::sigaction(signal, &action, nullptr);
}

} // namespace

int main() {
    Reply hello;
    hello.put(exercises);
    hello.send(wire::Frame::hello);
    Header header;
    std::string request;
    while (read_all(&header, sizeof header) && header.frame == wire::Frame::call && header.size <= largest_frame) {
        request.resize(header.size);
        if (!read_all(request.data(), request.size())) break;
        call_number = header.call;
        make_call(request);
    }
    leave(0); // no destructors: a student's may hang, and the verdict is complete
}
