// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "holds.hpp"
#include "literate/document/names.hpp"
#include "numerics/estimate_algebra.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"

BOOST_AUTO_TEST_SUITE(main_test)

namespace fs = std::filesystem;

namespace {

// What a program answers: its exit code, and what it said on standard error.
struct Answer {
  int exit_code = 0;
  std::string errors;
};

// A paper with one excerpt, in a folder of its own.
class Workplace {
 public:
  Workplace() {
    fs::remove_all(folder_);
    sys::write_file_atomically(folder_ / "src/a.cpp",
                               "// begin excerpt: sum\nx += y;\n// end excerpt: sum\n");
    sys::write_file_atomically(folder_ / "paper/toy.tex", "It is \\val{sum}.\n\\excerpt{sum}\n");
    sys::write_file_atomically(folder_ / "case.toml", "");
    write_settings();
  }
  ~Workplace() { fs::remove_all(folder_); }

  void write_settings(const std::string& name = "toy",
                      const std::string& case_file = "case.toml") const {
    sys::write_file_atomically(path("toy.settings"),
                               "name=" + name + "\nroot=" + path() + "\ndocument=" + path("paper") +
                                   "\nmain=toy.tex\ncase=" + path(case_file) +
                                   "\nfigures=" + path("figures") + "\noutput=" + path() +
                                   "\nengine=" + path("engine") + "\n");
  }

  Answer run(std::vector<std::string> arguments, const literate::Compute& compute) const {
    arguments.insert(arguments.begin(), "toy_program");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const fs::path said = folder_ / "said";
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    std::FILE* file = std::fopen(said.c_str(), "w");
    ::dup2(::fileno(file), STDERR_FILENO);
    Answer answer;
    answer.exit_code =
        literate::main(static_cast<int>(arguments.size()), argv.data(), paper_, compute);
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    std::fclose(file);
    answer.errors = sys::read_file(said);
    return answer;
  }

  Answer stage(const std::string& name, const literate::Compute& compute) const {
    return run({name, path("toy.settings")}, compute);
  }
  Answer compute(const literate::Compute& what) const { return stage("compute", what); }
  void prose(const std::string& latex) const {
    sys::write_file_atomically(path("paper/toy.tex"), latex);
  }

  std::string path(const std::string& file = "") const { return (folder_ / file).string(); }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("literate main " + std::to_string(::getpid()));
  std::string record_ = literate::record_of({{"sum", "src/a.cpp", 2, "x += y;\n"}});
  literate::Paper paper_{.project = "toy",
                         .version = "1",
                         .compiler = "none",
                         .build_type = "none",
                         .flags = "",
                         .source_folders = {"src"},
                         .excerpts = record_};
};

void register_sum(literate::Document& document, const literate::Inputs&) {
  document.value("sum", literate::Value(3, literate::integer()));
}

void register_failed_check(literate::Document& document, const literate::Inputs&) {
  document.check("balance", false, "The forces balance.");
}
const std::string said_of_check = ": check balance failed: The forces balance.\n";

}  // namespace

BOOST_AUTO_TEST_CASE(compute_writes_what_was_registered) {
  const Workplace place;

  const Answer answer = place.compute(register_sum);

  BOOST_TEST(answer.exit_code == 0);
  BOOST_TEST(answer.errors == "");
  const auto names = literate::read_names(place.path("generated/names.json"));
  BOOST_TEST(names.values.contains("sum"));
  BOOST_TEST(names.excerpts.contains("sum"));
}

BOOST_AUTO_TEST_CASE(the_computation_gets_case_checkout_and_excerpts) {
  const Workplace place;

  place.compute([&](literate::Document&, const literate::Inputs& inputs) {
    BOOST_TEST(inputs.case_file == place.path("case.toml"));
    BOOST_TEST(inputs.source == place.path());
    BOOST_TEST(inputs.excerpts.size() == 1U);
  });
}

