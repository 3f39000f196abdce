# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFILE= -DOUTPUT= -P WriteLinked.cmake: writes the SHA-256 of a program that was linked just now. What is no program
# at all is removed, so that the next build links it again.
cmake_minimum_required(VERSION 3.25)

file(READ "${FILE}" magic LIMIT 4 HEX)
if(NOT magic STREQUAL "7f454c46")
  file(REMOVE "${FILE}")
  message(FATAL_ERROR "${FILE} was no program and is removed; the next build links it again")
endif()
file(SHA256 "${FILE}" hash)
file(WRITE "${OUTPUT}" "${hash}  ${FILE}\n")
