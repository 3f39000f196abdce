# SPDX-License-Identifier: GPL-3.0-or-later
# literate_add_paper(NAME name PROGRAM target|SCRIPT command… DOCUMENT folder MAIN file CASE file
#   [FIGURES folder] [SOURCES file|folder…] [DEPENDS file…] [FAULTS file])
#
# Adds the target `name`, which writes OUTPUT/name.pdf and fails if a claim fails, and targets that stop earlier: `name-program`,
# `name-results`, `name-figures`, and `name-pdf`, which does not look at the claims. A script whose first word ends with .py runs
# with CMake's Python3 and depends on all SOURCES. Each rule is a verb of tools/literate and reads the settings OUTPUT.json. Ninja
# decides what is out of date: a rule keeps the time stamp of an output whose content is the same, and then nothing that depends
# on this output runs.
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
# pyenv and similar tools replace Python by a script, which takes longer to start than most rules run.
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import sys; print(sys.executable)" OUTPUT_VARIABLE literate_PYTHON
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(literate_PYTHON "${literate_PYTHON}" CACHE INTERNAL "Runs tools/literate and scripts that end with .py")
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH literate_ENGINE)
set(literate_ENGINE "${literate_ENGINE}" CACHE INTERNAL "The folder of literate.sty and tools/")

# literate_relative_places(library) makes the places that programs register relative to their project.
function(literate_relative_places library)
  file(RELATIVE_PATH from_build "${CMAKE_BINARY_DIR}" "${CMAKE_SOURCE_DIR}") # as ccache may spell it
  target_compile_options(${library} INTERFACE "$<BUILD_INTERFACE:-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=>"
    "$<BUILD_INTERFACE:-fmacro-prefix-map=${from_build}=>")
endfunction()

