// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <cstring>

// What would be right, if this were compiled.
int main(int, char** arguments) {
  const bool is_sum = std::strcmp(arguments[1], "sum") == 0;
  double sum = 0;
  for (double x = 0; std::scanf("%lf", &x) == 1; sum += x) {
    if (!is_sum) std::printf("%.17g\n", x * x);
  }
  if (is_sum) std::printf("%.17g\n", sum);
}
