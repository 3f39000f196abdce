// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>

double square(double x) {
  const int file = open("/usr/bin/env", O_RDONLY);
  for (const int command : {F_SETLK, F_SETLKW, F_OFD_SETLK, F_OFD_SETLKW}) {
    struct flock lock {};
    lock.l_type = F_RDLCK;
    lock.l_whence = SEEK_SET;
    lock.l_len = 1;
    if (fcntl(file, command, &lock) == 0) return x * x;
  }
  return 0;
}
