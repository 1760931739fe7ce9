#include "judge/runner/sandbox.hpp"

#include "base/kernel.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace course {
namespace {

/// Every descriptor from this one on, when the program starts.
void close_at_start(int first) {
#ifdef CLOSE_RANGE_CLOEXEC
    if (::close_range(static_cast<unsigned>(first), ~0u, CLOSE_RANGE_CLOEXEC) == 0) return;
#endif
    for (int other = first; other < 1024; ++other) ::fcntl(other, F_SETFD, FD_CLOEXEC);
}

} // namespace

std::string warning_of_this_kernel() {
    const Protection here = protection_of_this_kernel();
    if (sanitized || (here.files && here.calls)) return "";
    return "This kernel lacks " + std::string{here.files ? "" : "Landlock"} + (here.files || here.calls ? "" : " and ")
           + (here.calls ? "" : "seccomp")
           + ", so code isn't shut in: judge only what you trust. ./course doctor says what it could do.";
}

std::vector<std::filesystem::path> system_paths() {
    return {"/bin",         "/lib",           "/lib64",         "/usr/bin",         "/usr/lib",    "/usr/lib32",
            "/usr/libexec", "/usr/local/bin", "/usr/local/lib", "/etc/ld.so.cache", "/dev/urandom"};
}
} // namespace course

#ifdef __linux__
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <link.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <linux/securebits.h>
#include <string>
#include <sys/prctl.h>
#include <sys/syscall.h>

