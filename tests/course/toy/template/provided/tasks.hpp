#pragma once

#include <string>
#include <vector>

/// "root": the roots of the inputs; "mean": their mean, one number.
std::vector<double> run_task(const std::string& task, const std::vector<double>& inputs);
