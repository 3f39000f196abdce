// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/draw_at_width.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "literate/figures/gnuplot.hpp"
#include "literate/figures/script_check.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/record.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr const char* width_record = "drawn.sha256";

double centimetres(std::int64_t scaled_points) {
  return static_cast<double>(scaled_points) / 65536 / 72.27 * 2.54;
}

/// What a drawing is made from: all that the drawing of the figure's own width is made from.
std::string drawn_from(const fs::path& generated, const FigureAtWidth& figure) {
  const fs::path record = generated / "figures" / figure.name / width_record;
  return fs::is_regular_file(record) ? sys::read_file(record) : std::string();
}

std::string record_of(const std::string& inputs, const fs::path& folder, const std::string& name) {
  sys::Record drawn = sys::record_entries(folder, {name + ".pdf", name + ".tex"});
  for (sys::RecordEntry& entry : drawn) entry.name = "at width " + entry.name;
  return inputs + sys::record_text(drawn);
}

bool is_up_to_date(const fs::path& generated, const fs::path& output, const FigureAtWidth& figure) {
  const fs::path folder = output / folder_of(figure);
  const fs::path record = folder / width_record;
  return fs::is_regular_file(record) &&
         sys::read_file(record) == record_of(drawn_from(generated, figure), folder, figure.name);
}

void draw(const fs::path& generated, const fs::path& work, const fs::path& drawn,
          const FigureAtWidth& figure, const ScriptRun& run) {
  const fs::path computed = generated / "figures" / figure.name;
  fs::create_directories(run.folder);
  fs::copy_file(generated / "figures/style.gp", work / "style.gp", fs::copy_options::skip_existing);
  for (const std::string& file : sys::files_below(computed)) {
    const bool is_read =
        file == figure.name + ".gp" || file == "script.gp" || file.ends_with(".csv");
    if (is_read) fs::copy_file(computed / file, run.folder / file);
  }
  require_drawn_well(run, run_gnuplot(run.folder, figure.name,
                                      fmt::format("width_cm={:.6f}", centimetres(figure.width))));
  fs::create_directories(drawn);
  for (const std::string ending : {".pdf", ".tex"}) {
    fs::rename(run.folder / (figure.name + ending), drawn / (figure.name + ending));
  }
  sys::write_file_atomically(drawn / width_record,
                             record_of(drawn_from(generated, figure), drawn, figure.name));
}

}  // namespace

std::string folder_of(const FigureAtWidth& figure) {
  return fmt::format("drawn/{}-{}", figure.name, figure.width);
}

std::size_t draw_at_widths(const fs::path& generated, const fs::path& output,
                           const std::set<FigureAtWidth>& figures, const FigurePlaces& places,
                           const std::string& label) {
  if (figures.empty()) return 0;
  sys::Staging staging(output);
  std::vector<FigureAtWidth> wanted;
  for (const FigureAtWidth& figure : figures) {
    if (places.contains(figure.name) && !is_up_to_date(generated, output, figure)) {
      wanted.push_back(figure);
    }
  }
  if (wanted.empty()) return 0;

  const fs::path workshop = staging.path() / "work";
  sys::for_each_parallel(wanted.size(), 0, [&](std::size_t i) {
    const FigureAtWidth& figure = wanted[i];
    const fs::path work = workshop / std::to_string(i);
    draw(generated, work, staging.path() / folder_of(figure), figure,
         {figure.name, work / figure.name, label, places.at(figure.name)});
  });
  fs::remove_all(workshop);
  staging.publish({});
  return wanted.size();
}

std::vector<std::string> keep_at_widths(const fs::path& output,
                                        const std::set<FigureAtWidth>& figures) {
  std::set<std::string> folders;
  for (const FigureAtWidth& figure : figures) folders.insert(folder_of(figure));
  std::vector<std::string> files;
  if (!fs::is_directory(output)) return files;
  for (const std::string& file : sys::files_below(output)) {
    if (!folders.contains(fs::path(file).parent_path().generic_string())) {
      fs::remove(output / file);
    } else if (!file.ends_with(width_record)) {
      files.push_back(file);
    }
  }
  return files;
}

}  // namespace literate
