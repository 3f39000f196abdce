// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of the report, one file each; every one registers what its prose refers to. They are
// computed at the same time, each into a document of its own, and so share nothing.
#pragma once

#include "literate/document/document.hpp"
#include "parameters/case.hpp"

namespace paper {

/// What the document was made from and with: commit, case file, compiler, libraries.

/// The parameters, Figs. 1 and 2, and eq. (2)'s gradient for three kinds of load.
void compute_formulation(literate::Document& document, const parameters::Case& from_file);

/// Eq. (2) by quadrature against eq. (3): tables at the case's points, errors over eight decades.
void compute_quadrature(literate::Document& document, const parameters::Case& from_file);

/// Fig. 4, Fig. 5 and Tri_dist.m's output rebuilt.
void compute_results(literate::Document& document, const parameters::Case& from_file);

/// What the paper's error analysis says, and what its own numbers say.
void compute_error_analysis(literate::Document& document, const parameters::Case& from_file);

/// The paper's finite-element run rebuilt, and the load that it carried.
void compute_block(literate::Document& document, const parameters::Case& from_file);

/// Two cylinders by matrix inversion against Hertz.
void compute_cylinders(literate::Document& document, const parameters::Case& from_file);

/// Contact.m as printed, and with its defects mended one at a time.
void compute_contact_m(literate::Document& document, const parameters::Case& from_file);

/// The three kinds of elements, and how fast each converges to Hertz; the graded grid.
void compute_elements(literate::Document& document, const parameters::Case& from_file);

/// The three methods on one contact, and what large grids take.
void compute_methods(literate::Document& document, const parameters::Case& from_file);

/// Other profiles against their closed forms.
void compute_profiles(literate::Document& document, const parameters::Case& from_file);

/// Wavy cylinders: several regions in contact, and the approach instead of the load.
void compute_regions(literate::Document& document, const parameters::Case& from_file);

/// Friction in eq. (2): what leaving it out costs, and partial slip.
void compute_friction(literate::Document& document, const parameters::Case& from_file);

/// The stresses beneath the contact against McEwen's closed form.
void compute_stresses(literate::Document& document, const parameters::Case& from_file);

}  // namespace paper
