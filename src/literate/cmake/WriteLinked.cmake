# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFILE= -DOUTPUT= -DOBJECTS= -DCOMPILED= -P WriteLinked.cmake: writes the SHA-256 of a program that was linked just now, and
# of all that the objects in a list were compiled from, as their records have it. What is no program at all is removed, so that the
# next build links it again.
cmake_minimum_required(VERSION 3.25)

file(READ "${FILE}" magic LIMIT 4 HEX)
if(NOT magic STREQUAL "7f454c46")
  file(REMOVE "${FILE}")
  message(FATAL_ERROR "${FILE} was no program and is removed; the next build links it again")
endif()
file(STRINGS "${OBJECTS}" objects)
set(lines "")
foreach(object IN LISTS objects)
  if(EXISTS "${object}.sha256")
    file(STRINGS "${object}.sha256" read)
    list(APPEND lines ${read})
  endif()
endforeach()
list(FILTER lines INCLUDE REGEX "^[0-9a-f]+  /") # a record may be damaged
list(REMOVE_DUPLICATES lines)
list(TRANSFORM lines APPEND "\n")
list(JOIN lines "" lines)
file(WRITE "${COMPILED}" "${lines}")
file(SHA256 "${FILE}" hash)
file(WRITE "${OUTPUT}" "${hash}  ${FILE}\n")
