// SPDX-License-Identifier: GPL-3.0-or-later
// The names that every section of this report uses: those of the engine, of numbers with errors,
// and of the parts of a case.
#pragma once

#include <string>
#include <utility>

#include "config/units.hpp"
#include "line_contact/cylinders.hpp"
#include "literate/document/document.hpp"
#include "numerics/estimate.hpp"
#include "parameters/case.hpp"
#include "parameters/printed_number.hpp"

namespace paper {

using config::UnitSystem;
using line_contact::Hertz;
using literate::Cell;
using literate::Column;
using literate::Criterion;
using literate::Document;
using literate::exact;
using literate::Figure;
using literate::FigureData;
using literate::fixed;
using literate::integer;
using literate::Limit;
using literate::LimitKind;
using literate::Number;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;
using parameters::BlockCase;
using parameters::ContactCase;
using parameters::HalfSpaceCase;
using parameters::PointContactCase;
using parameters::PrintedNumber;

/// A number with a standard uncertainty and no bound.
inline Number number_with(double value, double standard) {
  return {value, 0, standard};
}

}  // namespace paper
