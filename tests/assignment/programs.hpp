// SPDX-License-Identifier: GPL-3.0-or-later
// Students' programs for tests: the reference answers the tasks, correctly or with a planted
// mistake.
#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>

#include "assignment/hidden/reference.hpp"
#include "exercise_list.hpp"

namespace programs {

using assignment::Surface;
using judge::Numbers;
using judge::Program;

inline Numbers from(const Numbers& in, std::size_t first) {
  return {in.begin() + static_cast<std::ptrdiff_t>(first), in.end()};
}

/// The correct program, which uses the reference.
inline Numbers right(const std::string& task, const Numbers& in) {
  Numbers out;
  if (task == "gradient") {
    return assignment::slopes_in_closed_form({in[0], in[1], in[2], in[3], 0}, from(in, 4));
  }
  if (task == "gradient_by_quadrature") {
    const Surface surface{in[0], in[1], in[3], in[4], 10 * in[4], in[2]};
    for (const auto& slope : assignment::slopes(surface, from(in, 5))) {
      out.insert(out.end(), {slope.value, slope.abs_error});
    }
    return out;
  }
  if (task == "displacement") {
    return assignment::displacements({in[0], in[1], in[3], in[4], in[5], in[2]}, from(in, 6));
  }
  if (task == "influence") {
    for (const double k : from(in, 3)) {
      out.push_back(assignment::influence_coefficient(in[0], in[1], in[2], k));
    }
    return out;
  }
  if (task == "contact") {
    const auto contact = assignment::contact_of(
        {in[0], in[1], in[2], in[3], in[4], in[5], in[6], in[7], static_cast<int>(in[8]), in[9]});
    return judge::joined({contact.approach, contact.half_width}, contact.pressure);
  }
  throw std::logic_error("unknown task " + task);
}

/// The correct program, except that `spoil` changes the answer of one task.
inline Program spoiled(const std::string& task, const std::function<void(Numbers&)>& spoil) {
  return [=](const std::string& asked, const Numbers& in) {
    Numbers out = right(asked, in);
    if (asked == task) spoil(out);
    return out;
  };
}

/// The correct program, except that `mislead` changes the inputs of one task.
inline Program misled(const std::string& task, const std::function<void(Numbers&)>& mislead) {
  return [=](const std::string& asked, Numbers in) {
    if (asked == task) mislead(in);
    return right(asked, in);
  };
}

/// The correct program, except that the answers of one task are multiplied by a factor.
inline Program scaled(const std::string& task, double factor) {
  return spoiled(task, [=](Numbers& out) { out = judge::times(factor, out); });
}

/// The correct program, except that the quadrature reports what `report` returns for its error and
/// the greatest slope.
inline Program reporting(const std::function<double(double error, double greatest)>& report) {
  return spoiled("gradient_by_quadrature", [=](Numbers& out) {
    double greatest = 0;
    for (std::size_t i = 0; i < out.size(); i += 2) {
      greatest = std::max(greatest, std::abs(out[i]));
    }
    for (std::size_t i = 1; i < out.size(); i += 2) out[i] = report(out[i], greatest);
  });
}

enum class Kind { public_checks, hidden_checks };

inline judge::Checks all(Kind kind) {
  judge::Checks checks;
  for (const auto& exercise : assignment::exercises()) {
    const judge::Checks& some =
        kind == Kind::public_checks ? exercise.public_checks : exercise.hidden_checks;
    checks.insert(checks.end(), some.begin(), some.end());
  }
  return checks;
}

/// The check with this id.
inline judge::Check check_of(const std::string& id) {
  for (const Kind kind : {Kind::public_checks, Kind::hidden_checks}) {
    for (const judge::Check& check : all(kind)) {
      if (check.id == id) return check;
    }
  }
  throw std::out_of_range(id);
}

/// The outcome of a check. As in the judge, a check that throws NoAnswer scores nothing.
inline judge::Outcome outcome_of(const judge::Check& check, const Program& program,
                                 const std::string& id = "") {
  try {
    return check.outcome(program, id);
  } catch (const judge::NoAnswer& e) {
    return {0, e.what()};
  }
}

inline double share(const std::string& check, const Program& program, const std::string& id = "") {
  return outcome_of(check_of(check), program, id).share;
}

/// The checks that a program does not pass completely. Each of them must have a message.
inline std::set<std::string> failed(Kind kind, const Program& program) {
  std::set<std::string> found;
  for (const judge::Check& check : all(kind)) {
    const judge::Outcome outcome = outcome_of(check, program);
    BOOST_TEST((outcome.share == 1) == outcome.message.empty(), check.id);
    if (outcome.share < 1) found.insert(check.id);
  }
  return found;
}

/// The ids of three students, and the empty one of the nominal numbers.
constexpr const char* ids[] = {"", "ada", "emmy", "sofja"};

/// Requires that the correct program passes all checks of this kind with the numbers of all ids.
inline void require_right(Kind kind) {
  for (const char* id : ids) {
    for (const judge::Check& check : all(kind)) {
      const judge::Outcome outcome = outcome_of(check, right, id);
      BOOST_TEST(outcome.share == 1, check.id << ": " << outcome.message);
    }
  }
}

}  // namespace programs
