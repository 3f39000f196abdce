# SPDX-License-Identifier: GPL-3.0-or-later
# The front door. CMake (CMakePresets.json) and Ninja know what depends on what; here are only the names.
#
#   CASE=file.toml   another parameter file than report/ruggiero2001.toml; relative to where you call make
#   V=1              show the commands

# Paths never pass through make, which would split them at spaces: the scripts read CASE and CALLER.
export CASE V
export CALLER := $(value PWD)

# Messages, number formats and sorting are the same for everyone.
export LC_ALL := C

# Two targets at once would be two Ninjas in one folder; Ninja itself runs in parallel.
.NOTPARALLEL:
.DEFAULT_GOAL := report
.PHONY: report figures test bench tidy format setup clean help

report: ## the report, build/report/report.pdf
	@bash src/toolchain/build report

figures: ## its values, tables and figures only, build/report/generated
	@bash src/toolchain/build figures

test: ## every test
	@bash src/toolchain/build test

bench: ## benchmarks, results in build/bench/bench.json
	@bash src/toolchain/build bench

tidy: ## clang-tidy on every source
	@bash src/toolchain/build tidy

format: ## clang-format on every source
	@bash src/toolchain/build format

setup: ## install the Debian packages that are missing
	@sh src/toolchain/setup $(STAGES)

clean: ## remove everything built
	@rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  make %-9s %s\n", $$1, $$2 }' Makefile
	@awk '/^#   [A-Z]/ { sub(/^#  /, ""); print }' Makefile
