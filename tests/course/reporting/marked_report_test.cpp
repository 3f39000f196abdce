// SPDX-License-Identifier: GPL-3.0-or-later
// Typesets reports that are honest, broken or mean harm: those in tests/course/hostile_reports, and
// others that cannot be kept as files.
#include "course/reporting/marked_report.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "message_of.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

BOOST_AUTO_TEST_SUITE(marked_report_test, *boost::unit_test::fixture(&need_walls_and_tex))

using namespace course;
namespace fs = std::filesystem;

namespace {

const fs::path fixtures = fs::path(HALFSPACE_SOURCE_DIR) / "tests/course/hostile_reports";

Assignment assignment() {
  Assignment toy = toy_grading::assignment();
  toy.quantities = {{.name = "side", .unit = "m", .from = 3, .to = 9, .step = 1, .nominal = 3}};
  toy.limits.report_seconds = 4;
  return toy;
}

Variant variant_of_side(double side) {
  Variant variant = nominal_variant(assignment());
  variant.quantities["side"] = side;
  return variant;
}

std::string handout_report() {
  return sys::read_file(toy_grading::folder / "template/report/report.tex");
}

/// A folder in which everybody may write, whose path has no blank, at which TeX and shells would
/// stop.
class OpenFolder {
 public:
  explicit OpenFolder(const std::string& name)
      : path_(fs::temp_directory_path() / fmt::format("{}-{}", name, ::getpid())) {
    fs::create_directory(path_);
    fs::permissions(path_, fs::perms::all);
  }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  ~OpenFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Submissions, and what is made of them for markers.
class Marking {
 public:
  explicit Marking(Isolation isolation = Isolation::sandbox)
      : isolation_(isolation), typesetting_(assignment(), work_.path(), isolation) {}

  /// A new submission with the right solution and this report.
  fs::path submission(const std::string& name, const std::string& report) const {
    Files files = toy_grading::solution();
    files["report/report.tex"] = report;
    return toy_grading::write(made_, name, files);
  }

  Files marked(const fs::path& submission, double side = 3) const {
    const TemporaryFolder scratch;
    fs::permissions(scratch.path(), fs::perms::others_exec | fs::perms::group_exec,
                    fs::perm_options::add);
    for (const char* part : {"report", "exercises", "making"}) {
      fs::create_directory(scratch.path() / part);
    }
    const ReportTask task{
        .report = take_report(assignment(), submission, scratch.path() / "report", isolation_),
        .exercises =
            take_submission(assignment(), submission, scratch.path() / "exercises", isolation_)
                .files,
        .variant = variant_of_side(side),
        .toolkit = toy_grading::toolkit(),
        .isolation = isolation_};
    return marked_report(assignment(), typesetting_, task, scratch.path() / "making");
  }

  /// What is found in such a submission.
  std::string findings(const std::string& name, const std::string& report) const {
    return marked(submission(name, report)).at("findings.txt");
  }

  const TemporaryFolder& made() const { return made_; }

