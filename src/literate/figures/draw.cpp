// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/draw.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "literate/figures/gnuplot.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/process.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr const char* record_name = "drawn.sha256";
constexpr const char* gnuplot_entry = "gnuplot --version";

/// The scripts of an author, and what messages call their folder.
struct Scripts {
  fs::path folder;
  std::string label;
  std::string style;
  std::string gnuplot;  ///< its version

  std::string label_of(const std::string& name) const {
    return fmt::format("{}/{}.gp", label, name);
  }
  fs::path file_of(const std::string& name) const { return folder / (name + ".gp"); }
};

Scripts scripts_in(const fs::path& folder) {
  Scripts scripts{folder,
                  fs::absolute(folder / "").lexically_normal().parent_path().filename(),
                  {},
                  sys::tool_version("gnuplot")};
  if (!fs::is_regular_file(scripts.file_of("style"))) {
    throw sys::InputError(
        fmt::format("there is no '{}', which all figures read", scripts.file_of("style").string()));
  }
  scripts.style = sys::read_file(scripts.file_of("style"));
  require_draws_only(scripts.style, scripts.label_of("style"));
  return scripts;
}

void require_script(const Scripts& scripts, const std::string& name, const std::string& place) {
  if (fs::is_regular_file(scripts.file_of(name))) return;
  throw sys::InputError(fmt::format("there is no script '{}' for the figure registered at {}",
                                    scripts.label_of(name), place));
}

/// What a drawing in a folder was made from; empty if none is there.
std::string record_in(const fs::path& folder) {
  const fs::path record = folder / record_name;
  return fs::is_regular_file(record) ? sys::read_file(record) : std::string();
}

/// Where the scripts and data of the figures lie that were drawn beside one that gnuplot refused.
fs::path failed_figures(const fs::path& generated) {
  return fs::absolute(generated / "").lexically_normal().parent_path().string() + ".failed";
}

/// Whether the files of a record, below the folder of its figure, have its digests.
bool are_as_recorded(const sys::Record& record, const fs::path& folder) {
  return std::ranges::all_of(record, [&](const sys::RecordEntry& entry) {
    return entry.name == gnuplot_entry || sys::is_as_recorded(folder, entry);
  });
}

/// Draws one figure in a folder of its own, and keeps what it was drawn from.
class Drawing {
 public:
  Drawing(const fs::path& generated, const Scripts& scripts, std::string name, std::string place)
      : scripts_(&scripts),
        name_(std::move(name)),
        place_(std::move(place)),
        computed_(generated / "figures" / name_) {
    require_script(scripts, name_, place_);
    script_ = sys::read_file(scripts.file_of(name_));
    require_draws_only(script_, scripts.label_of(name_));
    inputs_ = {{sys::sha256_of_text(scripts.gnuplot), gnuplot_entry},
               {sys::sha256_of_text(script_), "script.gp"},
               {sys::sha256_of_text(scripts.style), "../style.gp"}};
    std::ranges::move(sys::record_entries(computed_, computed_files(computed_, name_)),
                      std::back_inserter(inputs_));
  }

  /// Whether the drawing that is there was made from this, and lies beside a copy of it.
  bool is_up_to_date() const {
    return record_in(computed_) == record_of(computed_) && are_as_recorded(inputs_, computed_);
  }

  void draw(const fs::path& staging) const {
    const fs::path folder = staging / "figures" / name_;
    copy_computed(computed_, name_, folder);
    sys::write_file_atomically(folder / "script.gp", script_);

    const sys::ProcessResult result = run_gnuplot(folder, name_);
    try {
      require_drawn_well({name_, folder, scripts_->label, place_}, result);
    } catch (const sys::ToolError& error) {
      throw sys::ToolError(error.what() + kept());
    } catch (const sys::InputError& error) {
      throw sys::InputError(error.what() + kept());
    }

    sys::write_file_atomically(folder / "files.tex", files_tex());
    sys::write_file_atomically(folder / record_name, record_of(folder));
  }

 private:
  std::string kept() const {
    const fs::path failed = failed_figures(computed_.parent_path().parent_path());
    return fmt::format("; what gnuplot read is kept in '{}'",
                       (failed / "figures" / name_ / (name_ + ".gp")).string());
  }

  // What it was drawn from, and the drawing in this folder.
  std::string record_of(const fs::path& folder) const {
    sys::Record record = inputs_;
    std::ranges::move(sys::record_entries(folder, {name_ + ".pdf", name_ + ".tex", "files.tex"}),
                      std::back_inserter(record));
    return sys::record_text(record);
  }

  // What the document shows and attaches: script, style and data with their digests.
  std::string files_tex() const {
    std::string text;
    for (const auto& [digest, file] : inputs_) {
      if (file == gnuplot_entry) continue;
      const std::string path = file.starts_with("../") ? fmt::format("figures/{}", file.substr(3))
                                                       : fmt::format("figures/{}/{}", name_, file);
      text += fmt::format("\\LiterateFile{{{}}}{{{}}}%\n", path, digest);
    }
    return text;
  }

