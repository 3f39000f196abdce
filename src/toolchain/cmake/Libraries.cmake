# SPDX-License-Identifier: GPL-3.0-or-later
# The architecture: each folder of src is a library that may use only the libraries that it links. (`literate` and `assignment`,
# which also build programs, are listed in their own folders.)

# Every other folder may link these libraries. The mechanics link only `errors`.
add_folder_library(errors NO_HEAVY_COMPUTING
  FOLDER system
  HEADERS error.hpp require.hpp
  SOURCES require.cpp
  PRIVATE_LINK fmt::fmt)
add_folder_library(system NO_HEAVY_COMPUTING
  SOURCES decimal.cpp files.cpp text.cpp
  LINK errors
  PRIVATE_LINK fmt::fmt)
add_folder_library(config NO_HEAVY_COMPUTING
  SOURCES table.cpp units.cpp
  LINK system
  PRIVATE_LINK fmt::fmt tomlplusplus::tomlplusplus udunits2::udunits2)

# A number with its error, for code that needs nothing else of numerics.
add_folder_library(estimate NO_HEAVY_COMPUTING
  FOLDER numerics
  HEADERS estimate.hpp
  SOURCES estimate.cpp)
if(NOT HALFSPACE_EVERYTHING)
  return() # The engine needs no more.
endif()

add_folder_library(command_line NO_HEAVY_COMPUTING
  SOURCES exit_codes.cpp
  LINK system
  PRIVATE_LINK fmt::fmt)

# The mechanics
add_folder_library(numerics
  SOURCES fit.cpp fourier.cpp kernel_integrals.cpp piecewise.cpp quadrature.cpp
  LINK errors estimate Eigen3::Eigen GSL::gsl ${FFTW3_LIBRARIES}
  PRIVATE_LINK fmt::fmt)
add_folder_library(elasticity
  SOURCES line_potential.cpp loads.cpp material.cpp stress.cpp surface_quadrature.cpp
  LINK numerics)
add_folder_library(contact
  SOURCES accuracy.cpp contact_search.cpp reference_methods.cpp
  LINK numerics Eigen3::Eigen fmt::fmt)
add_folder_library(line_contact
  SOURCES
    cylinders.cpp element.cpp influence_operator.cpp methods.cpp nested_grids.cpp problem.cpp projected_cg.cpp solution.cpp
  LINK contact elasticity Eigen3::Eigen)
add_folder_library(point_contact
  SOURCES element.cpp hertz.cpp influence_operator.cpp methods.cpp problem.cpp projected_cg.cpp solution.cpp
  LINK contact numerics Eigen3::Eigen
  PRIVATE_LINK fmt::fmt)
add_folder_library(block
  SOURCES analysis.cpp element.cpp factorization.cpp mesh.cpp model.cpp rectangle.cpp solution.cpp
  LINK elasticity Eigen3::Eigen
  PRIVATE_LINK GSL::gsl fmt::fmt)

# The report
add_folder_library(parameters NO_HEAVY_COMPUTING
  SOURCES case.cpp printed_number.cpp
  LINK config block line_contact elasticity
  PRIVATE_LINK system fmt::fmt)
add_folder_library(paper
  SOURCES
    block_section.cpp block_study.cpp contact_m.cpp contact_m_section.cpp conventions.cpp cylinders_section.cpp
    elements_section.cpp error_analysis_section.cpp formulation_section.cpp load.cpp load_fit.cpp paper.cpp
    printed_data.cpp quadrature_section.cpp results_section.cpp run.cpp spheres_section.cpp tangential_section.cpp
  LINK literate parameters point_contact
  PRIVATE_LINK config block line_contact elasticity fmt::fmt Eigen3::Eigen Threads::Threads)

# The program that computes the report. It is separate from `halfspace`, so that building the report does not compile the command
# line of the mechanics.
add_executable(halfspace-report src/paper/main.cpp)
compile_without_optimising(halfspace-report)
target_link_libraries(halfspace-report PRIVATE literate paper parameters fmt::fmt)
set_target_properties(halfspace-report PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
add_sanitizers(halfspace-report)

# The handout contains the files of `judge` as well, so they use no library.
add_folder_library(judge NO_HEAVY_COMPUTING SOURCES judge.cpp student_program.cpp)
