// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/paper.hpp"

#include <fmt/core.h>
#include <gnu/libc-version.h>
#include <openssl/opensslv.h>
#include <sys/utsname.h>
#include <CLI/Version.hpp>

#include <boost/version.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string version_text(const Paper& paper, const Repository& repository) {
  return fmt::format("{} {} (commit {}{})", paper.project, paper.version, repository.commit,
                     repository.modified ? ", modified" : "");
}

std::string version_text(const Paper& paper) {
  try {
    const fs::path program = fs::read_symlink("/proc/self/exe");
    return version_text(paper, read_repository(program.parent_path() / paper.repository));
  } catch (const sys::OutputError&) {
    return version_text(paper, {});
  }
}

namespace {

std::string joined(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace

std::map<std::string, std::string> engine_libraries() {
  return {
      {"Boost", joined(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"CLI11", CLI11_VERSION},
      {"OpenSSL", OPENSSL_VERSION_STR},
      {"UDUNITS", LITERATE_UDUNITS_VERSION},
      {"fmt", joined(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"glibc", gnu_get_libc_version()},
      {"nlohmann-json", joined(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
      {"toml++", LITERATE_TOMLPLUSPLUS_VERSION}};
}

std::string engine_version() {
  return LITERATE_VERSION;
}

std::string processor() {
  utsname system{};
  std::string text = uname(&system) == 0 ? system.machine : "unknown";
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx")) text += " avx";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx512f")) text += " avx512f";
#endif
  return text;
}

Repository read_repository(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "repository.json";
  try {
    const auto facts = nlohmann::json::parse(sys::read_file(file));
    const auto& engine = facts.at("engine");
    return {.commit = facts.at("commit").get<std::string>(),
            .modified = facts.at("modified").get<bool>(),
            .date = facts.at("date").get<std::string>(),
            .engine_commit = engine.at("commit").get<std::string>(),
            .engine_modified = engine.at("modified").get<bool>()};
  } catch (const nlohmann::json::exception&) {
    throw sys::OutputError(
        fmt::format("'{}' does not tell the state of a repository", file.string()));
  }
}

}  // namespace literate
