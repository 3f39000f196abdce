# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE= -DENGINE= -DOUTPUT= -P WriteRepository.cmake
# Writes the state of the repository SOURCE to the folder OUTPUT, for the program as repository.json and for LaTeX as
# repository.tex: the commit, whether files differ from it, and the date; and of the engine, whose folder ENGINE is that of its
# sources or an installed one, the commit. Files that would not change are left untouched.
cmake_minimum_required(VERSION 3.25)

# What git says of a checkout; nothing if it is none.
function(read_status checkout result)
  set(status "")
  # A source archive unpacked inside another checkout must not report that one's commit: .git is looked for here only.
  if(EXISTS "${checkout}/.git")
    # A git hook that starts a build would send git to the hook's own checkout.
    unset(ENV{GIT_DIR})
    unset(ENV{GIT_WORK_TREE})
    unset(ENV{GIT_INDEX_FILE})
    # No locks: someone may be committing. safe.directory: containers build a checkout that belongs to someone else.
    execute_process(
      COMMAND git --no-optional-locks -c "safe.directory=${checkout}"
        status --porcelain=v2 --branch --untracked-files=normal
      WORKING_DIRECTORY "${checkout}"
      OUTPUT_VARIABLE status
      ERROR_QUIET
      RESULT_VARIABLE failed)
    if(NOT failed EQUAL 0)
      set(status "")
    endif()
  endif()
  set(${result} "${status}" PARENT_SCOPE)
endfunction()

# The commit in what git said, and whether files differ from it.
function(read_commit status commit modified)
  set(${commit} unknown PARENT_SCOPE)
  set(${modified} false PARENT_SCOPE)
  if(status MATCHES "# branch\\.oid ([0-9a-f]+)\n")
    string(SUBSTRING "${CMAKE_MATCH_1}" 0 12 digits)
    set(${commit} "${digits}" PARENT_SCOPE)
    if(status MATCHES "(^|\n)[^#\n]")
      set(${modified} true PARENT_SCOPE)
    endif()
  endif()
endfunction()

set(DATE unknown)
set(seconds "$ENV{SOURCE_DATE_EPOCH}")
read_status("${SOURCE}" status)
read_commit("${status}" COMMIT MODIFIED)
if(seconds STREQUAL "" AND NOT COMMIT STREQUAL unknown)
  execute_process(
    COMMAND git -c "safe.directory=${SOURCE}" log -1 --format=%ct
    WORKING_DIRECTORY "${SOURCE}"
    OUTPUT_VARIABLE seconds
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET)
endif()

# An installed engine has kept what it was installed from.
set(ENGINE_COMMIT unknown)
set(ENGINE_MODIFIED false)
if(ENGINE)
  file(REAL_PATH "${ENGINE}/../.." engine_root)
  file(REAL_PATH "${SOURCE}" source_root)
  if(EXISTS "${ENGINE}/repository.json")
    file(READ "${ENGINE}/repository.json" kept)
    string(JSON ENGINE_COMMIT ERROR_VARIABLE ignored GET "${kept}" commit)
    string(JSON is_modified ERROR_VARIABLE ignored GET "${kept}" modified)
    if(is_modified STREQUAL "ON")
      set(ENGINE_MODIFIED true)
    endif()
  else()
    if(NOT engine_root STREQUAL source_root)
      read_status("${engine_root}" status)
    endif()
    read_commit("${status}" ENGINE_COMMIT ENGINE_MODIFIED)
  endif()
endif()

# What is no number of seconds is no date. string(TIMESTAMP) prints the date of SOURCE_DATE_EPOCH.
if(seconds MATCHES "^[0-9]+$")
  set(ENV{SOURCE_DATE_EPOCH} "${seconds}")
  string(TIMESTAMP DATE "%Y-%m-%dT%H:%M:%SZ" UTC)
endif()

file(CONFIGURE OUTPUT "${OUTPUT}/repository.json" @ONLY CONTENT
  [[{"commit": "@COMMIT@", "modified": @MODIFIED@, "date": "@DATE@",
 "engine": {"commit": "@ENGINE_COMMIT@", "modified": @ENGINE_MODIFIED@}}
]])
file(CONFIGURE OUTPUT "${OUTPUT}/repository.tex" @ONLY CONTENT [[\LiterateRepository{@COMMIT@}{@MODIFIED@}{@DATE@}
]])
