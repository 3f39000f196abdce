// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "literate/document/folder.hpp"
#include "system/error.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// Shows the elapsed time and the progress on a terminal.
class Clock {
 public:
  explicit Clock(std::shared_ptr<const Progress> progress) : progress_(std::move(progress)) {
    if (::isatty(STDERR_FILENO) == 0) return;
    thread_.emplace([this](const std::stop_token& stop) { show(stop); });
  }

 private:
  void show(const std::stop_token& stop) const {
    using std::chrono::seconds;
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any end;
    const auto begin = std::chrono::steady_clock::now();
    bool is_shown = false;
    while (!end.wait_for(lock, stop, seconds(1), [&stop] { return stop.stop_requested(); })) {
      const auto passed = std::chrono::steady_clock::now() - begin;
      const long total = progress_->total;
      const std::string counts =
          total > 0 ? fmt::format(", {} of {}", progress_->done.load(), total) : "";
      fmt::print(stderr, "\r{} s{} ", std::chrono::duration_cast<seconds>(passed).count(), counts);
      is_shown = true;
    }
    if (is_shown) fmt::print(stderr, "\r\x1b[K");
  }

  std::shared_ptr<const Progress> progress_;
  std::optional<std::jthread> thread_;
};

}  // namespace

int run(int argc, char** argv, bool are_complete, const std::string& usage,
        const std::function<sys::ExitCode()>& program) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    fmt::print("{}\n", usage);
    return static_cast<int>(sys::ExitCode::success);
  }
  if (!are_complete) {
    fmt::print(stderr, "{}\n", usage);
    return static_cast<int>(sys::ExitCode::bad_input);
  }
  sys::ExitCode exit_code = sys::ExitCode::tool_failed;
  try {
    return static_cast<int>(program());
  } catch (const sys::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    // 1 would mean that the folder is complete.
    if (error.exit_code() != sys::ExitCode::failed) exit_code = error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "the computation failed: {}\n", error.what());
  }
  return static_cast<int>(exit_code);
}

sys::ExitCode write_and_report(const Document& document, const fs::path& folder,
                               const std::string& case_name) {
  write_folder(document, folder, case_name);
  const auto faults = document.faults();
  for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
  return faults.empty() ? sys::ExitCode::success : sys::ExitCode::failed;
}

int main(int argc, char** argv, const Compute& compute) {
  const std::string program = argc > 0 ? fs::path(argv[0]).filename().string() : "program";
  const std::string usage = fmt::format(
      "usage: {} compute CASE FOLDER\nComputes the paper's numbers from the file CASE "
      "and writes them to FOLDER.",
      program);
  const bool are_complete = argc == 4 && argv[1] == std::string_view("compute");
  return run(argc, argv, are_complete, usage, [&] {
    const fs::path case_file = argv[2];
    Document document;
    {
      const Clock clock(document.progress_so_far());
      compute(document, case_file);
    }
    return write_and_report(document, argv[3], case_file.filename().string());
  });
}

}  // namespace literate
