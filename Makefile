# SPDX-License-Identifier: GPL-3.0-or-later
# Short names for commands of CMake, Ninja and src/literate/tools/literate. `make help` lists them with these variables:
#
#   CASE=mine.toml         report: of this case, in build/report-mine
#   CASES='x/*.toml' J=2   cases: the files, and the number of parallel jobs
#   PAPER=file             check: the text that contains the quotations
#   SINCE=commit           changes: since a commit, results.json or manifest.json
#   ONLY=id                severity: of one fault only
#   MANIFEST=file          verify: the manifest of a report built elsewhere
#   DO=prove               course: or DO=gradescope, DO=grade SUBMISSIONS=folder;
#                          CLASS=file is the table that Moodle or Canvas exported
#   PREFIX=folder          install: the destination instead of /usr/local
.DEFAULT_GOAL := report
.NOTPARALLEL:
targets := $(shell sed -n 's/^\([a-z-]*\):.* \#\# .*/\1/p' $(lastword $(MAKEFILE_LIST)))
variables := CASE CASES J SINCE PAPER MANIFEST ONLY DO SUBMISSIONS CLASS SANDBOX PREFIX
.PHONY: $(targets)
export LC_ALL := C.UTF-8

# Without this, make would ignore a misspelt variable.
unknown := $(firstword $(filter-out $(targets),$(MAKECMDGOALS)))
$(if $(unknown),$(error there is no target '$(unknown)'; 'make help' lists them))
given := $(foreach name,$(.VARIABLES),$(if $(filter command line,$(origin $(name))),$(name)))
unknown := $(firstword $(filter-out $(variables) V MAKEFLAGS,$(given)))
$(if $(unknown),$(error there is no variable '$(unknown)'; they are $(variables)))
export $(variables)

# Only one make runs at a time. If the checkout was moved, CMake starts from scratch; Ninja detects all other changes.
lock = mkdir -p build && exec 9>build/.lock && { flock --nonblock 9 || { echo 'waiting for the other make in this folder' >&2; flock 9; }; }
stop = { grep -A 99 'CMake Error' build/configure.log >&2 || cat build/configure.log >&2; \
	  echo "'make setup $@' installs packages that are missing" >&2; exit 2; }
configure = $(lock); [ "$$(cat build/configured 2>/dev/null)" = "$$PWD" ] || { \
	  cmake --preset release >build/configure.log 2>&1 || cmake --fresh --preset release >build/configure.log 2>&1 || $(stop); \
	  pwd >build/configured; }
with_tests = $(configure); grep -q BUILD_TESTING:BOOL=ON build/release/CMakeCache.txt || \
	cmake --preset release -DBUILD_TESTING=ON >build/configure.log 2>&1 || $(stop)
ctest = env -u MAKEFLAGS -u MAKELEVEL ctest
ninja = $(literate) build --folder build/release
literate = python3 src/literate/tools/literate

report: ## builds the report, build/report/report.pdf
	@$(configure); if [ -z "$$CASE" ]; then $(ninja) report && echo build/report/report.pdf; else \
	  $(ninja) report-program && $(literate) case build/report.json "$$CASE" "build/report-$$(basename "$$CASE" .toml)"; fi
figures: ## computes its numbers, tables, figures: build/report/generated
	@$(configure); $(ninja) report-figures
check: ## checks its prose: typed numbers, unused names, quotations
	@$(configure); $(ninja) report-pdf && $(literate) check build/report.json $${PAPER:+--paper "$$PAPER"}
changes: ## lists what changed since SINCE, and where it is printed
	@$(configure); $(ninja) report-pdf && $(literate) changes build/report.json "$${SINCE:-HEAD}"
severity: ## plants faults to test the claims, report/severity.csv
	@$(configure); $(ninja) report-results && $(literate) severity build/report.json $${ONLY:+--only "$$ONLY"}
verify: report ## builds the report elsewhere and compares all bytes
	@$(literate) verify build/report.json $${MANIFEST:+--manifest "$$MANIFEST"}
cases: ## builds reports of CASES and one table, build/cases/cases.csv
	@$(configure); $(ninja) report-program && $(literate) cases build/report.json -j "$${J:-1}" $$CASES
watch: ## builds the report after each save, until Ctrl-C
	@git ls-files -co --exclude-standard | entr -c $(MAKE) --no-print-directory report
dist: report ## packs the document for arXiv, build/report/report.tar.gz
	@$(literate) dist build/report.json
html: ## makes the report a web page, build/report/report.html
	@$(configure); $(ninja) report-pdf && $(literate) html build/report.json
site: ## collects page, PDF and data for the web, build/report/site
	@$(configure); $(ninja) report-pdf && $(literate) site build/report.json CITATION.cff
halfspace: ## builds the program for mechanics, build/release/halfspace
	@$(configure); $(ninja) halfspace
install: ## installs engine, halfspace, completion, man page to PREFIX
	@$(configure); $(ninja) halfspace literate-results && cmake --install build/release --prefix "$${PREFIX:-/usr/local}"
course: ## proves, grades, packs the assignment; without DO prints help
	@if [ -z "$$DO" ]; then python3 src/course/course.py --help; exit; fi; $(configure); \
	  case $$DO in gradescope) judge=halfspace-judge-static ;; *) judge=halfspace-judge ;; esac; \
	  $(ninja) $$judge && python3 -B src/course/course.py $$DO $${SUBMISSIONS:+"$$SUBMISSIONS"} $${CLASS:+--class "$$CLASS"} \
	    $${J:+--jobs "$$J"} $${SANDBOX:+--sandbox "$$SANDBOX"}
test: ## runs the everyday tests
	@$(with_tests); $(ninja) everyday_tests && $(ctest) --preset everyday -j $$(($$(nproc) + 1))
test-all: ## runs every test
	@$(with_tests); $(ninja) all && $(ctest) --preset release -j $$(($$(nproc) + 1))
bench: ## runs the benchmarks, build/bench/bench.json
	@$(lock); cmake --preset bench >build/configure.log && ninja -C build/bench --quiet halfspace_bench && \
	  build/bench/halfspace_bench --benchmark_out=build/bench/bench.json --benchmark_out_format=json
tidy: ## runs clang-format, clang-tidy and mypy on every source
	@$(lock); git ls-files 'src/*.[ch]pp' 'tests/*.[ch]pp' | xargs clang-format -i && \
	  mypy --strict --cache-dir build/mypy src/course/*.py src/literate/tools/literate_tools src/literate/python/literate.py && \
	  cmake --preset tidy >build/configure.log && ninja -C build/tidy all
setup: ## installs Debian packages: make setup report
	@sh src/toolchain/setup $(filter-out setup clean help,$(MAKECMDGOALS))
clean: ## removes all build results
	@rm -rf build
help: ## prints this list
	@sed -n 's/^\([a-z-]*\):.* ## /  make \1\t/p' Makefile | expand -t 19
	@sed -n 's/^#  \( .*\)/\1/p' Makefile
	@printf '%s lines in src, %s in tests; src/budget.txt limits each folder\n' \
	  "$$(git ls-files src | xargs cat | wc -l)" "$$(git ls-files tests | xargs cat | wc -l)"
