/* SPDX-License-Identifier: GPL-3.0-or-later
 * Preloaded: has the n-th write of one program to a regular file fail. FAULT_PROGRAM is the program's name and FAULT_STAGE
 * its first argument; FAULT_AT is n; FAULT_KIND is ENOSPC or EIO, by which this write and all after it fail, or short, by
 * which each writes one byte. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static int is_meant(void) {
  static int answer = -1;
  if (answer >= 0) return answer;
  const char* program = getenv("FAULT_PROGRAM");
  const char* stage = getenv("FAULT_STAGE");
  char words[4096] = {0};
  answer = 0;
  if (program == NULL || stage == NULL) return answer;
  const int file = open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
  if (file < 0) return answer;
  const ssize_t n = read(file, words, sizeof words - 1);
  close(file);
  if (n <= 0) return answer;
  const char* slash = strrchr(words, '/');
  const char* name = slash == NULL ? words : slash + 1;
  const char* first = words + strlen(words) + 1;
  answer = strcmp(name, program) == 0 && strcmp(first, stage) == 0;
  return answer;
}

/* 0: write; -1: fail with errno; 1: write one byte. */
static int fault(int descriptor) {
  static int n_written = 0;
  struct stat status;
  if (!is_meant() || fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
  const char* at = getenv("FAULT_AT");
  const char* kind = getenv("FAULT_KIND");
  if (at == NULL || kind == NULL || __atomic_add_fetch(&n_written, 1, __ATOMIC_SEQ_CST) < atoi(at)) return 0;
  if (strcmp(kind, "short") == 0) return 1;
  errno = strcmp(kind, "EIO") == 0 ? EIO : ENOSPC;
  return -1;
}

ssize_t write(int descriptor, const void* bytes, size_t n) {
  static ssize_t (*real)(int, const void*, size_t) = NULL;
  if (real == NULL) real = (ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  const int what = fault(descriptor);
  if (what < 0) return -1;
  return real(descriptor, bytes, what > 0 && n > 1 ? 1 : n);
}

ssize_t writev(int descriptor, const struct iovec* parts, int n_parts) {
  static ssize_t (*real)(int, const struct iovec*, int) = NULL;
  if (real == NULL) real = (ssize_t(*)(int, const struct iovec*, int))dlsym(RTLD_NEXT, "writev");
  const int what = fault(descriptor);
  if (what < 0) return -1;
  if (what > 0 && n_parts > 0 && parts[0].iov_len > 0) return write(descriptor, parts[0].iov_base, 1);
  return real(descriptor, parts, n_parts);
}