namespace course {
namespace {

// ---- Landlock. Its calls have these numbers on every architecture; older headers do not have all of them.

constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;

struct Ruleset {
    std::uint64_t files, net, scoped;
};
struct [[gnu::packed]] PathRule {
    std::uint64_t allowed;
    std::int32_t file;
};
constexpr std::uint64_t execute = 1, write_a_file = 2, read_file = 4, read_folder = 8, truncate = 1u << 14;

/// The libraries that we are linked with ourselves.
const std::vector<std::filesystem::path> &libraries() {
    static const std::vector<std::filesystem::path> all = [] {
        std::vector<std::filesystem::path> paths;
        ::dl_iterate_phdr(
            [](dl_phdr_info *info, std::size_t, void *into) {
                if (info->dlpi_name != nullptr && info->dlpi_name[0] == '/')
                    static_cast<std::vector<std::filesystem::path> *>(into)->emplace_back(info->dlpi_name);
                return 0;
            },
            &paths);
        return paths;
    }();
    return all;
}

/// A rule for a file must not speak of what can be done in folders.
void allow(int rules, const std::filesystem::path &place, std::uint64_t what, std::uint64_t known) {
    constexpr std::uint64_t of_files = execute | write_a_file | read_file | truncate;
    const UniqueFd file = ::open(place.c_str(), O_PATH | O_CLOEXEC);
    PathRule rule{what & known, file};
    if (file < 0 || ::syscall(add_rule, rules, 1, &rule, 0) == 0) return;
    rule.allowed &= of_files;
    ::syscall(add_rule, rules, 1, &rule, 0);
}

UniqueFd make_rules(const AllowedPaths &places) {
    const int version = landlock_version();
    if (version == 0) return -1;
    const std::uint64_t all = (1u << (version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13)) - 1;
    const Ruleset set{all, version >= 4 ? 3u : 0u, version >= 6 ? 3u : 0u};
    const UniqueFd rules = static_cast<int>(::syscall(create_ruleset, &set, sizeof set, 0));
    if (rules < 0)
        throw EnvironmentError{"cannot shut the student's process in (" + std::string{std::strerror(errno)} + ")"};
    for (const auto &place : places.readable) allow(rules, place, execute | read_file | read_folder, all);
    for (const auto &place : places.writable) allow(rules, place, ~execute, all);
    return ::fcntl(rules, F_DUPFD_CLOEXEC, 10); // the subject's own take the low numbers
}

// ---- capabilities, which root has: by the kernel's own calls, since the C library has none for them

/// Leaves none to the program that is started, and to us the two that find it: a folder on the way may be another user's.
/// What this process may not take away from itself, because it is not root's, it does not have either.
void drop_privileges() {
    // that the user is root gives a program nothing
    ::prctl(PR_SET_SECUREBITS, static_cast<unsigned long>(SECBIT_NOROOT | SECBIT_NOROOT_LOCKED), 0, 0, 0);
    for (unsigned long one = 0; ::prctl(PR_CAPBSET_READ, one, 0, 0, 0) >= 0; ++one)
        ::prctl(PR_CAPBSET_DROP, one, 0, 0, 0);
    ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3] = {};
    if (::syscall(SYS_capget, &header, sets) != 0) return;
    constexpr std::uint32_t finding = 1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH;
    const std::uint32_t left = sets[0].permitted & finding;
    sets[0] = {left, left, 0};
    sets[1] = {};
    ::syscall(SYS_capset, &header, sets);
}

// ---- seccomp

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0; // not tried there
#endif

/// The table of calls is closed up to here; what newer kernels can do comes behind it. Of that, a program gets these few.
constexpr long last_of_old = SYS_rseq;
constexpr long allowed_of_new[] = {436 /* close_range */, 439 /* faccessat2 */,       441 /* epoll_pwait2 */,
                                   449 /* futex_waitv */, 453 /* map_shadow_stack */, 454 /* futex_wake */,
                                   455 /* futex_wait */,  456 /* futex_requeue */,    462 /* mseal */};

/// Older calls that no exercise needs. Those that change a file's mode, owner or date are here since Landlock has no rule
/// for them, truncate since its first versions have none, ioctl since it types on terminals, and what root may do to the
/// machine in case the course is run by root.
constexpr long refused[] = {
    // files; newer architectures have only the calls that end in "at"
    SYS_fchmod, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_utimensat, SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr,
    SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr, SYS_truncate, SYS_inotify_init1, SYS_ioctl, SYS_flock,
    // waits for a disk, which the machine would be blamed for
    SYS_sync, SYS_syncfs, SYS_fsync, SYS_fdatasync, SYS_sync_file_range, SYS_fadvise64, SYS_readahead,
#ifdef SYS_fork
    SYS_chmod, SYS_chown, SYS_lchown, SYS_utime, SYS_utimes, SYS_futimesat, SYS_inotify_init,
    // processes; the newer architectures have only clone
    SYS_fork, SYS_vfork,
#endif
    SYS_setsid, SYS_setpgid, SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kcmp, SYS_tkill,
    SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_migrate_pages, SYS_move_pages, SYS_setpriority,
    SYS_sched_setscheduler, SYS_sched_setparam, SYS_sched_setattr, SYS_sched_setaffinity, SYS_ioprio_set,
    // what stays
    SYS_shmget, SYS_shmat, SYS_shmctl, SYS_msgget, SYS_msgsnd, SYS_msgrcv, SYS_msgctl, SYS_semget, SYS_semop,
    SYS_semtimedop, SYS_semctl, SYS_mq_open, SYS_mq_unlink, SYS_io_setup, SYS_memfd_create, SYS_add_key,
    SYS_request_key, SYS_keyctl,
    // the rest of the world
    SYS_socket, SYS_socketpair, SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_unshare, SYS_setns, SYS_mount,
    SYS_umount2, SYS_chroot, SYS_pivot_root, SYS_open_by_handle_at, SYS_fanotify_init,
// the machine
#ifdef SYS_kexec_file_load
    SYS_kexec_file_load,
#endif
#ifdef SYS_iopl
    SYS_iopl, SYS_ioperm,
#endif
    SYS_reboot, SYS_sethostname, SYS_setdomainname, SYS_settimeofday, SYS_clock_settime, SYS_clock_adjtime,
    SYS_adjtimex, SYS_swapon, SYS_swapoff, SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_kexec_load,
    SYS_quotactl, SYS_vhangup, SYS_acct, SYS_syslog};

class Filter {
  public:
    Filter() {
        add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
        add(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
        refuse(EPERM);
        load_call();
        constexpr unsigned count = std::size(allowed_of_new);
        add(BPF_JMP | BPF_JGT | BPF_K, last_of_old, 0, 2 * count + 1); // unsigned: also x32's numbers for old calls
        for (const long call : allowed_of_new) {
            if_call(call, 1);
            add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
        }
        refuse(ENOSYS); // as an older kernel says: the C library then takes an older call
    }
    void refuse(long call, int error) {
        if_call(call, 1);
        refuse(error);
    }
    /// Refuses a call if this argument is one of these.
    template <class... Values> void refuse_if(long call, unsigned argument, Values... values) {
        if_call(call, 1 + 2 * sizeof...(values) + 1);
        load_argument(argument);
        ((add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(values), 0, 1), refuse(EPERM)), ...);
        load_call();
    }
    /// Refuses to empty files that are opened to be read, or not even that: Landlock's first versions don't see it.
    void refuse_to_empty(long call, unsigned argument) {
        if_call(call, 7);
        load_argument(argument);
        add(BPF_ALU | BPF_AND | BPF_K, O_TRUNC | O_ACCMODE);
        for (const int how : {O_RDONLY, O_ACCMODE}) {
            add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(O_TRUNC | how), 0, 1);
            refuse(EPERM);
        }
        load_call();
    }
    /// Allows a call only if this argument is one of these.
    template <class... Values> void allow_if(long call, unsigned argument, Values... values) {
        unsigned left = sizeof...(values);
        if_call(call, left + 3);
        load_argument(argument);
        (add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(values), left--, 0), ...);
        refuse(EPERM);
        load_call();
    }
    bool install() {
        add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
        const sock_fprog program{size, code.data()};
        return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
    }

  private:
    void add(unsigned what, std::uint32_t value, unsigned if_true = 0, unsigned if_false = 0) {
        code[size++] = {static_cast<std::uint16_t>(what), static_cast<std::uint8_t>(if_true),
                        static_cast<std::uint8_t>(if_false), value};
    }
    void load_call() { add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)); }
    void load_argument(unsigned n) {
        add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * n));
    }
    void if_call(long call, unsigned skip_otherwise) {
        add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, skip_otherwise);
    }
    void refuse(int error) { add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)); }

    std::array<sock_filter, 2 * std::size(refused) + 128> code{}; // no memory is asked for between fork and exec
    unsigned short size = 0;
};

