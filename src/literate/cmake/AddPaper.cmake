# SPDX-License-Identifier: GPL-3.0-or-later
# literate_add_paper(NAME rod PROGRAM rod_program DOCUMENT paper MAIN rod.tex CASE case.toml SOURCES src
#   [FIGURES figures] [DATA file …] [ROOT folder] [ENGINE pdflatex|lualatex] [FAULTS faults.toml])
# makes the targets of a paper, none of them part of `all`; README.md has a row for each argument and target. All that is made
# lies in rod_OUTPUT, by default the folder rod of the build folder; -Drod_CASE=file chooses another case. The program is
# compiled so that names of source files begin at ROOT, and gets literate::this_paper(): project, version, compiler, excerpts.

# The names of files in a program and in the paper's own libraries that it links start at `root`: whole names, and those
# that begin at the build folder, which ccache tells the compiler where it has a base_dir. Each object has a record of what it was
# compiled from. LITERATE_COMPILED has all these targets.
function(literate_map_prefix target root)
  get_target_property(aliased ${target} ALIASED_TARGET)
  if(aliased)
    set(target ${aliased})
  endif()
  get_target_property(is_imported ${target} IMPORTED)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(type ${target} TYPE)
  cmake_path(IS_PREFIX root "${folder}" is_inside)
  if(is_imported OR NOT is_inside OR type STREQUAL "INTERFACE_LIBRARY")
    return()
  endif()
  get_target_property(is_mapped ${target} LITERATE_IS_MAPPED)
  if(is_mapped)
    return()
  endif()
  set_property(TARGET ${target} PROPERTY LITERATE_IS_MAPPED ON)
  target_compile_options(${target} PRIVATE "-fmacro-prefix-map=${root}/=")
  file(RELATIVE_PATH from_build "${CMAKE_BINARY_DIR}" "${root}")
  if(from_build)
    cmake_path(APPEND from_build "") # a slash at its end, and one only
    target_compile_options(${target} PRIVATE "-fmacro-prefix-map=${from_build}=")
  endif()
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH engine)
  set_property(TARGET ${target} PROPERTY RULE_LAUNCH_COMPILE "bash \"${engine}/scripts/compile\" \"${root}\"")
  set(compiled ${target})
  get_target_property(links ${target} LINK_LIBRARIES)
  foreach(link IN LISTS links)
    if(TARGET "${link}")
      literate_map_prefix("${link}" "${root}")
      get_target_property(of_link ${link} LITERATE_COMPILED)
      if(of_link)
        list(APPEND compiled ${of_link})
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES compiled)
  set_property(TARGET ${target} PROPERTY LITERATE_COMPILED ${compiled})
endfunction()