BOOST_AUTO_TEST_CASE(an_excerpt_that_was_not_compiled_is_bad_input_and_nothing_is_computed) {
  const Workplace place;
  sys::write_file_atomically(place.path("src/a.cpp"),
                             "// begin excerpt: sum\nx -= y;\n// end excerpt: sum\n");

  const Answer answer = place.compute([](literate::Document&, const literate::Inputs&) {
    BOOST_ERROR("computed beside a stale excerpt");
  });

  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(answer.errors.starts_with("toy: src/a.cpp: excerpt 'sum' is not what this program"));
}

BOOST_AUTO_TEST_CASE(a_check_that_fails_is_told_with_the_prose_and_ends_with_one) {
  const Workplace place;
  place.prose("Nothing.\n");

  const Answer computed = place.compute(register_failed_check);
  const Answer answer = place.stage("check", register_failed_check);

  BOOST_TEST(computed.exit_code == 0);
  BOOST_TEST(computed.errors == "");
  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(answer.errors.starts_with("toy: tests/literate/main/main_test.cpp:"), answer.errors);
  BOOST_TEST(answer.errors.ends_with(said_of_check), answer.errors);
}

BOOST_AUTO_TEST_CASE(each_kind_of_error_has_its_exit_code_and_one_line) {
  const Workplace place;
  const auto throwing = [&](auto error) {
    return place.compute([error](literate::Document&, const literate::Inputs&) { throw error; });
  };
  BOOST_TEST(throwing(std::runtime_error("odd")).exit_code == 1);
  BOOST_TEST(throwing(sys::ComputationError("no end")).exit_code == 1);
  BOOST_TEST(throwing(sys::InputError("case.toml:1:1: odd")).exit_code == 2);
  BOOST_TEST(throwing(sys::ToolError("gnuplot")).exit_code == 3);
  BOOST_TEST(throwing(sys::InputError("odd")).errors == "toy: odd\n");
}

BOOST_AUTO_TEST_CASE(what_stops_a_computation_is_told_with_how_far_all_came) {
  const Workplace place;
  const auto check = [&](const std::function<void(literate::Document&)>& stop, int exit_code,
                         const std::string& said) {
    const Answer answer =
        place.compute([&](literate::Document& document, const literate::Inputs& inputs) {
          register_sum(document, inputs);
          stop(document);
        });
    BOOST_TEST(answer.exit_code == exit_code);
    BOOST_TEST(answer.errors.starts_with("toy: " + said +
                                         "; the last thing registered was value 'sum' "
                                         "(tests/literate/main/main_test.cpp:"),
               answer.errors);
  };

  check([](auto&) { throw std::out_of_range("vector::at"); }, 1,
        "the computation failed: vector::at (std::out_of_range)");
  check(
      [](auto& document) {
        document.value("half", {1.5, literate::integer()});
      },
      2, "1.5 is not a whole number");
  check(
      [](auto&) {
        (void)(1 / numerics::Estimate{0, 1});
      },
      2, "divisor = 0: must be farther from 0 than its error, 1");
}