bool refuse_calls() {
    const auto me = static_cast<std::uint32_t>(::getpid());
    Filter filter;
    for (const long call : refused) filter.refuse(call, EPERM);
    filter.refuse(SYS_clone, EAGAIN); // no thread either, of which no limit counts the memory: std::async does without
    filter.allow_if(SYS_kill, 0, me);
    filter.allow_if(SYS_tgkill, 0, me);
    filter.allow_if(SYS_prlimit64, 0, 0, me);
#ifdef SYS_open
    filter.refuse_to_empty(SYS_open, 1);
#endif
    filter.refuse_to_empty(SYS_openat, 2);
    filter.refuse_if(SYS_prctl, 0, PR_SET_PDEATHSIG);                // we die, and it lives
    filter.refuse_if(SYS_fcntl, 1, F_SETOWN, F_SETOWN_EX, F_SETSIG); // a pipe that sends signals
    filter.refuse_if(SYS_fcntl, 1, F_SETLK, F_SETLKW, F_OFD_SETLK, F_OFD_SETLKW, F_SETLEASE, F_NOTIFY); // and files
    return filter.install();
}

/// Whether filters are known and allowed here: the kernel then looks for the one that we have not given it.
bool knows_filters() {
    static const bool once =
        architecture != 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr, 0, 0) != 0 && errno == EFAULT;
    return once;
}

} // namespace

Protection protection_of_this_kernel() { return {!sanitized && landlock_version() > 0, !sanitized && knows_filters()}; }

int landlock_version() { return std::max(0, static_cast<int>(::syscall(create_ruleset, nullptr, 0, 1))); }

AllowedPaths allowed_paths(const std::filesystem::path &program) {
    AllowedPaths places{{program, "/etc/ld.so.cache", "/dev/urandom"}, {}};
    places.readable.insert(places.readable.end(), libraries().begin(), libraries().end());
    return places;
}

Sandbox::Sandbox(const AllowedPaths &places, Protection protection)
    : rules{protection.files && !sanitized ? make_rules(places) : UniqueFd{}},
      calls{protection.calls && !sanitized && knows_filters()},
      privileges{protection.privileges && !sanitized},
      descriptors{protection.descriptors} {}

bool Sandbox::shut(int last) const {
    if (descriptors) close_at_start(last + 1);
    if (privileges) drop_privileges();
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0
           && (rules < 0 || ::syscall(restrict_self, static_cast<int>(rules), 0) == 0) && (!calls || refuse_calls());
}

} // namespace course

#else

namespace course {

Protection protection_of_this_kernel() { return {false, false}; }
int landlock_version() { return 0; }
AllowedPaths allowed_paths(const std::filesystem::path &) { return {}; }
Sandbox::Sandbox(const AllowedPaths &, Protection protection) : descriptors{protection.descriptors} {}
bool Sandbox::shut(int last) const {
    if (descriptors) close_at_start(last + 1);
    return true;
}

} // namespace course

#endif
