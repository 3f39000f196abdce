// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "literate/main/main.hpp"

struct Sample {
  std::string label;
  long counts;
  double half_life;  // s
  double distance;   // m
  double printed;    // the share that is left after one mean life, as a table prints it
};

Sample read_sample(const std::filesystem::path& file);

/// Registers all that the prose names.
void register_all(literate::Document& document, const literate::Inputs& inputs,
                  const Sample& sample);
