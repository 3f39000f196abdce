# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFOLDER= -DOUTPUT= -P WriteDigest.cmake: a line a file, its SHA-256 and its name; untouched if all are the same.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${FOLDER}" "${FOLDER}/*")
list(SORT files)
set(lines "")
foreach(file IN LISTS files)
  file(SHA256 "${FOLDER}/${file}" hash)
  string(APPEND lines "${hash}  ${file}\n")
endforeach()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${lines}" @ONLY)
