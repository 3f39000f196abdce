# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the man page from the program's own help: cmake -DPROGRAM=… -DVERSION=… -DPAGE=… -P man_page.cmake

# help_in_roff(variable [command]): the help as printed. roff interprets a backslash, and a point or
# a quote at the beginning of a line; escape them.
function(help_in_roff variable)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} --help OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "\n([.'])" "\n\\\\&\\1" text "${text}")
  set(${variable} ".nf\n${text}.fi\n" PARENT_SCOPE)
endfunction()

help_in_roff(help)
set(page ".TH HALFSPACE 1 \"\" \"halfspace ${VERSION}\" \"User commands\"
.SH NAME
halfspace \\- Hertz contact and surface displacements of elastic half\\-spaces
.SH SYNOPSIS
.B halfspace
.I COMMAND FLAGS
.SH DESCRIPTION
${help}")
string(REGEX MATCHALL "\n  [a-z][a-z\\\\-]*  " commands "${help}")
foreach(command IN LISTS commands)
  string(REGEX REPLACE "[\n\\\\ ]" "" command "${command}")
  help_in_roff(help ${command})
  string(TOUPPER "${command}" title)
  string(APPEND page ".SH ${title}\n${help}")
endforeach()
file(WRITE "${PAGE}" "${page}.SH EXIT STATUS
0: success. 1: the computation failed. 2: bad input, reported in one line. 3: gnuplot is missing or failed.
")
