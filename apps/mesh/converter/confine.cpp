#include "converter/confine.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <csignal>
#include <vector>
#endif

namespace armlet::mesh {
namespace {

bool limit(int what, rlim_t most) {
  const rlimit both{most, most};
  return setrlimit(static_cast<__rlimit_resource_t>(what), &both) == 0;
}

#ifdef __linux__

// The system calls for computing, memory and two open files. All others fail with EPERM.
constexpr long kAllowed[] = {
    SYS_read,         SYS_write,     SYS_readv,          SYS_writev,        SYS_recvfrom,
    SYS_sendto,       SYS_close,     SYS_fstat,          SYS_lseek,         SYS_mmap,
    SYS_munmap,       SYS_mremap,    SYS_mprotect,       SYS_madvise,       SYS_brk,
    SYS_futex,        SYS_exit,      SYS_exit_group,     SYS_rt_sigaction,  SYS_rt_sigprocmask,
    SYS_rt_sigreturn, SYS_getpid,    SYS_gettid,         SYS_clock_gettime, SYS_getrandom,
    SYS_sched_yield,  SYS_getrusage, SYS_clock_nanosleep};

#if defined(__x86_64__)
constexpr unsigned kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kMachine = AUDIT_ARCH_AARCH64;
#elif defined(__riscv) && __riscv_xlen == 64
constexpr unsigned kMachine = AUDIT_ARCH_RISCV64;
#else
constexpr unsigned kMachine = 0;
#endif

// source  Linux kernel, Documentation/userspace-api/seccomp_filter.rst.
bool filter_calls() {
  if (kMachine == 0) return true;  // only the limits
  std::vector<sock_filter> rules;
  const auto load = [&](unsigned at) { rules.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, at)); };
  const auto leave = [&](unsigned with) { rules.push_back(BPF_STMT(BPF_RET | BPF_K, with)); };
  load(offsetof(seccomp_data, arch));
  rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0));
  leave(SECCOMP_RET_KILL_PROCESS);
  load(offsetof(seccomp_data, nr));
  for (const long each : kAllowed) {
    rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(each), 0, 1));
    leave(SECCOMP_RET_ALLOW);
  }
  // abort() signals the process itself; it may signal no other one. Arguments have 64 bits, of
  // which the kernel uses the lower half for a process; all machines above are little-endian.
  rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(SYS_tgkill), 0, 3));
  load(offsetof(seccomp_data, args));
  rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(getpid()), 0, 1));
  leave(SECCOMP_RET_ALLOW);
  leave(SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

#else
bool filter_calls() { return true; }
#endif

}  // namespace

std::string confine(std::size_t memory, int cpu) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with the command that started it
#ifdef SYS_close_range
  syscall(SYS_close_range, 3U, ~0U, 0U);
#endif
#endif
#ifndef __SANITIZE_ADDRESS__
  if (!limit(RLIMIT_AS, memory)) return std::strerror(errno);
#endif
  const auto seconds = static_cast<rlim_t>(cpu);
  const rlimit computing{seconds, seconds + 5};  // a signal, then the kernel kills the process
  if (setrlimit(RLIMIT_CPU, &computing) != 0) return std::strerror(errno);
  // No file beyond the three that are open can be opened.
  if (!limit(RLIMIT_NOFILE, 3) || !limit(RLIMIT_FSIZE, 0) || !limit(RLIMIT_CORE, 0))
    return std::strerror(errno);
#ifndef __SANITIZE_ADDRESS__
  if (!filter_calls()) return std::strerror(errno);
#endif
  return {};
}

}  // namespace armlet::mesh
