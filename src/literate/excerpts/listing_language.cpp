// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/listing_language.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace literate {

std::string listing_language(std::string_view file) {
  using Entry = std::pair<std::string_view, std::string_view>;  // how a name ends, the language
  static constexpr std::array<Entry, 36> languages{{{".cpp", "[20]C++"},
                                                    {".hpp", "[20]C++"},
                                                    {".cc", "[20]C++"},
                                                    {".h", "[20]C++"},
                                                    {".c", "C"},
                                                    {".m", "Octave"},
                                                    {".py", "Python"},
                                                    {".jl", "Julia"},
                                                    {".R", "R"},
                                                    {".r", "R"},
                                                    {".f", "[77]Fortran"},
                                                    {".f90", "[95]Fortran"},
                                                    {".f95", "[95]Fortran"},
                                                    {".f03", "[03]Fortran"},
                                                    {".f08", "[08]Fortran"},
                                                    {".java", "Java"},
                                                    {".hs", "Haskell"},
                                                    {".lua", "[5.3]Lua"},
                                                    {".pl", "Perl"},
                                                    {".rb", "Ruby"},
                                                    {".sql", "SQL"},
                                                    {".awk", "Awk"},
                                                    {".gp", "Gnuplot"},
                                                    {".sh", "bash"},
                                                    {".bash", "bash"},
                                                    {".tex", "[LaTeX]TeX"},
                                                    {".sty", "[LaTeX]TeX"},
                                                    {".cls", "[LaTeX]TeX"},
                                                    {".html", "HTML"},
                                                    {".xml", "XML"},
                                                    {".json", "JSON"},
                                                    {".toml", "TOML"},
                                                    {".cmake", "CMake"},
                                                    {"CMakeLists.txt", "CMake"},
                                                    {"Makefile", "[gnu]make"},
                                                    {".mk", "[gnu]make"}}};
  const auto found = std::ranges::find_if(
      languages, [&](const Entry& entry) { return file.ends_with(entry.first); });
  return found == languages.end() ? std::string() : std::string(found->second);
}

}  // namespace literate
