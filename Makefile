# SPDX-License-Identifier: GPL-3.0-or-later
# The targets of the project. CMake (CMakePresets.json) and Ninja know the dependencies; this file only names targets.
#
#   CASE=file.toml   another parameter file than report/ruggiero2001.toml; relative to where you call make
#   CASES='cases/*.toml' J=2 KEYS='key …'   reports: the parameter files, how many at a time, what to compare
#   PAPER=file       check-report: the text of the paper, against which every quotation is held
#   MANIFEST=file    verify: compare with the manifest of a report made elsewhere instead of making it twice
#   ONLY=id          mutants: this one alone
#   NAME=name        figure: which
#   TARGET=name      why: another target, or a file that is built
#   STUDENT=id       handout: that student's own; needs the seed
#   SEED_FILE=file   handout, handouts, check-variants, grade, marking, results, release-feedback, gradescope: file of the seed
#   SEED=text        the same, on the command line, which everybody on the machine can read
#   UPDATE=1         handout: write to wrong_solutions.toml what the wrong solutions score, for review
#   ROSTER=file      handouts, check-variants, grade, results, release-feedback: who the students are; J=n of them at a time
#   SUBMISSIONS=dir  grade, likeness, marking, results, release-feedback: what they handed in
#   REGRADES=dir     grade, results, release-feedback: requests to mark a check again, and what came of them
#   MARKS=file       the same three: what persons gave for the report
#   CANVAS=file COLUMN=name   results: the gradebook that Canvas exported, and which of its columns gets the marks
#   PERCENT=50       likeness: how much of what one wrote a pair must have in common
#   NOMINAL=1        marking: the handouts had the nominal numbers
#   UNSAFE=1         grade, likeness, marking: without bubblewrap
#   N=300            check-variants: how many
#   TIMEOUT=seconds  how long the computation, gnuplot or LaTeX may take before they are stopped; TIMEOUT= for any time
#   V=1              show the commands

# The scripts read the paths and CALLER from the environment, because make would split paths at spaces.
export CASE CASES KEYS MANIFEST ONLY NAME TARGET V STUDENT SEED SEED_FILE UPDATE SUBMISSIONS ROSTER REGRADES MARKS PERCENT CANVAS COLUMN J N NOMINAL UNSAFE
# An exported variable that nobody has set would be empty, and an empty TIMEOUT lifts all limits.
ifneq ($(origin TIMEOUT),undefined)
export TIMEOUT
endif
export CALLER := $(value PWD)

# Messages, number formats and sorting are the same for everyone.
export LC_ALL := C

# Two targets at once would run Ninja twice in one folder. Ninja itself runs commands in parallel.
.NOTPARALLEL:
.DEFAULT_GOAL := report
targets = report halfspace reports html site figures figure check-report test test-all faults mutants bench peers verify fresh dist why watch \
  handout handouts check-variants grade likeness marking results release-feedback gradescope tidy format setup clean help
.PHONY: $(targets)

# Before anything is installed or made.
unknown := $(firstword $(filter-out $(targets),$(MAKECMDGOALS)))
$(if $(unknown),$(error there is no target $(unknown); 'make help' lists them))

report: ## the report, build/report/report.pdf
	@bash src/toolchain/build report

halfspace: ## the command line of the mechanics, build/release/halfspace
	@bash src/toolchain/build halfspace

reports: ## the report of each case in CASES, side by side: build/reports/cases.csv
	@bash src/toolchain/build reports

html: ## the report as one page, build/report/report.html (first: make setup html)
	@bash src/toolchain/build html

site: ## page, PDF, data and assignment sheet for any static host, build/report/site; SITE=https://… is its address
	@bash src/toolchain/build site

figures: ## its values, tables and figures only, build/report/generated; draws what changed
	@bash src/toolchain/build figures

figure: ## one figure to look at, build/figures/NAME.png
	@bash src/toolchain/build figure

check-report: ## its prose: unknown and unused names, typed numbers; and what does not hold
	@bash src/toolchain/build check-report

test: ## the everyday tests, which take a few minutes
	@bash src/toolchain/build test

test-all: ## every test, also those that take minutes each; continuous integration runs this
	@bash src/toolchain/build test-all

faults: ## breaks and interrupts the making of the report in every way known, and has the next make recover
	@bash src/toolchain/build faults

mutants: ## plants faults, each of which must turn a test or the report red
	@bash src/toolchain/build mutants

bench: ## benchmarks, results in build/bench/bench.json
	@bash src/toolchain/build bench

peers: ## what an author's edits cost here and with knitr (first: make setup peers)
	@bash src/toolchain/build peers

verify: ## makes the report again elsewhere and asks for the same bytes
	@bash src/toolchain/build verify

fresh: ## the README's two commands on the smallest Debian, made by mmdebstrap (as root; takes long)
	@bash src/toolchain/build fresh

dist: ## the document as arXiv and journals take it, build/dist/report.tar.gz
	@bash src/toolchain/build dist

why: ## why the report would be built again
	@bash src/toolchain/build why

watch: ## builds the report after each save, until Ctrl-C
	@bash src/toolchain/build watch

handout: ## the course assignment for students, proved: build/handout and build/handout.zip
	@bash src/toolchain/build handout

handouts: ## one for each student in ROSTER, with numbers of their own: build/handouts
	@bash src/toolchain/build handouts

check-variants: ## the instructor's solution on the variants of a class
	@bash src/toolchain/build check-variants

grade: ## marks and feedback for what is in SUBMISSIONS: build/grades
	@bash src/toolchain/build grade

likeness: ## which submissions have more in common than was given: build/likeness/pairs.csv
	@bash src/toolchain/build likeness

marking: ## for markers: the reports in SUBMISSIONS, typeset without names, and a form for the points: build/marking
	@bash src/toolchain/build marking

results: ## statistics of what make grade found, and the marks for Moodle and Canvas: build/results
	@bash src/toolchain/build results

release-feedback: ## a page for each student, which they may have: build/feedback
	@bash src/toolchain/build release-feedback

gradescope: ## the autograder for Gradescope, build/gradescope.zip
	@bash src/toolchain/build gradescope

tidy: ## clang-tidy on every source
	@bash src/toolchain/build tidy

format: ## clang-format on every source
	@bash src/toolchain/build format

setup: ## installs what the targets behind it lack, and they are made: make setup report, make setup test
	@sh src/toolchain/setup $(filter-out setup clean help,$(MAKECMDGOALS))

clean: ## remove everything built
	@bash src/toolchain/build clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' Makefile
	@awk '/^#   [A-Z]/ { sub(/^#  /, ""); print }' Makefile
