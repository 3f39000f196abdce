// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/gnuplot.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(gnuplot_test)

using namespace literate;

namespace {

std::string refusal_of(const std::string& script) {
  return message_of<sys::InputError>([&] { require_draws_only(script, "figures/f.gp"); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_command_by_which_a_script_would_do_more_than_draw_is_refused_at_its_line) {
  for (const std::string command :
       {"set output 'x'", "set out", "set terminal png", "set term x11", "set print 'x'",
        "set table 'x'", "save 'x'", "system 'ls'", "!ls", "load 'x'", "call 'x'", "cd '..'",
        "a = 1; set output 'x'", "a = system('ls')", "a = `ls`"}) {
    BOOST_TEST(refusal_of("set grid\n" + command + "\n").starts_with("figures/f.gp:2: "), command);
  }
}

BOOST_AUTO_TEST_CASE(what_only_looks_like_such_a_command_is_left_alone) {
  for (const std::string command :
       {"plot f title 'fitted load'", "# set output 'x'", "set tics out nomirror",
        "set tics nomirror out scale 0.6", "set table $contours separator comma",
        "set key outside right", "loads = 2"}) {
    BOOST_TEST(refusal_of(command) == "(no error)", command);
  }
}

BOOST_AUTO_TEST_CASE(data_are_plotted_by_their_names_and_not_from_files) {
  for (const std::string command :
       {"plot 'x.csv' using 1:2", "plot \\\n  \"x.csv\"", "splot [0:1] [0:2] 'x'", "p 'x' w l",
        "plot periods using 1:2, \\\n  '/tmp/x.csv' using 1:2 title 'x'", "stats 'x.csv'",
        "set grid; plot for [i=1:2] 'x' using 1:i", "plot f(x), 'x' with lines",
        "plot f, 'x', g"}) {
    const std::string said = refusal_of("set grid\n" + command + "\n");
    BOOST_TEST(said.starts_with("figures/f.gp:2: "), command << ": " << said);
    BOOST_TEST(holds(said, "is plotted from a file"));
  }
  for (const std::string command :
       {"plot periods using \"angle\":\"integral\" with lines title 'a, b', g(x) title \"c\"",
        "plot '+' using 1:(f($1))", "splot '++' using 1:2:3", "plot d using 1:2, '' using 1:3",
        "plot x title sprintf('%g', 2)", "set label 'a', 'b' with", "print 'x'",
        "plot d using (column('x')):(strcol('y')) title 'x'"}) {
    BOOST_TEST(refusal_of(command) == "(no error)", command);
  }
}

BOOST_AUTO_TEST_CASE(a_command_of_several_lines_is_told_at_its_first) {
  const TemporaryFolder scratch;
  scratch.write("script.gp", "set grid\nplot x, \\\n  y \\\n  with linse\nset tics\n");
  const auto told = [&](const std::string& line) {
    return message_of<sys::ToolError>([&] {
      require_drawn_well({"f", scratch.path(), "figures", "src/a.cpp:3"},
                         {1, "\"script.gp\" line " + line + ": unrecognized plot type"});
    });
  };

  BOOST_TEST(told("4").starts_with("figures/f.gp:2: gnuplot: unrecognized plot type"), told("4"));
  BOOST_TEST(told("5").starts_with("figures/f.gp:5: "), told("5"));
}

namespace {

/// What is said of a figure whose drawing has these bytes.
std::string refusal_of_drawing(const std::string& pdf, const std::string& tex,
                               const sys::ProcessResult& result = {}) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "f.gp", "");
  sys::write_file_atomically(scratch / "f.pdf", pdf);
  sys::write_file_atomically(scratch / "f.tex", tex);
  return message_of<sys::ToolError>([&] {
    require_drawn_well({"f", scratch.path(), "figures", "src/a.cpp:3"}, result);
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(half_a_drawing_is_refused_although_gnuplot_said_nothing) {
  const std::string pdf = "%PDF-1.5\n…\n%%EOF\n";
  const std::string tex = "\\begingroup\n\\endgroup\n";

  BOOST_TEST(refusal_of_drawing(pdf, tex) == "(no error)");
  for (const std::string half : {"%PDF-1.5\n…", "…\n%%EOF\n"}) {
    BOOST_TEST(refusal_of_drawing(half, tex).starts_with(
        "figures/f.gp: gnuplot ended without an error, but f.pdf is not whole"));
  }
  BOOST_TEST(holds(refusal_of_drawing(pdf, "\\begingroup\n"), "f.tex is not whole"));
}

BOOST_AUTO_TEST_CASE(a_gnuplot_that_fails_without_a_word_is_told_by_its_status_or_signal) {
  BOOST_TEST(refusal_of_drawing("", "", {3, ""}) ==
             "figures/f.gp: gnuplot ended with status 3 and said nothing (figure 'f' is registered "
             "at src/a.cpp:3)");
  BOOST_TEST(holds(refusal_of_drawing("", "", {137, ""}), "signal 9 (Killed)"));
}

BOOST_AUTO_TEST_SUITE_END()