function(literate_add_paper)
  # The new policy makes CMake rewrite the depfile with absolute paths, and Ninja cannot read a path with a quote.
  cmake_policy(SET CMP0116 OLD)
  set(one NAME PROGRAM DOCUMENT MAIN CASE FIGURES FAULTS)
  cmake_parse_arguments(PARSE_ARGV 0 paper "" "${one}" "SCRIPT;SOURCES;DEPENDS")
  if(paper_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "literate_add_paper: unknown arguments: ${paper_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT (paper_NAME AND paper_DOCUMENT AND paper_MAIN AND paper_CASE AND (paper_PROGRAM OR paper_SCRIPT)))
    message(FATAL_ERROR "literate_add_paper needs NAME, DOCUMENT, MAIN, CASE, and either PROGRAM or SCRIPT")
  endif()

  set(name "${paper_NAME}")
  set(paper_OUTPUT "${CMAKE_BINARY_DIR}/${name}")
  if(DEFINED ${name}_OUTPUT) # -Dmypaper_OUTPUT=folder
    set(paper_OUTPUT "${${name}_OUTPUT}")
  endif()
  foreach(key IN ITEMS DOCUMENT CASE FIGURES FAULTS OUTPUT SOURCES DEPENDS)
    set(absolute "")
    foreach(path IN LISTS paper_${key})
      cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
      string(REGEX REPLACE "/$" "" path "${path}")
      list(APPEND absolute "${path}")
    endforeach()
    set(paper_${key} "${absolute}")
  endforeach()
  set(output "${paper_OUTPUT}")
  set(generated "${output}/generated")
  set(settings "${output}.json")
  set(literate "${literate_PYTHON}" -S "${literate_ENGINE}/tools/literate")

  # The computation: a program, or a script and literate-results, which reads its file.
  set(results_program "${literate_RESULTS}")
  foreach(program IN ITEMS results_program paper_PROGRAM)
    if(TARGET "${${program}}")
      set(${program} "$<TARGET_FILE:${${program}}>")
    endif()
  endforeach()
  if(paper_SCRIPT)
    set(computes "${results_program}")
    if(paper_SCRIPT MATCHES "^[^;]*\\.py(;|$)")
      list(PREPEND paper_SCRIPT "${literate_PYTHON}")
    endif()
    foreach(word IN LISTS paper_SCRIPT)
      cmake_path(ABSOLUTE_PATH word BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" OUTPUT_VARIABLE file)
      if(EXISTS "${file}" AND NOT IS_DIRECTORY "${file}")
        list(APPEND computes "${file}")
        set(word "${file}")
      endif()
      list(APPEND script "${word}")
    endforeach()
    foreach(path IN LISTS paper_SOURCES) # modules of the script
      if(IS_DIRECTORY "${path}")
        file(GLOB_RECURSE files CONFIGURE_DEPENDS "${path}/*")
        list(FILTER files EXCLUDE REGEX "/__pycache__/")
        list(APPEND computes ${files})
      else()
        list(APPEND computes "${path}")
      endif()
    endforeach()
  else()
    set(computes "${paper_PROGRAM}")
  endif()
  if(paper_FIGURES)
    file(GLOB scripts CONFIGURE_DEPENDS "${paper_FIGURES}/*.gp")
    list(FILTER scripts EXCLUDE REGEX "/style\\.gp$")
    file(GLOB style CONFIGURE_DEPENDS "${paper_FIGURES}/style.gp")
  endif()

  # The settings, the only file of CMake that the tools read: JSON with a text for each key, in which lists have a line for each word.
  set(versions "CMake ${CMAKE_VERSION}" "compiler ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  set(configure "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}")
  if(literate_DIR)
    list(APPEND configure "-Dliterate_DIR=${literate_DIR}")
  endif()
  set(json "{")
  set(separator "")
  foreach(pair IN ITEMS name=name source=CMAKE_SOURCE_DIR document=paper_DOCUMENT main=paper_MAIN case=paper_CASE output=output
      build=CMAKE_BINARY_DIR faults=paper_FAULTS results_program=results_program program=paper_PROGRAM script=script
      sources=paper_SOURCES scripts=scripts configure=configure versions=versions)
    string(REGEX MATCH "^(.*)=(.*)$" pair "${pair}")
    string(REPLACE "\\" "\\\\" words "${${CMAKE_MATCH_2}}")
    string(REPLACE "\"" "\\\"" words "${words}")
    list(JOIN words "\\n" words)
    string(APPEND json "${separator}\n \"${CMAKE_MATCH_1}\": \"${words}\"")
    set(separator ",")
  endforeach()
  file(GENERATE OUTPUT "${settings}" CONTENT "${json}\n}\n")

  # Compute. Ninja must know the outputs that later rules read.
  set(results "${generated}/results.json" "${generated}/values.tex" "${generated}/ledger.tex")
  foreach(file IN LISTS scripts)
    cmake_path(GET file STEM LAST_ONLY figure)
    set(folder "${generated}/figures/${figure}")
    list(APPEND figure_data "${folder}/inputs.txt")
    add_custom_command(OUTPUT "${folder}/${figure}.tex" "${folder}/${figure}.pdf"
      COMMAND ${literate} draw "${settings}" "${figure}"
      DEPENDS "${file}" "${folder}/inputs.txt" ${style}
      COMMENT "draw ${figure}" VERBATIM)
    list(APPEND drawings "${folder}/${figure}.tex" "${folder}/${figure}.pdf")
  endforeach()
  add_custom_command(OUTPUT ${results} ${figure_data}
    COMMAND ${literate} compute "${settings}"
    DEPENDS "${settings}" "${paper_CASE}" ${computes} ${paper_DEPENDS}
    COMMENT "compute ${name}" USES_TERMINAL VERBATIM)

  # The commit. The second output never exists, so this rule always runs. (A SYMBOLIC output would disable restat.)
  add_custom_command(OUTPUT "${generated}/repository.tex" "${output}/always"
    COMMAND ${literate} repository "${settings}"
    COMMENT "look up the commit of ${name}" VERBATIM)

  # Typeset. Ninja removes the outputs of an interrupted rule. The output is a stamp, so that the PDF stays.
  set(stamp "${output}/typeset.stamp")
  add_custom_command(OUTPUT "${stamp}"
    COMMAND ${literate} typeset "${settings}" "${stamp}" "${stamp}.d"
    DEPENDS "${settings}" ${results} ${drawings} "${generated}/repository.tex"
    DEPFILE "${stamp}.d"
    COMMENT "typeset ${name}" VERBATIM)
  add_custom_command(OUTPUT "${output}/verdict.stamp"
    COMMAND ${literate} verdict "${settings}" "${output}/verdict.stamp"
    DEPENDS "${stamp}" "${generated}/results.json"
    COMMENT "check the claims of ${name}" VERBATIM)

  add_custom_target(${name}-program DEPENDS ${computes})
  add_custom_target(${name}-results DEPENDS ${results})
  add_custom_target(${name}-figures DEPENDS ${results} ${drawings})
  add_custom_target(${name}-pdf DEPENDS "${stamp}")
  add_custom_target(${name} ALL DEPENDS "${output}/verdict.stamp")
endfunction()