# Before anything is compiled, every build asks for what the program is compiled from, the excerpts; before anything is
# typeset, for what only the document tells, the state of the repository. Either is written only where it changed, and no
# program knows the commit: after one nothing is compiled or computed, and the document alone is typeset again.
#
# A program may serve several papers, such as one and its supplement. It is described once, by the folders with code of
# all of them.
function(literate_describe_paper name program latex root sources)
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH engine)
  set(folder "${PROJECT_BINARY_DIR}/generated/${name}")
  set(repository "${folder}/repository")
  add_custom_target(ask_for_commit_of_${name}
    COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${root}" "-DENGINE=${engine}" "-DOUTPUT=${repository}" -P "${engine}/cmake/WriteRepository.cmake"
    BYPRODUCTS "${repository}/repository.json" "${repository}/repository.tex"
    COMMENT "commit"
    VERBATIM)

  get_target_property(described_root ${program} LITERATE_ROOT)
  set_property(TARGET ${program} APPEND PROPERTY LITERATE_SOURCES ${sources})
  if(described_root)
    if(NOT described_root STREQUAL root)
      message(FATAL_ERROR "literate_add_paper: ${name} has the ROOT ${root}, and another paper of ${program} has ${described_root}")
    endif()
    return()
  endif()
  set_property(TARGET ${program} PROPERTY LITERATE_ROOT "${root}")
  set(folders "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${program},LITERATE_SOURCES>>")

  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" flags)
  if(HALFSPACE_SANITIZE)
    string(APPEND flags " -fsanitize=address,undefined")
  endif()
  # Flags may name a folder of this machine, as -isystem does, and the paper is the same everywhere.
  string(REPLACE "${root}" "." flags "${flags}")

  # What literate::this_paper() answers; the program finds the state of the repository as seen from its own folder.
  set(PROJECT "${PROJECT_NAME}")
  set(VERSION "${PROJECT_VERSION}")
  if(NOT VERSION)
    set(VERSION 0)
  endif()
  set(COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  set(BUILD_TYPE "${CMAKE_BUILD_TYPE}")
  set(FLAGS "${flags}")
  set(LATEX "${latex}")
  set(SOURCE_FOLDERS "R\"text($<JOIN:${folders},)text\"$<COMMA> R\"text(>)text\"")
  set(REPOSITORY "$<PATH:RELATIVE_PATH,${repository},$<TARGET_FILE_DIR:${program}>>")
  configure_file("${engine}/cmake/paper.cpp.in" "${folder}/paper.cpp.in" @ONLY)
  file(GENERATE OUTPUT "${folder}/paper.cpp" INPUT "${folder}/paper.cpp.in")

  add_custom_target(ask_for_excerpts_of_${name}
    COMMAND literate::program excerpts --source "${root}" --folders "$<JOIN:${folders},:>" --output "${folder}/excerpts.cpp"
    BYPRODUCTS "${folder}/excerpts.cpp"
    COMMENT "excerpts"
    VERBATIM)
  set(written "${folder}/paper.cpp" "${folder}/excerpts.cpp")
  set_source_files_properties(${written} TARGET_DIRECTORY ${program}
    PROPERTIES GENERATED ON SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${program} PRIVATE ${written})
  add_dependencies(${program} ask_for_excerpts_of_${name})
  target_link_libraries(${program} PRIVATE literate::literate)
  literate_map_prefix(${program} "${root}")
endfunction()

# The files that LaTeX reads of a document: without those of folders below that hold a document of their own.
function(literate_document_files document result)
  set(patterns "")
  foreach(ending IN ITEMS tex bib sty cls bst png jpg jpeg pdf)
    list(APPEND patterns "${document}/*.${ending}")
  endforeach()
  list(APPEND patterns "${document}/results.json") # whose ages of limits the ledger prints
  file(GLOB_RECURSE files CONFIGURE_DEPENDS LIST_DIRECTORIES false ${patterns})
  foreach(file IN LISTS files)
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR "${file}" is_built)
    set(main "")
    if(file MATCHES "[.]tex$" AND NOT folder STREQUAL document)
      file(STRINGS "${file}" main REGEX "^[^%]*[\\]documentclass" LIMIT_COUNT 1)
    endif()
    if(main OR is_built)
      list(APPEND others "${folder}/")
    endif()
  endforeach()
  foreach(other IN LISTS others)
    string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" other "${other}")
    list(FILTER files EXCLUDE REGEX "^${other}")
  endforeach()
  list(REMOVE_ITEM files "${document}/page.tex") # which the page alone reads
  set(${result} "${files}" PARENT_SCOPE)
endfunction()

# A file that lists others. Ninja asks for nothing again because a file is gone, unless something that is there is another.
function(literate_list_of name kind files result)
  set(list "${PROJECT_BINARY_DIR}/generated/${name}/${kind}.list")
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT "${list}" CONTENT "@lines@\n" @ONLY)
  set(${result} "${list}" PARENT_SCOPE)
endfunction()

