// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/proc_file.hpp"

#include <fstream>
#include <sstream>

namespace sys {

std::string read_proc_file(const std::filesystem::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();  // stops at an error, where stream iterators would throw
  return text.str();
}

}  // namespace sys
