// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/assignment.hpp"

#include <fmt/core.h>

#include <charconv>

#include "course/assignment/student.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace {

constexpr int n_attempts = 1000;

// A number below n: the remainder of one of 2^64 equally likely numbers. With n ≤ 1e9 no
// remainder is likelier than another by more than 1e-10 of its probability.
std::uint64_t drawn(const std::string& text, std::uint64_t n) {
  const std::string hexadecimal = sys::sha256_of_text(text).substr(0, 16);
  std::uint64_t number = 0;
  std::from_chars(hexadecimal.data(), hexadecimal.data() + hexadecimal.size(), number, 16);
  return number % n;
}

}  // namespace

Variant nominal_variant(const Assignment& assignment) {
  Variant variant;
  for (const Quantity& quantity : assignment.quantities) {
    variant.quantities[quantity.name] = quantity.nominal;
  }
  return variant;
}

Variant variant_of(const Assignment& assignment, const std::string& student,
                   const std::string& seed, const std::function<bool(const Variant&)>& is_valid) {
  require_student_id(student);
  if (seed.empty()) throw sys::SourceError("the seed of a variant is empty");
  // Neither id nor name holds a line end, so the texts of any two draws differ.
  Variant variant{.student = student, .quantities = {}};
  for (int attempt = 0; attempt < n_attempts; ++attempt) {
    for (const Quantity& quantity : assignment.quantities) {
      const std::string text = fmt::format("{}\n{}\n{}\n{}", student, quantity.name, attempt, seed);
      variant.quantities[quantity.name] = on_grid(quantity, drawn(text, n_values(quantity)));
    }
    if (is_valid(variant)) return variant;
  }
  throw sys::SourceError(
      fmt::format("student \"{}\": none of {} variants drawn is valid; the quantities' ranges in "
                  "{} are too wide",
                  student, n_attempts, (assignment.folder / "assignment.toml").string()));
}

}  // namespace course
