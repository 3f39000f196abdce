// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/given/numbers.hpp"

#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>

namespace assignment {
namespace {

// A quantity is one of from, from + step, …, to.
struct Quantity {
  const char* name;
  const char* unit;
  double OwnNumbers::*number;
  double from, to, step;
  double nominal;
};

constexpr Quantity quantities[] = {
    {"young1", "Pa", &OwnNumbers::young1, 60e9, 240e9, 1e9, 207e9},
    {"poisson1", "", &OwnNumbers::poisson1, 0.20, 0.40, 0.01, 0.30},
    {"young2", "Pa", &OwnNumbers::young2, 60e9, 240e9, 1e9, 207e9},
    {"poisson2", "", &OwnNumbers::poisson2, 0.20, 0.40, 0.01, 0.30},
    {"radius1", "m", &OwnNumbers::radius1, 0.020, 0.040, 0.0002, 0.0254},
    {"radius2", "m", &OwnNumbers::radius2, 0.042, 0.100, 0.0002, 0.0762},
    {"line_load", "N/m", &OwnNumbers::line_load, 200e3, 600e3, 1e3, 438e3},
    {"spacing", "m", &OwnNumbers::spacing, 4e-6, 14e-6, 0.2e-6, 7.6e-6},
    {"nodes", "", &OwnNumbers::nodes, 71, 131, 2, 91},
    {"peak_pressure", "Pa", &OwnNumbers::peak_pressure, 2e6, 20e6, 0.1e6, 6.9e6},
    {"half_width", "m", &OwnNumbers::half_width, 2e-4, 3e-4, 0.02e-4, 2.54e-4},
    {"datum", "m", &OwnNumbers::datum, 0.2, 0.3, 0.002, 0.254},
};

// FNV-1a, followed by splitmix64 to mix the bits (Vigna 2015, public domain).
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
  return hash ^ (hash >> 31);
}

OwnNumbers drawn(const std::string& id, int attempt) {
  OwnNumbers numbers{};
  for (const Quantity& q : quantities) {
    const auto n_values = static_cast<std::uint64_t>(std::lround((q.to - q.from) / q.step)) + 1;
    const std::uint64_t chosen =
        hash_of(id + '\n' + q.name + '\n' + std::to_string(attempt)) % n_values;
    numbers.*q.number = q.from + static_cast<double>(chosen) * q.step;
  }
  return numbers;
}

// (1 − ν²)/E, the contribution of one body to 1/E*.
double compliance(double young, double poisson) {
  return (1 - poisson * poisson) / young;
}

}  // namespace

OwnNumbers nominal_numbers() {
  OwnNumbers numbers{};
  for (const Quantity& q : quantities) numbers.*q.number = q.nominal;
  return numbers;
}

OwnNumbers own_numbers(const std::string& id) {
  std::string plain;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isspace(byte) == 0) plain += static_cast<char>(std::tolower(byte));
  }
  if (plain.empty()) return nominal_numbers();
  for (int attempt = 0;; ++attempt) {
    const OwnNumbers numbers = drawn(plain, attempt);
    if (is_valid(numbers)) return numbers;
  }
}

bool is_valid(const OwnNumbers& n) {
  // Hertz's half-width and peak pressure, Johnson (4.43) and (4.45).
  const double modulus = 1 / (compliance(n.young1, n.poisson1) + compliance(n.young2, n.poisson2));
  const double curvature = 1 / n.radius1 + 1 / n.radius2;
  const double a = std::sqrt(4 * n.line_load / (std::numbers::pi * modulus * curvature));
  const double peak = 2 * n.line_load / (std::numbers::pi * a);
  const double edge = (n.nodes - 1) / 2 * n.spacing;
  return peak <= 0.02 * modulus && a >= 25 * n.spacing && edge >= 1.1 * a && edge <= 1.6 * a;
}

std::string lines_of_numbers(const std::string& id) {
  const OwnNumbers numbers = own_numbers(id);
  std::ostringstream lines;
  for (const Quantity& q : quantities) {
    lines << q.name << ' ' << numbers.*q.number << ' ' << q.unit << '\n';
  }
  return lines.str();
}

}  // namespace assignment
