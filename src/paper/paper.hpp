// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/document.hpp"
#include "parameters/case.hpp"

namespace paper {

/// Computes all that the report says about a case and registers it with the document: values,
/// tables, figures, and the checks that must hold. Tables and values about what the paper prints
/// exist only if the case has printed data (flag `printed`).
void compute(literate::Document& document, const parameters::Case& from_file);

}  // namespace paper