// In a process of its own, since it does not outlive it.
int status_of(const std::function<void()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    act();
    std::_Exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

BOOST_AUTO_TEST_CASE(a_computation_that_ends_the_program_by_exit_has_failed) {
  const Workplace place;

  const int status = status_of([&] {
    place.compute([](literate::Document& document, const literate::Inputs& inputs) {
      register_sum(document, inputs);
      std::exit(0);
    });
  });

  BOOST_TEST(WEXITSTATUS(status) == 1);
  const std::string said = sys::read_file(place.path("said"));
  BOOST_TEST(holds(said,
                   "the computation ended the program by exit(); the last thing registered was "
                   "value 'sum'"));
  BOOST_TEST(!fs::exists(place.path("generated/names.json")));
}

BOOST_AUTO_TEST_CASE(a_crash_is_told_with_how_far_all_came) {
  const Workplace place;

  const int status = status_of([&] {
    place.compute([](literate::Document& document, const literate::Inputs& inputs) {
      register_sum(document, inputs);
      ::raise(SIGSEGV);
    });
  });

  BOOST_TEST(WTERMSIG(status) == SIGSEGV);
  const std::string said = sys::read_file(place.path("said"));
  BOOST_TEST(holds(said,
                   "the computation crashed: SIGSEGV; the last thing registered was value "
                   "'sum' (tests/literate/main/main_test.cpp:"));
}

BOOST_AUTO_TEST_CASE(a_computation_that_does_not_end_is_stopped_when_its_time_is_over) {
  const Workplace place;

  const int status = status_of([&] {
    ::setenv("LITERATE_TIMEOUT", "1", 1);
    place.compute([](literate::Document& document, const literate::Inputs& inputs) {
      register_sum(document, inputs);
      ::sleep(20);
    });
  });

  BOOST_TEST(WEXITSTATUS(status) == 1);
  const std::string said = sys::read_file(place.path("said"));
  BOOST_TEST(said.starts_with("toy: the computation has not ended after 1 s and was stopped; the "
                              "last thing registered was value 'sum' ("),
             said);
}

BOOST_AUTO_TEST_CASE(a_case_from_a_pipe_is_read_once_and_kept_beside_the_output) {
  const Workplace place;
  BOOST_REQUIRE(::mkfifo(place.path("pipe").c_str(), 0600) == 0);
  place.write_settings("toy", "pipe");
  std::thread writer([&] { std::ofstream(place.path("pipe")) << "E = 31\n"; });

  std::string read;
  const Answer answer = place.compute([&](literate::Document&, const literate::Inputs& inputs) {
    read = sys::read_file(inputs.case_file);
  });
  writer.join();

  BOOST_TEST(answer.errors == "");
  BOOST_TEST(read == "E = 31\n");
  BOOST_TEST(literate::read_names(place.path("generated/names.json")).case_sha256 ==
             sys::sha256_of_text("E = 31\n"));
}

BOOST_AUTO_TEST_CASE(the_computation_is_told_which_paper_it_is_for) {
  const Workplace place;
  std::string paper;

  place.write_settings("slides");
  place.compute([&](literate::Document&, const literate::Inputs& inputs) { paper = inputs.paper; });

  BOOST_TEST(paper == "slides");
}

BOOST_AUTO_TEST_CASE(a_page_whose_check_failed_is_made_and_ends_with_one) {
  const Workplace place;
  place.compute(register_failed_check);
  place.prose("Text.\n");
  sys::write_file_atomically(place.path("html/page.html"), "<p>Text.</p>\n");
  sys::write_file_atomically(place.path("html/page.json"),
                             R"({"title": "A toy", "authors": [], "date": "", "description": ""})");
  sys::write_file_atomically(place.path("engine/page/page.css"), "");

  const Answer answer = place.stage("embed", register_failed_check);

  BOOST_TEST(fs::exists(place.path("toy.html")));
  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(answer.errors.ends_with(said_of_check), answer.errors);
}

BOOST_AUTO_TEST_CASE(typeset_looks_names_up_before_latex_starts) {
  const Workplace place;
  place.compute(register_sum);
  place.stage("draw", register_sum);
  place.prose("It is \\val{sun}.\n");

  const Answer answer = place.stage("typeset", register_sum);

  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(answer.errors == "toy: paper/toy.tex:1:7: unknown value 'sun', did you mean 'sum'?\n");
  BOOST_TEST(!fs::exists(place.path("latex")));
}

BOOST_AUTO_TEST_CASE(typeset_tells_what_does_not_hold_with_every_name_that_is_not_known) {
  const Workplace place;
  place.compute(register_failed_check);
  place.stage("draw", register_failed_check);
  place.prose("It is \\val{sun} and \\val{moon}.\n");

  const Answer answer = place.stage("typeset", register_failed_check);

  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(holds(answer.errors, "paper/toy.tex:1:7: unknown value 'sun'"));
  BOOST_TEST(holds(answer.errors, "paper/toy.tex:1:21: unknown value 'moon'"));
  BOOST_TEST(answer.errors.ends_with(said_of_check), answer.errors);
}

BOOST_AUTO_TEST_CASE(check_passes_prose_that_uses_all_and_types_nothing) {
  const Workplace place;
  place.compute(register_sum);

  const Answer answer = place.stage("check", register_sum);

  BOOST_TEST(answer.exit_code == 0);
  BOOST_TEST(answer.errors == "");
}

BOOST_AUTO_TEST_CASE(check_fails_prose_that_leaves_a_value_out) {
  const Workplace place;
  place.compute(register_sum);
  place.prose("Nothing.\n");

  const Answer answer = place.stage("check", register_sum);

  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(answer.errors.starts_with("toy: tests/literate/main/main_test.cpp:"), answer.errors);
  BOOST_TEST(answer.errors.ends_with(": value 'sum' is registered and not used\n"), answer.errors);
}

BOOST_AUTO_TEST_CASE(check_names_an_input_that_git_ignores) {
  const Workplace place;
  place.compute(register_sum);
  const auto git = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"-c", "user.name=t", "-c", "user.email=t@example.org"});
    const auto said =
        sys::run({.program = "git", .arguments = arguments, .working_directory = place.path()});
    BOOST_TEST_REQUIRE(said.exit_status == 0, said.output);
  };
  sys::write_file_atomically(place.path("data.csv"), "1\n");
  sys::write_file_atomically(
      place.path("manifest.json"),
      R"({"project": "toy", "made_with": {}, "inputs": {"data.csv": "d", "case.toml": "e"},
          "outputs": {}, "numbers": {}, "verdicts": {}})");
  git({"init", "-q"});
  git({"add", "case.toml", "data.csv"});
  git({"commit", "-qm", "all"});
  const Answer with_all = place.stage("check", register_sum);

  sys::write_file_atomically(place.path(".gitignore"), "data.csv\n");
  git({"rm", "-q", "--cached", "data.csv"});
  const Answer answer = place.stage("check", register_sum);

  BOOST_TEST(with_all.exit_code == 0, with_all.errors);
  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(holds(answer.errors, "data.csv: git ignores this file, so that no commit has it"));
}

