# SPDX-License-Identifier: GPL-3.0-or-later
# Names for what CMake, Ninja and src/literate/tools/literate do; `make help` lists them, with these variables:
#
#   CASE=mine.toml         report: of a different case, in build/report-mine
#   CASES='x/*.toml' J=2   cases: these, and how many at a time
#   PAPER=file             check: the text in which quotations are looked up
#   SINCE=commit           changes: or a results.json or manifest.json
#   ONLY=id                severity: one fault only
#   MANIFEST=file          verify: compare numbers with a report made elsewhere
#   DO=prove               course: or gradescope; or grade, with SUBMISSIONS=folder
#                          and CLASS=file, the table that Moodle or Canvas exported
#   PREFIX=folder          install: instead of /usr/local
.DEFAULT_GOAL := report
.NOTPARALLEL:
targets := $(shell sed -n 's/^\([a-z-]*\):.* \#\# .*/\1/p' $(lastword $(MAKEFILE_LIST)))
variables := CASE CASES J SINCE PAPER MANIFEST ONLY DO SUBMISSIONS CLASS SANDBOX PREFIX
.PHONY: $(targets)
export LC_ALL := C.UTF-8

# A misspelt target or variable would otherwise do something else than was meant.
unknown := $(firstword $(filter-out $(targets),$(MAKECMDGOALS)))
$(if $(unknown),$(error there is no target '$(unknown)'; 'make help' lists them))
given := $(foreach name,$(.VARIABLES),$(if $(filter command line,$(origin $(name))),$(name)))
unknown := $(firstword $(filter-out $(variables) V MAKEFLAGS,$(given)))
$(if $(unknown),$(error there is no variable '$(unknown)'; they are $(variables)))
export $(variables)

# One make at a time. CMake starts afresh only in a checkout that was moved, which its cache refuses; Ninja sees everything else.
lock = mkdir -p build && exec 9>build/.lock && { flock --nonblock 9 || { echo 'waiting for the make that runs here' >&2; flock 9; }; }
configure = $(lock); [ "$$(cat build/configured 2>/dev/null)" = "$$PWD" ] || { \
	  cmake --preset release >build/configure.log 2>&1 || cmake --fresh --preset release >build/configure.log 2>&1 || { \
	    cat build/configure.log >&2; exit 2; }; \
	  pwd >build/configured; }
with_tests = $(configure); grep -q BUILD_TESTING:BOOL=ON build/release/CMakeCache.txt || \
	cmake --preset release -DBUILD_TESTING=ON >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 2; }
ninja = $(literate) build --folder build/release
literate = python3 src/literate/tools/literate

report: ## the report, build/report/report.pdf
	@$(configure); if [ -z "$$CASE" ]; then $(ninja) report && echo build/report/report.pdf; else \
	  $(ninja) report-program && $(literate) case build/report.json "$$CASE" "build/report-$$(basename "$$CASE" .toml)"; fi
figures: ## its numbers, tables and figures only, build/report/generated
	@$(configure); $(ninja) report-figures
check: ## typed numbers, unused names and quotations in its prose
	@$(configure); $(ninja) report-pdf && $(literate) check build/report.json $${PAPER:+--paper "$$PAPER"}
changes: ## what changed since SINCE, with the places that print it
	@$(configure); $(ninja) report-pdf && $(literate) changes build/report.json "$${SINCE:-HEAD}"
severity: ## which planted faults turn which claims, report/severity.csv
	@$(configure); $(ninja) report-program && $(literate) severity build/report.json $${ONLY:+--only "$$ONLY"}
verify: report ## builds the report elsewhere and compares the bytes
	@$(literate) verify build/report.json $${MANIFEST:+--manifest "$$MANIFEST"}
cases: ## the reports of CASES and one table, build/cases/cases.csv
	@$(configure); $(ninja) report-program && $(literate) cases build/report.json -j "$${J:-1}" $$CASES
watch: ## builds the report after each save, until Ctrl-C
	@git ls-files -co --exclude-standard | entr -c $(MAKE) --no-print-directory report
dist: report ## packs the document for arXiv, build/report/report.tar.gz
	@$(literate) dist build/report.json
html: ## the report as one page, build/report/report.html
	@$(configure); $(ninja) report-pdf && $(literate) html build/report.json
site: ## page, PDF and data for any static host, build/report/site
	@$(configure); $(ninja) report-pdf && $(literate) site build/report.json CITATION.cff
halfspace: ## the command line of the mechanics, build/release/halfspace
	@$(configure); $(ninja) halfspace
install: ## engine, halfspace, completion and man page, below PREFIX
	@$(configure); $(ninja) halfspace literate-results && cmake --install build/release --prefix "$${PREFIX:-/usr/local}"
course: ## the assignment; without DO its help
	@if [ -z "$$DO" ]; then python3 src/course/course.py --help; exit; fi; $(configure); \
	  case $$DO in gradescope) judge=halfspace-judge-static ;; *) judge=halfspace-judge ;; esac; \
	  $(ninja) $$judge && python3 -B src/course/course.py $$DO $${SUBMISSIONS:+"$$SUBMISSIONS"} $${CLASS:+--class "$$CLASS"} \
	    $${J:+--jobs "$$J"} $${SANDBOX:+--sandbox "$$SANDBOX"}
test: ## the everyday tests
	@$(with_tests); $(ninja) everyday_tests && ctest --preset everyday -j $$(($$(nproc) + 1))
test-all: ## every test
	@$(with_tests); $(ninja) all && ctest --preset release -j $$(($$(nproc) + 1))
bench: ## benchmarks, build/bench/bench.json
	@$(lock); cmake --preset bench >build/configure.log && ninja -C build/bench --quiet halfspace_bench && \
	  build/bench/halfspace_bench --benchmark_out=build/bench/bench.json --benchmark_out_format=json
tidy: ## clang-format and clang-tidy on every source
	@$(lock); git ls-files 'src/*.[ch]pp' 'tests/*.[ch]pp' | xargs clang-format -i && \
	  cmake --preset tidy >build/configure.log && ninja -C build/tidy all
setup: ## installs Debian packages: make setup report
	@sh src/toolchain/setup $(filter-out setup clean help,$(MAKECMDGOALS))
clean: ## removes everything that was built
	@rm -rf build
help: ## this list
	@sed -n 's/^\([a-z-]*\):.* ## /  make \1\t/p' Makefile | expand -t 19
	@sed -n 's/^#  \( .*\)/\1/p' Makefile
	@printf '%s lines in src, %s in tests; src/budget.txt limits each folder\n' \
	  "$$(git ls-files src | xargs cat | wc -l)" "$$(git ls-files tests | xargs cat | wc -l)"
