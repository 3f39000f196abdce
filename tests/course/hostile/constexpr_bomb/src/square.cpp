// SPDX-License-Identifier: GPL-3.0-or-later
constexpr unsigned long long steps(unsigned long long n) {
  unsigned long long sum = 0;
  for (unsigned long long i = 0; i < n; ++i) sum += i % 7;
  return sum;
}

template <int n>
constexpr unsigned long long all = steps(200000 + n) + all<n - 1>;
template <>
constexpr unsigned long long all<0> = 0;

double square(double x) {
  return x * all<800>;
}