BOOST_AUTO_TEST_CASE(check_tells_what_it_cannot_know_without_git_and_a_record_of_other_results) {
  const Workplace place;
  place.compute(register_sum);

  const Answer recorded =
      place.run({"check", place.path("toy.settings"), "--record"}, register_sum);
  std::string record = sys::read_file(place.path("paper/results.json"));
  record.replace(record.find("\"sum\"") + 1, 3, "old");
  sys::write_file_atomically(place.path("paper/results.json"), record);
  const Answer stale = place.stage("check", register_sum);
  record.insert(record.find("\"name\": \"") + 9, "other-");
  sys::write_file_atomically(place.path("paper/results.json"), record);
  const Answer of_another_case = place.stage("check", register_sum);

  BOOST_TEST(recorded.exit_code == 2);
  BOOST_TEST(holds(recorded.errors, "not known: it is no git repository with a commit"));
  BOOST_TEST(holds(stale.errors, "results.json is not of these results, value sum is another"));
  BOOST_TEST(of_another_case.errors == "");
}

BOOST_AUTO_TEST_CASE(a_wrong_command_line_is_bad_input) {
  const Workplace place;
  BOOST_TEST(place.run({}, register_sum).exit_code == 2);
  BOOST_TEST(place.run({"paint"}, register_sum).exit_code == 2);
  BOOST_TEST(place.run({"compute"}, register_sum).errors.starts_with("toy: SETTINGS is required"));
}

