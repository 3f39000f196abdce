// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/draw.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(draw_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

const std::vector<double> x{0, 0.1, 1.0 / 3};
const std::string curve_script = "plot curve using \"x\":\"y\" with lines\n";

// A document of figures, with their scripts beside it.
class Workplace {
 public:
  /// With these figures, each of which shows the curve.
  explicit Workplace(const std::vector<std::string>& names = {}) {
    script("style", "set border 3\n");
    for (const std::string& name : names) {
      figure(name);
      script(name, curve_script);
    }
  }

  fs::path file(const std::string& name) const { return scratch_ / name; }
  fs::path generated() const { return scratch_ / "out"; }
  fs::path drawn(const std::string& file) const { return generated() / "figures" / file; }

  void script(const std::string& name, const std::string& commands) const {
    sys::write_file_atomically(scratch_ / ("figures/" + name + ".gp"), commands);
  }
  void figure(const std::string& name, const std::vector<double>& y = {3, 1, 2}) {
    figures_[name] = {.width_cm = 6,
                      .height_cm = 4,
                      .data = {{"curve", {{"x", x}, {"y", y}}}},
                      .numbers = {{"half_width", 0.5}}};
  }
  void without_figure(const std::string& name) { figures_.erase(name); }

  FigurePlaces write() const {
    Document document;
    for (const auto& [name, figure] : figures_) document.figure(name, figure);
    document.write(generated());
    return document.figure_places();
  }
  std::size_t draw() const { return draw_figures(generated(), scratch_ / "figures", write()); }

  // What is said of a figure f with this script.
  template <typename Error>
  std::string error_of(const std::string& commands) {
    figure("f");
    script("f", commands);
    return message_of<Error>([&] { draw(); });
  }

 private:
  TemporaryFolder scratch_;
  std::map<std::string, Figure> figures_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_figure_names_its_graphic_without_a_folder) {
  Workplace workplace({"f"});

  workplace.draw();

  const std::string tex = sys::read_file(workplace.drawn("f/f.tex"));
  BOOST_TEST(holds(tex, "]{f}}%"));
  BOOST_TEST(lacks(tex, workplace.generated().string()));
}

BOOST_AUTO_TEST_CASE(a_figure_has_the_same_bytes_at_another_time) {
  Workplace workplace({"f"});
  workplace.draw();
  const std::string first = sys::sha256_of_file(workplace.drawn("f/f.pdf"));
  fs::remove(workplace.drawn("f/f.pdf"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));

  workplace.draw();

  BOOST_TEST(sys::sha256_of_file(workplace.drawn("f/f.pdf")) == first);
  BOOST_TEST(holds(sys::read_file(workplace.drawn("f/f.pdf")), "D:19700101000000Z"));
}

BOOST_AUTO_TEST_CASE(gnuplot_draws_the_same_figure_again_in_the_generated_folder) {
  Workplace workplace({"f"});
  workplace.draw();
  const std::string tex = sys::read_file(workplace.drawn("f/f.tex"));
  fs::remove(workplace.drawn("f/f.tex"));

  const auto again = sys::run(
      {.program = "gnuplot", .arguments = {"f.gp"}, .working_directory = workplace.drawn("f")});

  BOOST_TEST(again.exit_status == 0, again.output);
  BOOST_TEST(sys::read_file(workplace.drawn("f/f.tex")) == tex);
}

BOOST_AUTO_TEST_CASE(only_figures_whose_data_script_or_style_changed_are_drawn_again) {
  Workplace workplace({"f", "g"});
  BOOST_TEST(workplace.draw() == 2U);
  BOOST_TEST(workplace.draw() == 0U);

  workplace.script("f", "set grid\n" + curve_script);
  BOOST_TEST(workplace.draw() == 1U);
  workplace.figure("g", {3, 1, 2.5});
  BOOST_TEST(workplace.draw() == 1U);
  workplace.script("style", "set border 1\n");
  BOOST_TEST(workplace.draw() == 2U);
  sys::write_file_atomically(workplace.drawn("g/g.tex"), "forged");
  BOOST_TEST(workplace.draw() == 1U);
  BOOST_TEST(workplace.draw() == 0U);
}

