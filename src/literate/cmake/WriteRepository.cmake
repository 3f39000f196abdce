# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE= -DOUTPUT= -P WriteRepository.cmake
# Writes the state of the repository SOURCE to the folder OUTPUT, for the program as repository.json and for LaTeX as
# repository.tex: the commit, whether files differ from it, and the date. Files that would not change are left untouched.
cmake_minimum_required(VERSION 3.25)

set(COMMIT unknown)
set(MODIFIED false)
set(DATE unknown)
set(seconds "$ENV{SOURCE_DATE_EPOCH}")

# A source archive unpacked inside another checkout must not report that one's commit: .git is looked for here only.
if(EXISTS "${SOURCE}/.git")
  # A git hook that starts a build would send git to the hook's own checkout.
  unset(ENV{GIT_DIR})
  unset(ENV{GIT_WORK_TREE})
  unset(ENV{GIT_INDEX_FILE})
  # No locks: someone may be committing. safe.directory: containers build a checkout that belongs to someone else.
  execute_process(
    COMMAND git --no-optional-locks -c "safe.directory=${SOURCE}"
      status --porcelain=v2 --branch --untracked-files=normal
    WORKING_DIRECTORY "${SOURCE}"
    OUTPUT_VARIABLE status
    ERROR_QUIET
    RESULT_VARIABLE failed)
  if(failed EQUAL 0 AND status MATCHES "# branch\\.oid ([0-9a-f]+)\n")
    string(SUBSTRING "${CMAKE_MATCH_1}" 0 12 COMMIT)
    if(status MATCHES "(^|\n)[^#\n]")
      set(MODIFIED true)
    endif()
    if(seconds STREQUAL "")
      execute_process(
        COMMAND git -c "safe.directory=${SOURCE}" log -1 --format=%ct
        WORKING_DIRECTORY "${SOURCE}"
        OUTPUT_VARIABLE seconds
        OUTPUT_STRIP_TRAILING_WHITESPACE
        ERROR_QUIET)
    endif()
  endif()
endif()

# What is no number of seconds is no date. string(TIMESTAMP) prints the date of SOURCE_DATE_EPOCH.
if(seconds MATCHES "^[0-9]+$")
  set(ENV{SOURCE_DATE_EPOCH} "${seconds}")
  string(TIMESTAMP DATE "%Y-%m-%dT%H:%M:%SZ" UTC)
endif()

file(CONFIGURE OUTPUT "${OUTPUT}/repository.json" @ONLY CONTENT
  [[{"commit": "@COMMIT@", "modified": @MODIFIED@, "date": "@DATE@"}
]])
file(CONFIGURE OUTPUT "${OUTPUT}/repository.tex" @ONLY CONTENT [[\LiterateRepository{@COMMIT@}{@MODIFIED@}{@DATE@}
]])
