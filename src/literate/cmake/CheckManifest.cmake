# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFILE= -DPROJECT= -P CheckManifest.cmake: says what keeps a file from being a manifest of the project.
# The program finds the same, but only once it is built.
cmake_minimum_required(VERSION 3.25)

file(READ "${FILE}" text)
string(JSON type ERROR_VARIABLE error TYPE "${text}")
string(JSON project ERROR_VARIABLE error GET "${text}" project)
string(JSON outputs ERROR_VARIABLE error TYPE "${text}" outputs)
if(NOT type STREQUAL "OBJECT")
  message("${FILE} is no JSON object")
elseif(NOT project STREQUAL PROJECT)
  message("${FILE} is not a manifest of ${PROJECT}")
elseif(NOT outputs STREQUAL "OBJECT")
  message("${FILE} is not a manifest")
endif()
