// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>

#include <cerrno>
#include <csignal>
#include <memory>

#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace {

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

/// That an argument of a call, or these bits of it, are the value. The macros of libseccomp for the
/// same are C and no C++.
scmp_arg_cmp argument_is(unsigned argument, int value) {
  return {argument, SCMP_CMP_EQ, static_cast<scmp_datum_t>(value), 0};
}
scmp_arg_cmp argument_is(unsigned argument, int value, int bits) {
  return {argument, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(bits),
          static_cast<scmp_datum_t>(value)};
}

/// Which libseccomp before 2.5.5 does not know; it has one number on all machines.
constexpr int cachestat = 451;

void add_rules(scmp_filter_ctx filter) {
  for (const int call :
       {SCMP_SYS(shmget),
        SCMP_SYS(semget),
        SCMP_SYS(msgget),
        SCMP_SYS(mq_open),
        SCMP_SYS(add_key),
        SCMP_SYS(keyctl),
        SCMP_SYS(request_key),
        SCMP_SYS(ptrace),
        SCMP_SYS(process_vm_readv),
        SCMP_SYS(process_vm_writev),
        SCMP_SYS(unshare),
        SCMP_SYS(setns),
        SCMP_SYS(mount),
        SCMP_SYS(umount2),
        SCMP_SYS(pivot_root),
        SCMP_SYS(bpf),
        SCMP_SYS(perf_event_open),
        SCMP_SYS(io_uring_setup),
        SCMP_SYS(userfaultfd),
        SCMP_SYS(socket),
        SCMP_SYS(socketpair),     // what waits in one is in memory that nothing counts
        SCMP_SYS(vmsplice),       // as well
        SCMP_SYS(flock),          // one on a file that all see tells others something
        SCMP_SYS(inotify_init),   // whether others read a file
        SCMP_SYS(inotify_init1),  // as well
        SCMP_SYS(fanotify_init),
        SCMP_SYS(memfd_create),
        SCMP_SYS(memfd_secret),
        SCMP_SYS(io_setup),
        SCMP_SYS(preadv2),  // tells whether somebody read a file before
        SCMP_SYS(mincore),  // as well
        cachestat,          // as well
        SCMP_SYS(setxattr),
        SCMP_SYS(lsetxattr),
        SCMP_SYS(fsetxattr),
        SCMP_SYS(setpriority),  // who lets all others go first holds its place for ever
        SCMP_SYS(sched_setattr),
        SCMP_SYS(sched_setparam),
        SCMP_SYS(sched_setscheduler)}) {
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0);
  }
  // No mapping that is shared: what it holds stays in memory, where nothing counts it, even if only
  // one page of it is still mapped. Libraries read a file where they cannot map it.
  constexpr int kind_of_mapping = 0xf;
  for (const int kind : {MAP_SHARED, MAP_SHARED_VALIDATE}) {
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(mmap), 1,
                     argument_is(3, kind, kind_of_mapping));
  }
  // The kernel adds the time of no child to its parent's whose end that ignores.
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(rt_sigaction), 1,
                   argument_is(0, SIGCHLD));
  // No lock, lease or notice of a file that all jobs see, and no hint that stays with it: another
  // one would hear of it.
  for (const int command : {F_SETLK, F_SETLKW, F_OFD_SETLK, F_OFD_SETLKW, F_SETLEASE, F_NOTIFY,
                            F_SET_RW_HINT, F_SET_FILE_RW_HINT}) {
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(fcntl), 1, argument_is(1, command));
  }
  // No new user namespace. A filter cannot see the flags of clone3, so clone3 is refused as a
  // whole; libraries then use clone.
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                   argument_is(0, CLONE_NEWUSER, CLONE_NEWUSER));
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
}

}  // namespace

void write_syscall_filter(const std::filesystem::path& file) {
  const Filter filter(seccomp_init(SCMP_ACT_ALLOW), &seccomp_release);
  const sys::Descriptor descriptor(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
  if (descriptor.number() < 0 || !filter)
    throw sys::ToolError("cannot make a filter of system calls");
  add_rules(filter.get());
  if (seccomp_export_bpf(filter.get(), descriptor.number()) != 0) {
    throw sys::ToolError("cannot write the filter of system calls");
  }
}

}  // namespace course
