// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

/// Catches what is printed on standard output as long as it lives.
class PrintedText {
 public:
  PrintedText() : file_(std::tmpfile()) {
    flush();
    standard_output_ = ::dup(STDOUT_FILENO);
    if (file_ != nullptr) ::dup2(::fileno(file_), STDOUT_FILENO);
  }
  PrintedText(const PrintedText&) = delete;
  PrintedText& operator=(const PrintedText&) = delete;
  ~PrintedText() {
    flush();
    ::dup2(standard_output_, STDOUT_FILENO);
    ::close(standard_output_);
    if (file_ != nullptr) std::fclose(file_);
  }

  /// The beginning of the first line that was printed; empty if nothing was.
  std::string beginning() const {
    flush();
    char text[60] = {};
    if (file_ == nullptr) return "";
    std::rewind(file_);
    const std::size_t n_read = std::fread(text, 1, sizeof text, file_);
    const std::string line(text, n_read);
    return line.substr(0, line.find('\n'));
  }

 private:
  static void flush() {
    std::cout.flush();
    std::fflush(stdout);
  }

  std::FILE* file_;
  int standard_output_ = -1;
};
