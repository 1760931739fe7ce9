// A subject that tries one thing which a student's code may not do, and prints "done" or why it could not.
// COURSE_ANSWER says what: see sandbox_test.cpp. With arguments it's for check_test.cpp: see without_landlock.

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <string>
#include <sys/file.h>
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
#include <system_error>
#include <thread>
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

/// By a call of Linux 6.13.
bool set_an_attribute(const char *file) {
    constexpr long setxattrat = 463;
    struct {
        std::uint64_t value;
        std::uint32_t size, flags;
    } const what{reinterpret_cast<std::uintptr_t>("x"), 1, 0};
    return ::syscall(setxattrat, AT_FDCWD, file, 0, "user.x", &what, sizeof what) == 0;
}

bool start_a_thread() try {
    std::thread{[] {}}.join();
    return true;
} catch (const std::system_error &refused) {
    return errno = refused.code().value(), false;
}

bool is_fresh_memory_zero() {
    constexpr std::size_t size = 5000;
    volatile char *volatile memory = static_cast<char *>(std::malloc(size)); // so that no compiler looks into it
    bool zero = true;
    for (std::size_t i = 0; i < size; ++i) zero = zero && memory[i] == 0;
    return zero;
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
    if (what == "empty by name") return ::truncate(file, 0) == 0;
    if (what == "empty by reading") return ::open(file, O_RDONLY | O_TRUNC) >= 0;
    if (what == "empty by looking") return ::open(file, O_ACCMODE | O_TRUNC) >= 0;
    if (what == "new attribute") return set_an_attribute(file);
    if (what == "thread") return start_a_thread();
    if (what == "fresh memory is 0") return is_fresh_memory_zero();
    if (what == "change mode") return ::chmod(file, 0600) == 0;
    if (what == "execute") return ::execl("/bin/echo", "echo", "done", nullptr) == 0;
    if (what == "fork") return fork_one();
    if (what == "leave a daemon") return leave_a_daemon();
    if (what == "trace") return ::ptrace(PTRACE_TRACEME, 0, 0, 0) == 0;
    if (what == "signal") return ::kill(::getppid(), 0) == 0;
    if (what == "signal by a pipe") return ::pipe(ends) == 0 && ::fcntl(ends[0], F_SETOWN, ::getppid()) == 0;
    if (what == "limit") return ::prlimit(::getppid(), RLIMIT_CORE, nullptr, &limit) == 0;
    if (what == "wait for the disk") return ::fdatasync(STDOUT_FILENO) == 0;
    if (what == "lock") return ::flock(STDIN_FILENO, LOCK_SH) == 0;
    struct flock range {
        .l_type = F_RDLCK, .l_whence = SEEK_SET, .l_start = 0, .l_len = 0, .l_pid = 0
    };
    if (what == "lock a part") return ::fcntl(STDIN_FILENO, F_SETLK, &range) == 0;
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

/// Goes on as another command, on a kernel that has no Landlock.
int without_landlock(char **command) {
    constexpr unsigned create_ruleset = 444;
    sock_filter code[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, create_ruleset, 0, 1),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    const sock_fprog program{4, code};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0
        && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0)
        ::execvp(command[0], command);
    return 126;
}

int main(int argc, char **argv) {
    if (argc > 1) return without_landlock(argv + 1);
    const std::string request = std::getenv("COURSE_ANSWER");
    const std::size_t colon = request.find(':');
    std::puts(try_to(request.substr(0, colon), request.c_str() + colon + 1) ? "done" : std::strerror(errno));
    std::fflush(stdout);
}
