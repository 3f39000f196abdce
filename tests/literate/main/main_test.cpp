// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "literate/document/names.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

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
  }
  ~Workplace() { fs::remove_all(folder_); }

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

  Answer compute(const literate::Compute& compute) const {
    return run(
        {"compute", "--case", path("case.toml"), "--source", path(), "--output", path("generated")},
        compute);
  }
  Answer check(const literate::Compute& compute) const {
    return run({"check", "--document", path("paper"), "--generated", path("generated")}, compute);
  }
  Answer typeset(const literate::Compute& compute) const {
    return run({"typeset", "--document", path("paper"), "--generated", path("generated"), "--build",
                path("latex"), "--output", path("toy.pdf")},
               compute);
  }

  std::string path(const std::string& file = "") const { return (folder_ / file).string(); }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("literate main " + std::to_string(::getpid()));
  std::string hash_ = sys::sha256_of_text("x += y;\n");
  literate::Paper paper_{.project = "toy",
                         .version = "1",
                         .compiler = "none",
                         .build_type = "none",
                         .flags = "",
                         .main_file = "toy.tex",
                         .source_folders = {"src"},
                         .excerpts = {{"sum", "src/a.cpp", hash_}}};
};

void register_sum(literate::Document& document, const literate::Inputs&) {
  document.value("sum", literate::Value(3, literate::integer()));
}

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

BOOST_AUTO_TEST_CASE(a_check_that_fails_is_told_and_ends_with_one) {
  const Workplace place;

  const Answer answer = place.compute([](literate::Document& document, const literate::Inputs&) {
    document.check("balance", false, "The forces balance.");
  });

  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(answer.errors.starts_with("toy: tests/literate/main/main_test.cpp:"), answer.errors);
  BOOST_TEST(answer.errors.ends_with(": check balance failed: The forces balance.\n"),
             answer.errors);
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

BOOST_AUTO_TEST_CASE(typeset_looks_names_up_before_latex_starts) {
  const Workplace place;
  place.compute(register_sum);
  sys::write_file_atomically(place.path("paper/toy.tex"), "It is \\val{sun}.\n");

  const Answer answer = place.typeset(register_sum);

  BOOST_TEST(answer.exit_code == 2);
  BOOST_TEST(answer.errors == "toy: paper/toy.tex:1:7: unknown value 'sun', did you mean 'sum'?\n");
  BOOST_TEST(!fs::exists(place.path("latex")));
}

BOOST_AUTO_TEST_CASE(check_passes_prose_that_uses_all_and_types_nothing) {
  const Workplace place;
  place.compute(register_sum);

  const Answer answer = place.check(register_sum);

  BOOST_TEST(answer.exit_code == 0);
  BOOST_TEST(answer.errors == "");
}

BOOST_AUTO_TEST_CASE(check_fails_prose_that_leaves_a_value_out) {
  const Workplace place;
  place.compute(register_sum);
  sys::write_file_atomically(place.path("paper/toy.tex"), "Nothing.\n");

  const Answer answer = place.check(register_sum);

  BOOST_TEST(answer.exit_code == 1);
  BOOST_TEST(answer.errors.starts_with("toy: tests/literate/main/main_test.cpp:"), answer.errors);
  BOOST_TEST(answer.errors.ends_with(": value 'sum' is registered and not used\n"), answer.errors);
}

BOOST_AUTO_TEST_CASE(a_wrong_command_line_is_bad_input) {
  const Workplace place;
  BOOST_TEST(place.run({}, register_sum).exit_code == 2);
  BOOST_TEST(place.run({"paint"}, register_sum).exit_code == 2);
  BOOST_TEST(place.run({"compute"}, register_sum).errors.starts_with("toy: --case is required"));
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

BOOST_AUTO_TEST_SUITE_END()