BOOST_AUTO_TEST_CASE(settings_that_are_wrong_are_told_by_file_and_name) {
  const Workplace place;
  const std::string file = place.path("toy.settings");
  const std::string right = sys::read_file(file);
  const auto said = [&](const std::string& text) {
    sys::write_file_atomically(file, text);
    const Answer answer = place.compute(register_sum);
    BOOST_TEST(answer.exit_code == 2);
    return answer.errors;
  };

  BOOST_TEST(said("name=toy\n") == "toy: " + file + ": the setting 'root' is missing\n");
  BOOST_TEST(said("name=toy\nroot\n") == "toy: " + file + ":2: 'root' is no setting name=value\n");
  BOOST_TEST(said(right + "latex=troff\n") ==
             "toy: " + file + ": the setting 'latex' is 'troff', not pdflatex or lualatex\n");
  fs::remove(file);
  BOOST_TEST(holds(place.compute(register_sum).errors, file));
}

BOOST_AUTO_TEST_CASE(the_version_names_the_paper_and_its_commit) {
  const literate::Paper paper{.project = "rod", .version = "1.2.0"};
  literate::Repository repository{.commit = "0123456789ab"};
  BOOST_TEST(literate::version_text(paper, repository) == "rod 1.2.0 (commit 0123456789ab)");
  repository.modified = true;
  BOOST_TEST(literate::version_text(paper, repository) ==
             "rod 1.2.0 (commit 0123456789ab, modified)");
  BOOST_TEST(literate::version_text(paper) == "rod 1.2.0 (commit unknown)");
}

BOOST_AUTO_TEST_CASE(a_case_that_is_saved_while_it_is_computed_from_is_computed_again) {
  const Workplace place;
  int n_runs = 0;

  const Answer answer =
      place.compute([&](literate::Document& document, const literate::Inputs& inputs) {
        const std::string read = sys::read_file(inputs.case_file);
        if (++n_runs == 1) sys::write_file_atomically(inputs.case_file, "E = 31\n");
        document.value("sum", literate::Value::text(read.empty() ? "old" : "new"));
      });

  BOOST_TEST(answer.exit_code == 0);
  BOOST_TEST(n_runs == 2);
  BOOST_TEST(holds(answer.errors, "was saved while it was computed from"));
  const auto names = literate::read_names(place.path("generated/names.json"));
  BOOST_TEST(names.case_sha256 == sys::sha256_of_text("E = 31\n"));
  const std::string values = sys::read_file(place.path("generated/values.tex"));
  BOOST_TEST(holds(values, "new"));
  BOOST_TEST(holds(values, "\\renewcommand*\\papercase{"));
}

BOOST_AUTO_TEST_CASE(a_case_that_never_rests_is_bad_input) {
  const Workplace place;
  int n_runs = 0;

  const Answer answer = place.compute([&](literate::Document&, const literate::Inputs& inputs) {
    sys::write_file_atomically(inputs.case_file, std::to_string(++n_runs));
  });

  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(holds(answer.errors, "was saved 5 times while it was computed from"));
}

BOOST_AUTO_TEST_CASE(the_record_names_the_case_and_the_program_and_is_there_only_when_all_is_done) {
  const Workplace place;

  BOOST_TEST(place.compute(register_sum).exit_code == 0);
  const std::string record = sys::read_file(place.path("state/compute"));
  BOOST_TEST(holds(record, sys::sha256_of_text("") + "  " + place.path("case.toml")));
  BOOST_TEST(holds(record, "literate_tests\n"));
  BOOST_TEST(record.ends_with("# done\n"));

  const Answer failed = place.compute([](literate::Document&, const literate::Inputs&) {
    throw sys::ComputationError("no digit is sure");
  });
  BOOST_TEST(failed.exit_code == 1);
  BOOST_TEST(!fs::exists(place.path("state/compute")));
  BOOST_TEST(sys::read_file(place.path("state/compute.unfinished")) == "failed\n");
}

BOOST_AUTO_TEST_SUITE_END()