 private:
  Isolation isolation_;
  TemporaryFolder made_, work_;
  ReportTypesetting typesetting_;
};

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// What findings.txt must say of each hostile report, and typeset.log besides.
struct Expected {
  std::string finding, log;
  bool has_pdf = false;
};

const std::map<std::string, Expected> hostile = {
    {"dumps_the_checkout", {"LICENSE", ""}},
    {"floods_pages", {"report/report.tex: LaTeX writes a file of more than 1 MB", ""}},
    {"floods_the_log", {"report/report.tex: LaTeX writes a file of more than 1 MB", ""}},
    {"forges_its_pdf", {"report/report.tex: LaTeX does not say that it wrote a page", ""}},
    {"has_no_end", {"the document ends without \\end{document}", ""}},
    {"hides_its_errors", {"report/report.tex:4: Undefined control sequence.", ""}},
    {"hides_its_log", {"report/report.tex: LaTeX met errors that its log does not hold", "", true}},
    {"memory_bomb", {"TeX capacity exceeded", ""}},
    {"never_ends", {"report/report.tex: two passes of LaTeX take longer than 4 s", ""}},
    {"reads_from_the_shell", {"not found", ""}},
    {"reads_hidden_checks", {"toy_grading.hpp' not found", "nothing to read"}},
    {"reads_its_neighbour", {"report.tex' not found", ""}},
    {"reads_passwords", {"`/etc/passwd.tex' not found", "nothing to read"}},
    {"waits_for_an_answer", {"report/report.tex:", ""}},
    {"wants_a_package",
     {"report/report.tex:3: LaTeX Error: File `no-such-package-of-anybody.sty' "
      "not found",
      ""}},
    {"writes_elsewhere", {"report/report.tex:4", ""}},
    {"writes_other_numbers", {"report/report.tex:4", ""}},
    {"writes_to_the_shell", {"", "runsystem(echo written >", true}},
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_report_is_typeset_with_the_numbers_of_the_students_own_functions) {
  const Marking marking;
  const fs::path alice = marking.submission("alice", handout_report());

  const Files files = marking.marked(alice);

  BOOST_TEST(files.at("findings.txt") == "");
  BOOST_TEST(files.at("numbers.tex") == "\\newcommand*\\area{9\\,m$^2$}\n");
  BOOST_TEST(files.at("report.tex") == handout_report());
  BOOST_TEST(files.at("typeset.pdf").starts_with("%PDF"));
  BOOST_TEST(holds(files.at("typeset.log"), "generated/square.pdf"));
  BOOST_TEST(marking.marked(alice, 4).at("numbers.tex") == "\\newcommand*\\area{16\\,m$^2$}\n");
}

BOOST_AUTO_TEST_CASE(the_same_submission_gives_the_same_bytes_and_the_pdf_names_no_folder) {
  const Marking marking;
  const Files first = marking.marked(marking.submission("alice", handout_report()));
  const Marking other;
  const Files second = other.marked(other.submission("bob", handout_report()));

  BOOST_TEST(first.size() == 5U);
  for (const auto& [name, bytes] : first) BOOST_TEST((bytes == second.at(name)), name);
  for (const auto& [name, bytes] : first) {
    for (const char* word : {"alice", "/tmp/halfspace", "/work"}) {
      BOOST_TEST(!holds(bytes, word), name << " holds " << word);
    }
  }
}

BOOST_AUTO_TEST_CASE(chance_and_time_give_the_same_bytes_or_are_told) {
  const Marking marking;
  const std::string chance = replaced(handout_report(), "\\area{}", "\\pdfuniformdeviate 1000000 ");
  const fs::path finn = marking.submission("finn", chance);
  BOOST_TEST((marking.marked(finn).at("typeset.pdf") == marking.marked(finn).at("typeset.pdf")));

  marking.made().write("finn/src/square.cpp",
                       "#include <ctime>\n#include \"toy.hpp\"\n"
                       "double square(double x) {\n  timespec now{};\n"
                       "  clock_gettime(CLOCK_MONOTONIC, &now);\n"
                       "  return x * x + now.tv_nsec;\n}\n");
  const std::string findings = marking.marked(finn).at("findings.txt");
  BOOST_TEST(holds(findings, "report/figures.cpp: generated/numbers.tex differs from run to run\n"),
             findings);
}

BOOST_AUTO_TEST_CASE(a_function_that_does_not_compile_or_never_ends_is_told) {
  const Marking marking;
  marking.submission("carl", handout_report());
  const fs::path carl = marking.made().write("carl/src/square.cpp", "double square = nothing;\n");
  const std::string wrong = marking.marked(carl.parent_path().parent_path()).at("findings.txt");
  BOOST_TEST(holds(wrong, "square: src/square.cpp:1:17: error: 'nothing' was not declared"), wrong);

  marking.made().write("carl/src/square.cpp", "double square(double) { for (;;) {} }\n");
  const Files endless = marking.marked(marking.made().path() / "carl");
  BOOST_TEST(holds(endless.at("findings.txt"), "there are no numbers: it took longer than 4 s"),
             endless.at("findings.txt"));
  BOOST_TEST(!endless.contains("numbers.tex"));
}

BOOST_AUTO_TEST_CASE(no_hostile_report_reads_writes_outlasts_or_hinders_anything) {
  const Marking marking;
  const OpenFolder forbidden("forbidden"), neighbours("neighbours");
  sys::write_file_atomically(neighbours.path() / "report/report.tex",
                             "\\typeout{read: the neighbour}\n");
  make_readable(neighbours.path());
  std::set<std::string> tried;
  for (const auto& entry : fs::directory_iterator(fixtures)) {
    const std::string name = entry.path().stem();
    tried.insert(name);
    BOOST_REQUIRE_MESSAGE(hostile.contains(name), name << " is not expected");
    std::string report =
        replaced(sys::read_file(entry.path()), "@FORBIDDEN@", forbidden.path().string());
    report = replaced(report, "@NEIGHBOUR@", neighbours.path().string());
    report = replaced(report, "@SOURCE@", HALFSPACE_SOURCE_DIR);
    report = replaced(report, "@LONG@", std::string(900, 'x'));

    const Files files = marking.marked(marking.submission(name, report));

    const Expected& expected = hostile.at(name);
    const std::string& findings = files.at("findings.txt");
    const std::string& log = files.at("typeset.log");
    BOOST_TEST_MESSAGE(name << ": " << findings);
    BOOST_TEST(holds(findings, expected.finding), name << ": " << findings << log);
    BOOST_TEST(holds(log, expected.log), name << ": " << log);
    BOOST_TEST(files.contains("typeset.pdf") == expected.has_pdf, name);
    for (const auto& [file, bytes] : files) {
      if (file == "report.tex") continue;
      for (const char* secret : {"read: ", "root:", "sum: ", "the area is 7"}) {
        const bool is_of_nothing = holds(bytes, "read: ^^M") || holds(bytes, "read: \n");
        BOOST_TEST((!holds(bytes, secret) || is_of_nothing), name << "/" << file << ": " << bytes);
      }
    }
    BOOST_TEST(fs::is_empty(forbidden.path()), name);
  }
  BOOST_TEST(tried.size() == hostile.size());
  BOOST_TEST(marking.findings("after_all", handout_report()) == "");
}

BOOST_AUTO_TEST_CASE(a_report_that_is_no_file_of_text_is_told_and_not_typeset) {
  const Marking marking;
  const fs::path folder = marking.submission("odd", "");
  const fs::path report = folder / "report/report.tex";
  const auto says = [&](const std::string& words) {
    const Files files = marking.marked(folder);
    BOOST_TEST(files.at("findings.txt") == "report/report.tex " + words + "\n");
    BOOST_TEST(!files.contains("typeset.pdf"));
  };
  says("is empty");
  sys::write_file_atomically(report, std::string("a\0b", 3));
  says("is no text in UTF-8: byte 2 is zero");
  sys::write_file_atomically(report, std::string(65 * 1024, 'x'));
  says("is larger than 64 kB");
  fs::remove(report);
  fs::create_symlink("/etc/passwd", report);
  says("is a symbolic link, or lies behind one");
  fs::remove(report);
  BOOST_REQUIRE(::mkfifo(report.c_str(), 0600) == 0);
  says("is a pipe, not a file");
  fs::remove(report);
  if (::mknod(report.c_str(), S_IFCHR | 0666, makedev(1, 5)) == 0) {  // only root can make one
    says("is a device, not a file");
    fs::remove(report);
  }
  fs::create_directory(report);
  says("is a folder, not a file");
}

BOOST_AUTO_TEST_CASE(no_text_holds_up_the_checks_of_this_program) {
  const Marking marking;
  for (const std::string part : {"\\cite{", "% constant ", "1 ", "0.1234 ", "\\newcommand{"}) {
    std::string report = "\\documentclass{article}\\begin{document}";
    while (report.size() < 60U * 1024) report += part;
    const std::string findings = marking.findings("long", report);
    BOOST_TEST(findings != "", part);
  }
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_utf8_are_told_with_their_place) {
  const Marking marking;

  const std::string findings =
      marking.findings("latin1", replaced(handout_report(), "The area", "M\xfcller's area"));

  BOOST_TEST(holds(findings, "report/report.tex:6:2: this is no UTF-8\n"), findings);
  BOOST_TEST(holds(findings, "report/report.tex:6"), findings);
}

BOOST_AUTO_TEST_CASE(the_handouts_scripts_draw_whatever_was_handed_in_or_computed) {
  const Marking marking;
  const OpenFolder forbidden("forbidden");
  const std::string touch = "touch " + forbidden.path().string() + "/drawn";
  const fs::path dora = marking.submission("dora", handout_report());
  marking.made().write("dora/report/square.gp", "system \"" + touch + "\"\n");
  marking.made().write("dora/report/figures.cpp", "int main() {}\n");
  // What is left of the program writes among its data when it ends.
  marking.made().write("dora/src/square.cpp",
                       "#include <fstream>\n#include \"toy.hpp\"\n"
                       "struct Last {\n  ~Last() {\n"
                       "    std::ofstream(\"/tmp/generated/square.dat\")\n"
                       "        << \"`" +
                           touch + "`\\n\" << \"< " + touch +
                           "\\n\"\n"
                           "        << \"@system('" +
                           touch +
                           "')\\n1 2\\n2 3\\n\";\n"
                           "    std::ofstream(\"/tmp/generated/square.gp\") << \"system '" +
                           touch +
                           "'\\n\";\n"
                           "  }\n} last;\n"
                           "double square(double x) { return x * x; }\n");

  const Files files = marking.marked(dora);

  BOOST_TEST(fs::is_empty(forbidden.path()));
  BOOST_TEST(holds(files.at("findings.txt"), "report/square.gp: it draws nothing: "),
             files.at("findings.txt"));  // since such lines are no numbers
  BOOST_TEST(files.at("numbers.tex") == "\\newcommand*\\area{9\\,m$^2$}\n");
}

BOOST_AUTO_TEST_CASE(files_that_a_program_leaves_are_read_as_a_submission_is) {
  const Marking marking;
  const fs::path eve = marking.submission("eve", handout_report());
  const auto leaves = [&](const std::string& statement) {
    marking.made().write(
        "eve/src/square.cpp",
        "#include <fcntl.h>\n#include <unistd.h>\n#include <cstdlib>\n#include <string>\n"
        "#include \"toy.hpp\"\n"
        "struct Last {\n  ~Last() { " +
            statement +
            "; }\n} last;\n"
            "double square(double x) { return x * x; }\n");
    return marking.marked(eve);
  };

  const Files link = leaves(
      "unlink(\"/tmp/generated/numbers.tex\"); "
      "symlink(\"/etc/passwd\", \"/tmp/generated/numbers.tex\")");
  BOOST_TEST(holds(link.at("findings.txt"), "generated/numbers.tex is empty, a link, or no file"),
             link.at("findings.txt"));
  BOOST_TEST(!link.contains("numbers.tex"));

  const Files large = leaves("truncate(\"/tmp/generated/numbers.tex\", 4000000)");
  BOOST_TEST(holds(large.at("findings.txt"), "report/figures.cpp: "), large.at("findings.txt"));
  BOOST_TEST(!large.contains("numbers.tex"));

  const Files long_name = leaves(
      "close(creat((\"/tmp/generated/\" + std::string(250, 'x') + \".dat\").c_str(), 0600))");
  BOOST_TEST(long_name.at("findings.txt") == "");

  const Files holes = leaves(
      "for (const char* file : {\"/tmp/generated/a.dat\", \"/tmp/generated/b.dat\"}) "
      "if (const int d = creat(file, 0600); d >= 0) pwrite(d, \"x\", 1, 900000)");
  BOOST_TEST(holds(holes.at("findings.txt"), "report/figures.cpp: its files hold more than 1 MB"),
             holes.at("findings.txt"));

  const Files none = leaves("unlink(\"/tmp/generated/numbers.tex\")");
  BOOST_TEST(holds(none.at("findings.txt"), "report/figures.cpp: there is no numbers.tex"),
             none.at("findings.txt"));

  const Files flood = leaves("std::system(\"yes >/tmp/generated/more.dat\")");
  BOOST_TEST(holds(flood.at("findings.txt"), "report/figures.cpp: "), flood.at("findings.txt"));
}

BOOST_AUTO_TEST_CASE(without_walls_too_latex_neither_writes_nor_reads_by_absolute_paths) {
  const Marking marking(Isolation::none);
  BOOST_TEST(marking.findings("honest", handout_report()) == "");

  const std::string read =
      marking.findings("reads", sys::read_file(fixtures / "reads_passwords.tex"));
  BOOST_TEST(holds(read, "`/etc/passwd.tex' not found"), read);

  const OpenFolder forbidden("forbidden");
  marking.findings("writes", replaced(sys::read_file(fixtures / "writes_elsewhere.tex"),
                                      "@FORBIDDEN@", forbidden.path().string()));
  marking.findings("runs", replaced(sys::read_file(fixtures / "writes_to_the_shell.tex"),
                                    "@FORBIDDEN@", forbidden.path().string()));
  BOOST_TEST(fs::is_empty(forbidden.path()));
}

BOOST_AUTO_TEST_CASE(a_machine_without_tex_is_told_as_such) {
  const TemporaryFolder work;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", work.path().c_str(), 1);
  BOOST_CHECK_THROW(ReportTypesetting(assignment(), work.path(), Isolation::none), sys::ToolError);
  ::setenv("PATH", path.c_str(), 1);
}

BOOST_AUTO_TEST_CASE(names_of_reports_do_not_tell_the_student) {
  const auto names = course::anonymous_names({"alice", "bob"}, "autumn 27");

  BOOST_TEST(names.at("alice").starts_with("report-"));
  BOOST_TEST(names.at("alice").size() == 17U);
  BOOST_TEST(names.at("alice") != names.at("bob"));
  BOOST_TEST(names.at("alice") != course::anonymous_names({"alice"}, "autumn 28").at("alice"));
}

BOOST_AUTO_TEST_SUITE_END()
