// A subject that tries one thing which a student's code may not do, and prints "done" or why it could not.
// COURSE_ANSWER says what: see shut_in_test.cpp.

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <linux/capability.h>
#include <string>
#include <sys/ipc.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

bool fork_one() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

bool leave_a_daemon() {
    const pid_t child = ::fork();
    if (child == 0) {
        ::setsid();
        if (::fork() == 0) ::sleep(1000);
        ::sleep(1000);
    }
    return child > 0;
}

bool take_memory_that_stays() {
    const int segment = ::shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
    return segment >= 0 && ::shmctl(segment, IPC_RMID, nullptr) == 0;
}

bool take_memory() {
    const std::size_t too_much = 300u << 20;
    void *const memory = std::malloc(too_much);
    if (memory) std::memset(memory, 1, too_much);
    return memory != nullptr;
}

bool open_many_files() {
    for (int i = 0; i < 100; ++i)
        if (::dup(0) < 0) return false;
    return true;
}

bool rename_the_machine_to_its_name() {
    utsname names{};
    return ::uname(&names) == 0 && ::sethostname(names.nodename, std::strlen(names.nodename)) == 0;
}

bool have_a_capability() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3] = {};
    if (::syscall(SYS_capget, &header, sets) != 0) return false;
    for (const auto &set : sets)
        if ((set.effective | set.permitted | set.inheritable) != 0) return true;
    return errno = EPERM, false;
}

/// Prints five megabytes, and goes back to the beginning, so that the answer can still be written.
bool print_a_lot() {
    ::signal(SIGXFSZ, SIG_IGN);
    const std::string block(1u << 20, '\n');
    bool all = true;
    for (int i = 0; i < 5 && all; ++i)
        all = ::write(1, block.data(), block.size()) == static_cast<ssize_t>(block.size());
    const int error = errno;
    ::lseek(1, 0, SEEK_SET);
    errno = error;
    return all;
}

bool try_to(const std::string &what, const char *file) {
    rlimit limit{};
    int ends[2];
    if (what == "write") return ::open(file, O_WRONLY) >= 0;
    if (what == "read") return ::open(file, O_RDONLY) >= 0;
    if (what == "delete") return ::unlink(file) == 0;
    if (what == "make") return ::mkdir((std::string{file} + ".folder").c_str(), 0755) == 0;
    if (what == "change mode") return ::chmod(file, 0600) == 0;
    if (what == "execute") return ::execl("/bin/echo", "echo", "done", nullptr) == 0;
    if (what == "fork") return fork_one();
    if (what == "leave a daemon") return leave_a_daemon();
    if (what == "trace") return ::ptrace(PTRACE_TRACEME, 0, 0, 0) == 0;
    if (what == "signal") return ::kill(::getppid(), 0) == 0;
    if (what == "signal by a pipe") return ::pipe(ends) == 0 && ::fcntl(ends[0], F_SETOWN, ::getppid()) == 0;
    if (what == "limit") return ::prlimit(::getppid(), RLIMIT_CORE, nullptr, &limit) == 0;
    if (what == "outlive") return ::prctl(PR_SET_PDEATHSIG, 0) == 0;
    if (what == "share memory") return take_memory_that_stays();
    if (what == "connect") return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0;
    if (what == "host name") return rename_the_machine_to_its_name();
    if (what == "capability") return have_a_capability();
    if (what == "memory") return take_memory();
    if (what == "many files") return open_many_files();
    if (what == "print") return print_a_lot();
    if (what == "inherit") return ::fcntl(200, F_GETFD) >= 0;
    return errno = ENOSYS, false;
}

} // namespace

int main() {
    const std::string request = std::getenv("COURSE_ANSWER");
    const std::size_t colon = request.find(':');
    std::puts(try_to(request.substr(0, colon), request.c_str() + colon + 1) ? "done" : std::strerror(errno));
    std::fflush(stdout);
}
