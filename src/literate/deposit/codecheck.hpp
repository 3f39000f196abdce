// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/deposit/citation.hpp"
#include "literate/deposit/deposited_file.hpp"

namespace literate {

/// The text of codecheck.yml as an author hands it in (CODECHECK configuration file 1.0,
/// https://codecheck.org.uk/spec/config/1.0/), for the folder that holds it: the outputs that a
/// check has to make again, title and authors of the work, its reference and where it comes from.
/// What the codechecker adds (codechecker, report, check_time, certificate) is not there. Throws
/// sys::InputError if there is no output.
std::string codecheck_yml(const Citation& citation, const Manifest& manifest,
                          const std::vector<DepositedFile>& files);

}  // namespace literate
