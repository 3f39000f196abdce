// SPDX-License-Identifier: GPL-3.0-or-later
// The words that every section of this report is written in: what the engine registers and how it
// prints, numbers with their errors, and the parts of a case.
#pragma once

#include "config/printed_number.hpp"
#include "config/units.hpp"
#include "line_contact/cylinders.hpp"
#include "literate/document/document.hpp"
#include "numerics/estimate_algebra.hpp"
#include "numerics/measured.hpp"
#include "parameters/case.hpp"

namespace paper {

using config::PrintedNumber;
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
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;
using numerics::Measured;
using parameters::BlockCase;
using parameters::ContactCase;
using parameters::HalfSpaceCase;
using parameters::PointContactCase;

}  // namespace paper
