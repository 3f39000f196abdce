// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "literate/imports/import_json.hpp"
#include "paper/bounds.hpp"
#include "paper/contact_m.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

double number(const Document& octave, const std::string& key) {
  return octave.value(key).number().value();
}

// Whether the case has the numbers that are typed into the listing, in its units.
bool is_case_of_listing(const Document& octave, const ContactCase& c, const UnitSystem& units,
                        const ContactMInput& input) {
  const auto is_body = [&](const parameters::CylinderCase& body, const std::string& radius) {
    return body.material.young() == number(octave, "EE") &&
           body.material.poisson() == number(octave, "v") &&
           body.radius.curvature() == 1 / number(octave, radius);
  };
  return units.length == octave.value("c").unit() && units.stress == octave.value("EE").unit() &&
         is_body(c.body1, "R1") && is_body(c.body2, "R2") && c.line_load == number(octave, "P") &&
         input.spacing == number(octave, "c") &&
         static_cast<double>(input.n_nodes + 1) == number(octave, "n") &&
         static_cast<double>(input.zero_node) == number(octave, "zero-node");
}

// How far our transcription is from Octave's pressures, over the largest of them.
void compare(Document& document, const Document& octave, const ContactM& ours) {
  double largest = 0, difference = 0, error = 0;
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(ours.zero_node); ++i) {
    const Value& theirs = octave.value("p" + std::to_string(i + 1));
    largest = std::max(largest, std::abs(ours.pressure[i]));
    difference = std::max(difference, std::abs(theirs.number().value() - ours.pressure[i]));
    error = std::max(error, theirs.uncertainty().value().bound);
  }
  document.value("octave.difference",
                 Value(difference / largest, scientific(1).rounded_up()).as_is());
  document.check("octave-repeats-contact-m",
                 {Criterion::at_most("largest difference of a pressure, over the bound of its "
                                     "rounding in Octave",
                                     Value(difference / error, scientific(1).rounded_up()).as_is(),
                                     {LimitKind::method, 1.0, "the bound that the run reports"})},
                 "Contact.m in Octave and its transcription compute the same pressures");
}

}  // namespace

void compute_octave(Document& document, const Case& from) {
  if (!from.printed_data || !from.listings) return;
  const std::filesystem::path& source = from.listings->source;
  Document octave;
  literate::import_json(octave, source / "report/octave/contact_m.json", {.root = source});
  document.attach(octave.attachments());
  document.value("octave.version", Value::text(octave.value("octave-version").printed()));
  const ContactMInput input = as_printed(*from.printed_data);
  const bool is_same = is_case_of_listing(octave, from.contact, from.units, input);
  document.flag("octave.same-case", is_same);
  if (is_same) compare(document, octave, run_contact_m(from.contact, input, {}));
}

}  // namespace paper
