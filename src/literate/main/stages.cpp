// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stages.hpp"

#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/deposit/describe_folder.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/stage_record.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

// The scripts that were run, as their copies beside the drawings have them, and the list of
// digests.
FileDigests files_of(const Settings& settings, const Names& names) {
  FileDigests files;
  const std::filesystem::path figures = settings.generated() / "figures";
  const std::filesystem::path folder = std::filesystem::absolute(settings.figures);
  for (const auto& [name, place] : names.figures) {
    files[(folder / (name + ".gp")).string()] = sys::sha256_of_file(figures / name / "script.gp");
  }
  if (!names.figures.empty()) {
    files[(folder / "style.gp").string()] = sys::sha256_of_file(figures / "style.gp");
  }
  files[std::filesystem::absolute(settings.digest()).string()] =
      sys::sha256_of_file(settings.digest());
  return files;
}

// What the document may attach to the PDF, as a list that it attaches as well: so the PDF alone
// tells whether its attachments are those that it was made with, to `sha256sum --check`, too. They
// are attached without folders; a line of comment gives the path of one that had any.
void write_attached(const std::filesystem::path& generated) {
  std::vector<std::string> files = sys::files_below(generated);
  std::erase_if(files, [](const std::string& file) {
    return !file.ends_with(".csv") && !file.ends_with(".gp") && !file.starts_with("imports/");
  });
  std::string list;
  for (const auto& [digest, file] : sys::record_entries(generated, files)) {
    const std::string attached = boost::replace_all_copy(file, "/", "-");
    list +=
        fmt::format("{}{}  {}\n", attached == file ? "" : "# " + file + ":\n", digest, attached);
  }
  sys::write_if_changed(generated / attached_list, list);
}

sys::ExitCode draw_changed(const Settings& settings) {
  const command_line::Stage drawing("draw");
  const std::filesystem::path generated = settings.generated();
  StageRecord record(settings.record("draw"));
  const Names names = read_names(generated / "names.json");
  const std::size_t n_drawn = draw_figures(generated, settings.figures, names.figures);
  write_attached(generated);
  sys::write_if_changed(settings.digest(), digest_of(generated));
  record.done(files_of(settings, names));
  drawing.done(fmt::format("{} of {} figure{}", n_drawn, names.figures.size(),
                           names.figures.size() == 1 ? "" : "s"));
  return sys::ExitCode::success;
}

}  // namespace

void add_draw_stage(CLI::App& program, sys::ExitCode& exit_code) {
  add_stage(program, exit_code, "draw",
            "Draw by gnuplot the figures whose script or data changed since they were drawn",
            draw_changed);
}

void add_describe_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper) {
  const auto folder = std::make_shared<std::string>();
  add_stage(
      program, exit_code, "describe",
      "Describe a folder of results for archives: codecheck.yml, RO-Crate",
      [folder, &paper](const Settings& settings) {
        describe_folder(*folder, read_manifest(settings.manifest(), paper.project),
                        read_citation(settings.root / "CITATION.cff"));
        return sys::ExitCode::success;
      },
      [folder](CLI::App& command) {
        command_line::add_required_text(command, "--folder", *folder, "DIR",
                                        "Folder with the results");
      });
}

void add_stage(CLI::App& program, sys::ExitCode& exit_code, const std::string& name,
               const std::string& description,
               const std::function<sys::ExitCode(const Settings&)>& run,
               const std::function<void(CLI::App& command)>& add_flags) {
  command_line::add_command(program, name, description, exit_code, [&](CLI::App& command) {
    auto file = std::make_shared<std::string>();
    command_line::add_required_text(command, "SETTINGS", *file, "FILE",
                                    "What the build wrote of the paper: NAME.settings");
    if (add_flags) add_flags(command);
    return [file, run] { return run(read_settings(*file)); };
  });
}

void add_stages(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                const Compute& compute) {
  add_compute_stage(program, exit_code, paper, compute);
  add_draw_stage(program, exit_code);
  add_typeset_stage(program, exit_code, paper);
  add_check_stage(program, exit_code, paper);
  add_page_stages(program, exit_code);
  add_describe_stage(program, exit_code, paper);
}

int main(int argc, char** argv, const Paper& paper, const Compute& compute) {
  return command_line::run_program(
      {.name = paper.project,
       .description = "Computes, typesets and checks the paper " + paper.project + ".",
       .version = version_text(paper)},
      {[&](CLI::App& program, sys::ExitCode& exit_code) {
        add_stages(program, exit_code, paper, compute);
      }},
      argc, argv);
}

}  // namespace literate
