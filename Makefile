# SPDX-License-Identifier: GPL-3.0-or-later
# The targets of the project, a line each. CMake (CMakePresets.json) and Ninja know the dependencies; this file only names targets.
#
#   CASE=file.toml   another parameter file than report/ruggiero2001.toml, relative to where you call make; writes to build/report-file
#   CASES='cases/*.toml' J=2 KEYS='key …'   report: one for each of these files, how many at a time, what to compare
#   SITE=https://…   site: the address at which it will stand
#   NAME=name        figures: this one alone, as a picture
#   PAPER=file       check-report: the text of the paper, against which every quotation is held
#   RECORD=1         check-report: keep the results beside the prose; commit them, and later it lists what must be read again
#   MANIFEST=file    verify: compare with the manifest of a report made elsewhere instead of making it twice
#   DEPTH=traced     verify: holds hashes against the manifest and runs nothing; PDF=file, of this file alone
#   DEPTH=sampled    verify: computes some claims again, CLAIMS='id …' or drawn by SEED=number; without DEPTH all is made again
#   SINCE=tag        changes: a tag, a commit, or the manifest of a report made elsewhere
#   KINDS=faults,interruptions,cases ONLY=text   faults: of what kind, and of which name
#   ONLY=id          mutants, severity: this one alone
#   EDITS=1          bench: what an author's edits cost, here and with knitr
#   DEPTH=bare       verify: the README's two commands on Debians that have nothing yet (as root; takes long), SUITES='bookworm trixie container'
#   DO=task          course: which; its variables are told by 'make course'
#   TIMEOUT=seconds  how long the computation, gnuplot or LaTeX may take before they are stopped; TIMEOUT= for any time
#   V=1              show the commands

#@ To read
report: ## the report, build/report/report.pdf; with CASES one for each case, and build/reports/cases.csv
html: ## the report as one page, build/report/report.html (first: make setup html)
site: ## page, PDF, data and assignment sheet for any static host, build/report/site
dist: ## the document as arXiv and journals take it, build/dist/report.tar.gz
halfspace: ## the command line of the mechanics, build/release/halfspace
install: ## this program, its man page and completions, below PREFIX, /usr/local without it

#@ To look while you write
watch: ## builds the report after each save, until Ctrl-C
figures: ## its values, tables and figures only, build/report/generated; with NAME one as a picture, build/figures/NAME.png
check-report: ## its prose: unknown and unused names, typed numbers; and what does not hold
severity: ## which planted faults turn which claims, report/severity.csv; a run that was stopped goes on
why: ## why the report would be built again
changes: ## what changed since SINCE: values, figures, verdicts with the sentences that print them, an answer to referees, and a marked PDF

#@ To prove
test: ## the everyday tests, which take a few minutes
test-all: ## every test, also those that take minutes each; continuous integration runs this
faults: ## breaks and interrupts the making of the report in every way known, and has the next make recover
mutants: ## plants faults, each of which must turn a test or the report red
verify: ## makes the report again elsewhere and asks for the same bytes; with DEPTH less and a certificate, or more
bench: ## benchmarks, build/bench/bench.json

#@ To teach
course: ## the course: handouts, grading, results; without DO it lists the tasks

#@ To keep house
tidy: ## clang-format and clang-tidy on every source
setup: ## installs what the targets behind it lack, and they are made: make setup report, make setup test
clean: ## remove everything built
help: ## this list

targets := $(shell sed -n 's/^\([a-z-]*\): \#\# .*/\1/p' $(lastword $(MAKEFILE_LIST)))
.PHONY: $(targets)
.DEFAULT_GOAL := report
# Two targets at once would run Ninja twice in one folder. Ninja itself runs commands in parallel.
.NOTPARALLEL:

# Before anything is installed or made.
unknown := $(firstword $(filter-out $(targets),$(MAKECMDGOALS)))
$(if $(unknown),$(error there is no target $(unknown); 'make help' lists them))

# The scripts read the variables of the command line from the environment, because make would split paths at spaces. Of a
# shell's own NAME nobody here knows.
export CALLER := $(value PWD)
ifeq ($(origin NAME),environment)
unexport NAME
endif

# Messages, number formats and sorting are the same for everyone.
export LC_ALL := C

$(filter-out setup install help,$(targets)):
	@bash src/toolchain/build $@

install: halfspace
	@cmake --install build/release --component halfspace --prefix "$(or $(PREFIX),/usr/local)"

setup:
	@sh src/toolchain/setup $(filter-out setup clean help,$(MAKECMDGOALS))

help:
	@awk -F ': ## ' '/^#@ / { print substr($$0, 4) } /^[a-z-]+: ## / { printf "  make %-12s %s\n", $$1, $$2 }' Makefile
	@awk 'BEGIN { print "Variables" } /^#   [A-Z]/ { sub(/^#  /, ""); print }' Makefile