BOOST_AUTO_TEST_CASE(the_drawing_of_a_figure_that_is_no_longer_registered_is_removed) {
  Workplace workplace({"f", "g"});
  workplace.draw();

  workplace.without_figure("g");
  workplace.draw();

  for (const std::string& file : sys::files_below(workplace.generated())) {
    BOOST_TEST(lacks(file, "figures/g/"));
  }
  BOOST_TEST(fs::exists(workplace.drawn("f/f.pdf")));
  workplace.without_figure("f");
  workplace.draw();
  for (const std::string& file : sys::files_below(workplace.generated())) {
    BOOST_TEST(!file.starts_with("figures/"), file);
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_was_killed_between_two_figures_costs_neither) {
  Workplace workplace({"a", "b"});
  workplace.draw();
  const FigurePlaces places = workplace.write();
  // It had moved all files of a into place and none of b, and its list of both was still there.
  std::string list;
  for (const std::string& file : drawn_files(places)) list += file + "\n";
  sys::write_file_atomically(workplace.file("out.publishing"), list);
  for (const char* file : {"drawn.sha256", "files.tex", "script.gp", "b.pdf", "b.tex"}) {
    fs::remove(workplace.drawn(std::string("b/") + file));
  }

  draw_figures(workplace.generated(), workplace.file("figures"), places);

  for (const std::string& file : drawn_files(places)) {
    BOOST_TEST(fs::exists(workplace.generated() / file), file);
  }
}

BOOST_AUTO_TEST_CASE(all_files_of_a_drawing_are_told) {
  Workplace workplace({"f"});
  const FigurePlaces places = workplace.write();
  const auto before = sys::files_below(workplace.generated());

  workplace.draw();

  std::vector<std::string> expected = before;
  for (std::string& file : drawn_files(places)) expected.push_back(std::move(file));
  std::ranges::sort(expected);
  BOOST_TEST(sys::files_below(workplace.generated()) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_drawing_that_is_older_than_its_data_is_refused) {
  Workplace workplace({"f"});
  const auto refusal = [&] {
    const FigurePlaces places = workplace.write();
    return message_of<sys::OutputError>([&] { require_drawn(workplace.generated(), places); });
  };

  BOOST_TEST(holds(refusal(), "figure 'f'"));
  workplace.draw();
  BOOST_TEST(refusal() == "(no error)");
  workplace.figure("f", {3, 1, 2.5});
  BOOST_TEST(holds(refusal(), "figure 'f'"));
}

BOOST_AUTO_TEST_CASE(the_documents_list_of_files_names_script_style_and_data_with_their_digests) {
  Workplace workplace({"f"});

  workplace.draw();

  const std::string files = sys::read_file(workplace.drawn("f/files.tex"));
  for (const char* file :
       {"figures/style.gp", "figures/f/script.gp", "figures/f/f.gp", "figures/f/curve.csv"}) {
    const std::string digest = sys::sha256_of_file(workplace.generated() / file);
    BOOST_TEST(holds(files, std::string("\\LiterateFile{") + file + "}{" + digest + "}"), file);
  }
}

BOOST_AUTO_TEST_CASE(an_error_of_gnuplot_has_script_line_message_and_place_of_registration) {
  Workplace workplace;
  workplace.figure("b");
  workplace.script("b", "\nset nonsense\n");
  workplace.figure("z");
  workplace.script("z", "plott x\n");

  const std::string message = message_of<sys::ToolError>([&] { workplace.draw(); });

  BOOST_TEST(message.starts_with("figures/b.gp:2: gnuplot: unrecognized option"), message);
  BOOST_TEST(holds(message, "figure 'b' is registered at "));
  const fs::path kept = workplace.generated().string() + ".failed/figures/b/b.gp";
  BOOST_TEST(holds(message, "; what gnuplot read is kept in '" + kept.string() + "'"));
  BOOST_TEST(fs::exists(kept));
  BOOST_TEST(fs::exists(kept.parent_path() / "script.gp"));
  BOOST_TEST(holds(message, "draw_test.cpp:"));
}

BOOST_AUTO_TEST_CASE(what_gnuplot_read_is_kept_of_all_figures_that_fail_at_the_same_time) {
  // Many, since threads that are in one another's way meet by chance.
  Workplace workplace;
  std::vector<std::string> names;
  for (char letter = 'a'; letter <= 'p'; ++letter) names.emplace_back(1, letter);
  for (const std::string& name : names) {
    workplace.figure(name);
    workplace.script(name, "plott x\n");
  }

  const std::string message = message_of<sys::ToolError>([&] { workplace.draw(); });

  BOOST_TEST(message.starts_with("figures/a.gp:1: "), message);
  const fs::path kept = workplace.generated().string() + ".failed/figures";
  BOOST_TEST(fs::exists(kept / "style.gp"));
  for (const std::string& name : names) BOOST_TEST(fs::exists(kept / name / (name + ".gp")), name);
}

BOOST_AUTO_TEST_CASE(an_error_in_the_style_is_told_there) {
  Workplace workplace;
  workplace.script("style", "set border 3\nset nonsense\n");

  BOOST_TEST(holds(workplace.error_of<sys::ToolError>(curve_script), "figures/style.gp:2: "));
}

BOOST_AUTO_TEST_CASE(what_a_script_reads_must_be_registered) {
  Workplace workplace;
  const auto said = [&](const std::string& commands) {
    return workplace.error_of<sys::InputError>("\n" + commands);
  };

  const std::string undefined = said("plot loads using 1:2\n");
  BOOST_TEST(undefined.starts_with("figures/f.gp:2: 'loads' is neither defined nor registered"));
  BOOST_TEST(holds(undefined, "curve, half_width"));
  BOOST_TEST(holds(undefined, "draw_test.cpp:"));
  BOOST_TEST(holds(said("set xrange [0:half_widht]\nplot x\n"), "figures/f.gp:2: 'half_widht'"));
  BOOST_TEST(holds(said("plot curve using \"x\":\"w\", x\n"), "figures/f.gp:2: the data have no"));
  BOOST_TEST(holds(said("plot sin(x), 'none.csv'\n"),
                   "figures/f.gp:2: 'none.csv' is plotted from a file"));
}

BOOST_AUTO_TEST_CASE(a_curve_that_gnuplot_only_warns_about_is_an_error) {
  Workplace workplace;

  const std::string message = workplace.error_of<sys::ToolError>("plot x, curve using 1:9\n");

  BOOST_TEST(message.starts_with("figures/f.gp:1: gnuplot: "), message);
}

BOOST_AUTO_TEST_CASE(a_missing_script_or_style_is_bad_input_that_names_it) {
  Workplace workplace;
  workplace.figure("f");

  const std::string message = message_of<sys::InputError>([&] { workplace.draw(); });
  BOOST_TEST(message.starts_with("there is no script 'figures/f.gp' for the figure registered at"));
  BOOST_TEST(holds(message, "draw_test.cpp:"));
  fs::remove(workplace.file("figures/style.gp"));
  BOOST_TEST(holds(message_of<sys::InputError>([&] { workplace.draw(); }), "style.gp"));
}

BOOST_AUTO_TEST_CASE(a_script_that_writes_another_file_is_bad_input) {
  Workplace workplace;
  BOOST_TEST(holds(workplace.error_of<sys::InputError>("plot x\nset output 'other.tex'\n"),
                   "figures/f.gp:2: 'set output' has no place"));
  // Hidden from the look at its commands, but not from the look at its folder.
  BOOST_TEST(holds(
      workplace.error_of<sys::InputError>("eval 'set pri' . 'nt \"other.txt\"'\nprint 1\nplot x\n"),
      "wrote a file of its own, 'other.txt'"));
}

BOOST_AUTO_TEST_CASE(a_broken_figure_leaves_all_drawings_untouched) {
  Workplace workplace({"f", "g"});
  workplace.draw();
  const std::string before = sys::read_file(workplace.drawn("f/script.gp"));
  workplace.script("f", "set grid\n" + curve_script);
  workplace.script("g", "set nonsense\n");

  BOOST_CHECK_THROW(workplace.draw(), sys::ToolError);

  BOOST_TEST(sys::read_file(workplace.drawn("f/script.gp")) == before);
  BOOST_TEST(!fs::exists(workplace.file("out.part")));
}

BOOST_AUTO_TEST_CASE(a_missing_gnuplot_is_a_tool_error) {
  Workplace workplace({"f"});
  const std::string path = std::getenv("PATH");
  setenv("PATH", workplace.file("figures").c_str(), 1);

  const std::string message = message_of<sys::ToolError>([&] { workplace.draw(); });
  setenv("PATH", path.c_str(), 1);

  BOOST_TEST(message.starts_with("gnuplot is not installed"));
}

BOOST_AUTO_TEST_SUITE_END()