  const Scripts* scripts_;
  std::string name_, place_;
  fs::path computed_;
  std::string script_;
  sys::Record inputs_;
};

std::vector<std::string> drawn_files_of(const std::string& name) {
  std::vector<std::string> files;
  for (const std::string& file : {name + ".pdf", name + ".tex", std::string(record_name),
                                  std::string("files.tex"), std::string("script.gp")}) {
    files.push_back(fmt::format("figures/{}/{}", name, file));
  }
  return files;
}

/// What was drawn for figures that are not among these.
std::vector<std::string> former_files(const fs::path& generated, const FigurePlaces& figures) {
  std::vector<std::string> files;
  if (!fs::is_directory(generated / "figures")) return files;
  for (const auto& entry : fs::directory_iterator(generated / "figures")) {
    const std::string name = entry.path().filename().string();
    if (figures.contains(name) || !fs::is_regular_file(entry.path() / record_name)) continue;
    for (std::string& file : drawn_files_of(name)) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

std::size_t draw_figures(const fs::path& generated, const fs::path& scripts_folder,
                         const FigurePlaces& figures) {
  fs::remove_all(failed_figures(generated));
  sys::Staging staging(generated);
  std::vector<std::string> former = former_files(generated, figures);
  if (figures.empty()) {
    former.emplace_back("figures/style.gp");
    staging.publish(former);
    return 0;
  }

  // Find what has to be drawn, and refuse scripts that cannot be run.
  const Scripts scripts = scripts_in(scripts_folder);
  std::vector<Drawing> drawings;
  for (const auto& [name, place] : figures) drawings.emplace_back(generated, scripts, name, place);
  std::erase_if(drawings, [](const Drawing& drawing) { return drawing.is_up_to_date(); });

  // Draw them beside one another.
  sys::write_file_atomically(staging.path() / "figures/style.gp", scripts.style);
  try {
    sys::for_each_parallel(drawings.size(), 0,
                           [&](std::size_t i) { drawings[i].draw(staging.path()); });
  } catch (...) {
    // Keep what gnuplot read, for the author to read and to run.
    fs::create_directories(failed_figures(generated));
    fs::rename(staging.path() / "figures", failed_figures(generated) / "figures");
    throw;
  }
  staging.publish(former);
  return drawings.size();
}

std::vector<std::string> drawn_files(const FigurePlaces& figures) {
  std::vector<std::string> files;
  if (!figures.empty()) files.emplace_back("figures/style.gp");
  for (const auto& [name, place] : figures) {
    for (std::string& file : drawn_files_of(name)) files.push_back(std::move(file));
  }
  std::ranges::sort(files);
  return files;
}

void require_drawn(const fs::path& generated, const FigurePlaces& figures) {
  for (const auto& [name, place] : figures) {
    const fs::path folder = generated / "figures" / name;
    const auto drawn = sys::parse_record(record_in(folder));
    if (drawn && !drawn->empty() && are_as_recorded(*drawn, folder)) continue;
    throw sys::OutputError(fmt::format(
        "figure '{}' in '{}' is not drawn from the data that are there; `draw` comes before this",
        name, generated.string()));
  }
}

namespace {

double centimetres(std::int64_t scaled_points) {
  return static_cast<double>(scaled_points) / 65536 / 72.27 * 2.54;
}

/// The drawing in this folder, and all that the drawing of the figure's own width is made from.
std::string record_of(const fs::path& generated, const std::string& name, const fs::path& folder) {
  sys::Record drawn = sys::record_entries(folder, {name + ".pdf", name + ".tex"});
  for (sys::RecordEntry& entry : drawn) entry.name = "at width " + entry.name;
  return record_in(generated / "figures" / name) + sys::record_text(drawn);
}

bool is_up_to_date(const fs::path& generated, const fs::path& output, const FigureAtWidth& figure) {
  const fs::path folder = output / folder_of(figure);
  return record_in(folder) == record_of(generated, figure.name, folder);
}

void draw(const fs::path& generated, const fs::path& work, const fs::path& drawn,
          const FigureAtWidth& figure, const ScriptRun& run) {
  const fs::path computed = generated / "figures" / figure.name;
  copy_computed(computed, figure.name, run.folder);
  fs::copy_file(computed / "script.gp", run.folder / "script.gp");
  fs::copy_file(generated / "figures/style.gp", work / "style.gp");
  require_drawn_well(run, run_gnuplot(run.folder, figure.name,
                                      fmt::format("width_cm={:.6f}", centimetres(figure.width))));
  fs::create_directories(drawn);
  for (const std::string ending : {".pdf", ".tex"}) {
    fs::rename(run.folder / (figure.name + ending), drawn / (figure.name + ending));
  }
  sys::write_file_atomically(drawn / record_name, record_of(generated, figure.name, drawn));
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
    } else if (!file.ends_with(record_name)) {
      files.push_back(file);
    }
  }
  return files;
}

}  // namespace literate
