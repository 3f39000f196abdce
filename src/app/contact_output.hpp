// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/contact_options.hpp"
#include "config/units.hpp"

namespace app {

/// Where half-spaces no longer stand for the bodies: a sentence, none if they do.
std::vector<std::string> validity_warnings(const ContactInput& input, const SolvedContact& solved);

/// Throws sys::InputError if anything that is to be printed is not a finite number.
void require_finite(const ContactInput& input, const SolvedContact& solved);

/// A solved contact as JSON, as a table of its nodes, and as text for people.
std::string contact_json(const ContactInput& input, const SolvedContact& solved);
std::string contact_csv(const ContactInput& input, const SolvedContact& solved);
std::string contact_text(const ContactInput& input, const SolvedContact& solved,
                         const config::UnitSystem& units);

}  // namespace app