# What a script does with a paper, or tells of it, each time that it is asked for; behind its name what it needs. Name, scripts
# and settings are those of literate_add_paper.
function(literate_add_script script)
  add_custom_target(${name}-${script} COMMAND bash "${scripts}/${script}" "${settings}" DEPENDS ${ARGN} USES_TERMINAL VERBATIM)
endfunction()

function(literate_add_paper)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;PROGRAM;DOCUMENT;MAIN;CASE;FIGURES;ROOT;ENGINE;FAULTS" "SOURCES;DATA")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "literate_add_paper: unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  foreach(required IN ITEMS NAME PROGRAM DOCUMENT MAIN CASE SOURCES)
    if(NOT arg_${required})
      message(FATAL_ERROR "literate_add_paper: ${required} is missing")
    endif()
  endforeach()
  # What CMake or the engine has a target for; `literate new` refuses the same names.
  if(arg_NAME MATCHES "^(all|clean|depend|edit_cache|help|install|literate|none|package|package_source|test|rebuild_cache|preinstall|list_install_components)$"
      OR TARGET "${arg_NAME}")
    message(FATAL_ERROR "literate_add_paper: NAME ${arg_NAME} is that of another target; choose another name")
  elseif(NOT arg_NAME MATCHES "^[A-Za-z][A-Za-z0-9_-]*$")
    message(FATAL_ERROR "literate_add_paper: NAME ${arg_NAME} cannot name targets: a letter, then letters, digits, - and _")
  endif()
  if(NOT arg_ENGINE)
    set(arg_ENGINE pdflatex)
  elseif(NOT arg_ENGINE MATCHES "^(pdf|lua)latex$")
    message(FATAL_ERROR "literate_add_paper: ENGINE ${arg_ENGINE} is neither pdflatex nor lualatex")
  endif()
  if(NOT TARGET ${arg_PROGRAM})
    message(FATAL_ERROR "literate_add_paper: PROGRAM ${arg_PROGRAM} is no target; add_executable comes first")
  endif()
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH engine)
  set(name "${arg_NAME}")
  set(root "${PROJECT_SOURCE_DIR}")
  if(arg_ROOT)
    cmake_path(ABSOLUTE_PATH arg_ROOT NORMALIZE OUTPUT_VARIABLE root)
  endif()
  cmake_path(ABSOLUTE_PATH arg_DOCUMENT NORMALIZE OUTPUT_VARIABLE document)
  string(REGEX REPLACE "/$" "" document "${document}")
  set(figures "${root}/figures")
  if(arg_FIGURES)
    cmake_path(ABSOLUTE_PATH arg_FIGURES NORMALIZE OUTPUT_VARIABLE figures)
  endif()
  cmake_path(ABSOLUTE_PATH arg_CASE NORMALIZE OUTPUT_VARIABLE case)
  set(data "")
  foreach(file IN LISTS arg_DATA)
    cmake_path(ABSOLUTE_PATH file NORMALIZE)
    list(APPEND data "${file}")
  endforeach()
  set(faults "")
  if(arg_FAULTS)
    cmake_path(ABSOLUTE_PATH arg_FAULTS NORMALIZE OUTPUT_VARIABLE faults)
  endif()
  # What the scripts of DATA read belongs to what the paper is made from. They may be told of later, so generators look it up:
  # reads, the tools that run them, records of what they read and made, and sames, that the files are still what they made.
  literate_make_scripts()
  foreach(kind IN ITEMS reads tools records sames)
    set(${kind} "")
    foreach(file IN LISTS data)
      string(SHA256 id "${file}")
      list(APPEND ${kind} "$<TARGET_PROPERTY:literate_scripts,${kind}_${id}>")
    endforeach()
    set(${kind} "$<REMOVE_DUPLICATES:${${kind}}>")
  endforeach()
  set(${name}_CASE "${case}" CACHE FILEPATH "Parameter file of ${name}")
  set(${name}_OUTPUT "${PROJECT_BINARY_DIR}/${name}" CACHE PATH
    "Where ${name} and what it is made from are written")
  set(case "${${name}_CASE}")
  set(output "${${name}_OUTPUT}")
  set(scripts "${engine}/scripts")
  set(generated "${output}/generated")
  set(digest "${output}/generated.sha256")
  set(state "${output}/state") # a record for each stage that is done
  set(settings "${PROJECT_BINARY_DIR}/${name}.settings")
  set(repository "${PROJECT_BINARY_DIR}/generated/${name}/repository")

  literate_describe_paper(${name} ${arg_PROGRAM} ${arg_ENGINE} "${root}" "${arg_SOURCES}")
  # Without its table of symbols the program is half as large, and each build reads it to see that it is whole.
  target_link_options(${arg_PROGRAM} PRIVATE $<$<CONFIG:Release>:-s>)

  # The objects that the program is linked from, and what they were compiled from.
  set(objects "${PROJECT_BINARY_DIR}/generated/${name}/objects.list")
  set(compiled "${PROJECT_BINARY_DIR}/${name}.compiled")
  get_target_property(targets ${arg_PROGRAM} LITERATE_COMPILED)
  set(lines "")
  if(targets)
    list(TRANSFORM targets REPLACE "(.+)" "$<JOIN:$<TARGET_OBJECTS:\\1>,\n>\n" OUTPUT_VARIABLE lines)
    list(JOIN lines "" lines)
  endif()
  file(GENERATE OUTPUT "${objects}" CONTENT "${lines}")

  # What the stages and the scripts know of the paper.
  list(JOIN arg_SOURCES ":" sources)
  list(JOIN data ":" joined_data)
  file(GENERATE OUTPUT "${settings}" CONTENT
"name=${name}
project=${PROJECT_NAME}
root=${root}
build=${CMAKE_BINARY_DIR}
program=$<TARGET_FILE:${arg_PROGRAM}>
literate=$<TARGET_FILE:literate::program>
document=${document}
main=${arg_MAIN}
case=${case}
sources=${sources}
figures=${figures}
data=${joined_data}
faults=${faults}
reads=$<JOIN:${reads},:>
tools=$<JOIN:${tools},:>
records=${compiled}:$<JOIN:${records},:>
objects=${objects}
output=${output}
repository=${repository}
engine=${engine}
latex=${arg_ENGINE}
")

  # By its SHA-256 a damaged program is known: an empty one would be run by the shell, which finds no fault.
  set(linked "${PROJECT_BINARY_DIR}/${name}.linked")
  add_custom_command(
    OUTPUT "${linked}" "${compiled}"
    COMMAND "${CMAKE_COMMAND}" "-DFILE=$<TARGET_FILE:${arg_PROGRAM}>" "-DOUTPUT=${linked}"
      "-DOBJECTS=${objects}" "-DCOMPILED=${compiled}"
      -P "${engine}/cmake/WriteLinked.cmake"
    DEPENDS ${arg_PROGRAM} "${engine}/cmake/WriteLinked.cmake"
    COMMENT "linked program"
    VERBATIM)
  add_custom_target(${name}_linked DEPENDS "${linked}")

  # What `severity` found of the claims stands in the ledger.
  file(GLOB severity_record CONFIGURE_DEPENDS "${document}/severity.csv")

  # The program leaves a file alone that would not change: whatever was computed or drawn anew, the document is typeset
  # again only if something it reads is different. (Ninja's `restat` remembers the run.)
  add_custom_command(
    OUTPUT "${generated}/names.json" "${state}/compute"
    COMMAND ${arg_PROGRAM} compute "${settings}"
    # std::_Exit(0) tells nobody, not even the stage.
    COMMAND sh -c "test -e \"$1\" || { echo '${name}: the computation ended the program by itself, before it was done' >&2; exit 1; }"
      sh "${state}/compute"
    DEPENDS ${arg_PROGRAM} "${linked}" "${settings}" "${case}" ${data} "${sames}" ${severity_record}
    COMMENT "compute"
    USES_TERMINAL
    VERBATIM)

  # Scripts are read when the figures are drawn: a changed one asks for no compiler and computes nothing. The figures
  # that the change does not concern are left as they are.
  file(GLOB figure_scripts CONFIGURE_DEPENDS "${figures}/*.gp")
  literate_list_of(${name} scripts "${figure_scripts}" list_of_scripts)
  add_custom_command(
    OUTPUT "${digest}" "${state}/draw"
    COMMAND ${arg_PROGRAM} draw "${settings}"
    DEPENDS ${arg_PROGRAM} "${settings}" "${state}/compute" "${list_of_scripts}" ${figure_scripts}
    COMMENT "draw"
    USES_TERMINAL
    VERBATIM)
  add_custom_target(${name}-figures DEPENDS "${digest}")

  # The manifest names every source, so this runs after each change of the program. LaTeX itself does nothing then,
  # unless a result or the prose is another one.
  literate_document_files("${document}" files)
  literate_list_of(${name} document "${files}" list_of_document)
  # The PDF is no output that Ninja knows, because Ninja deletes those of a command that is interrupted.
  add_custom_command(
    OUTPUT "${state}/typeset"
    COMMAND ${arg_PROGRAM} typeset "${settings}"
    # A second command keeps the shell, and the shell says which signal ended the first.
    COMMAND "${CMAKE_COMMAND}" -E true
    DEPENDS ${arg_PROGRAM} "${settings}" "${digest}" "${case}" "${repository}/repository.json" "${list_of_document}" ${files} "${reads}"
    COMMENT "typeset"
    USES_TERMINAL
    VERBATIM)
  add_custom_target(${name}-made DEPENDS "${state}/typeset")
  # Whoever asks for the paper gets the last look too.
  add_custom_target(${name}
    COMMAND bash "${scripts}/look" "${settings}" --tell
    DEPENDS "${state}/typeset"
    COMMENT "look"
    USES_TERMINAL
    VERBATIM)

  # The same sources as one page.
  file(GLOB page_parts CONFIGURE_DEPENDS LIST_DIRECTORIES false
    "${engine}/page/*.css" "${engine}/page/*.js" "${engine}/page/*.tex"
    "${engine}/page/*.lua" "${document}/page.tex")
  literate_list_of(${name} page "${page_parts}" list_of_page)
  add_custom_command(
    OUTPUT "${output}/${name}.html"
    COMMAND bash "${scripts}/html" "${settings}"
    DEPENDS "${state}/typeset" "${digest}" "${repository}/repository.tex" ${files} "${list_of_page}" ${page_parts} "${scripts}/html"
      ${arg_PROGRAM}
    COMMENT "html"
    USES_TERMINAL
    VERBATIM)
  add_custom_target(${name}-html DEPENDS "${output}/${name}.html")

  literate_add_script(figure "${digest}")
  literate_add_script(site "${state}/typeset" "${output}/${name}.html")
  literate_add_script(check "${digest}")
  literate_add_script(changes "${digest}" "${repository}/repository.json")
  literate_add_script(verify "${state}/typeset")
  literate_add_script(dist "${state}/typeset")
  literate_add_script(reports ${arg_PROGRAM} "${repository}/repository.json")
  literate_add_script(watch)
  literate_add_script(why)
  add_custom_target(${name}-severity COMMAND python3 "${scripts}/severity" "${settings}" USES_TERMINAL VERBATIM)
endfunction()

# The target whose properties tell of each file of data what literate_run_script says of it.
function(literate_make_scripts)
  if(NOT TARGET literate_scripts)
    add_library(literate_scripts INTERFACE IMPORTED GLOBAL)
  endif()
endfunction()

# literate_run_script(MAKES measured.csv COMMAND python3 measure.py [READS raw.txt …]) has the build run the script that
# writes files of DATA, whenever it, a file that its command names or one of READS is another one, by content: numbers are then
# never older than their script. It runs in the folder of the CMakeLists.txt.
function(literate_run_script)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "MAKES;COMMAND;READS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_MAKES OR NOT arg_COMMAND)
    message(FATAL_ERROR "literate_run_script takes MAKES files, COMMAND and READS files, not '${ARGV}'")
  endif()
  set(read "")
  foreach(word IN LISTS arg_COMMAND)
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${word}")
      list(APPEND read "${word}")
    endif()
  endforeach()
  if(NOT read)
    message(FATAL_ERROR "literate_run_script: no word of '${arg_COMMAND}' is a file in ${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  list(JOIN arg_COMMAND " " said)

  # CMake does not tell a function the line that called it, so the line is looked for.
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_LIST_FILE BASE_DIRECTORY "${CMAKE_SOURCE_DIR}" OUTPUT_VARIABLE place)
  file(READ "${CMAKE_CURRENT_LIST_FILE}" text)
  list(GET arg_MAKES 0 first)
  string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" first "${first}")
  if(text MATCHES "^(.*\n)?[ \t]*literate_run_script[ \t]*\\([^)#]*MAKES[ \t\n]+\"?${first}[ \t\n\")]")
    string(REGEX REPLACE "[^\n]" "" line "${CMAKE_MATCH_1}x")
    string(LENGTH "x${line}" line)
    string(APPEND place ":${line}")
  endif()

  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH engine)
  list(POP_FRONT arg_COMMAND tool)
  set(interpreter "${tool}") # which runs the script; a program of the paper's own stands in the manifest already
  if(TARGET "${tool}")
    set(interpreter "")
    set(tool "$<TARGET_FILE:${tool}>")
  elseif(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${tool}")
    set(interpreter "")
  endif()
  list(APPEND read ${arg_READS})
  foreach(files IN ITEMS read arg_MAKES)
    set(named "${${files}}")
    set(${files} "")
    foreach(file IN LISTS named)
      cmake_path(ABSOLUTE_PATH file NORMALIZE)
      list(APPEND ${files} "${file}")
    endforeach()
  endforeach()
  list(GET arg_MAKES 0 first)
  string(SHA256 hash "${first}")
  string(SUBSTRING "${hash}" 0 16 hash)
  set(record "${CMAKE_CURRENT_BINARY_DIR}/made-${hash}")
  literate_make_scripts()
  foreach(made IN LISTS arg_MAKES)
    string(SHA256 id "${made}")
    set_property(TARGET literate_scripts PROPERTY reads_${id} ${read})
    set_property(TARGET literate_scripts PROPERTY tools_${id} ${interpreter})
    set_property(TARGET literate_scripts PROPERTY records_${id} "${record}" "${record}.read")
    set_property(TARGET literate_scripts PROPERTY sames_${id} "${record}.same")
  endforeach()
  # What was changed by hand afterwards is not what the script made.
  add_custom_command(OUTPUT "${record}.same"
    COMMAND bash "${engine}/scripts/run" "${PROJECT_NAME}: ${place}" "${record}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${record}.same"
    DEPENDS "${record}" ${arg_MAKES}
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    COMMENT "made"
    VERBATIM)
  # Every build asks whether it would read what it has read.
  add_custom_target(ask_for_reads_of_${hash}
    COMMAND bash "${engine}/scripts/run" "${PROJECT_NAME}: ${place}" "${record}" --asks
    BYPRODUCTS "${record}.asked"
    COMMENT "read"
    VERBATIM)
  add_custom_command(OUTPUT ${arg_MAKES} "${record}"
    COMMAND bash "${engine}/scripts/run" "${PROJECT_NAME}: ${place}" "${record}" ${read} -- ${arg_MAKES} -- "${tool}" ${arg_COMMAND}
    DEPENDS ${read} "${record}.asked"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    COMMENT "${said}"
    VERBATIM)
endfunction()
