// SPDX-License-Identifier: GPL-3.0-or-later
#include <cxxabi.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <typeinfo>

#include "command_line/exit_codes.hpp"
#include "literate/document/registered.hpp"
#include "literate/main/stages.hpp"
#include "system/error.hpp"
#include "system/process.hpp"
#include "system/require.hpp"

namespace literate {
namespace {

using std::chrono::seconds;

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

std::string type_of(const std::exception& error) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : typeid(error).name();
}

std::string how_far() {
  return fmt::format("the last thing registered was {}", last_registered());
}

/// Nothing here may ask for memory, which may be what is broken.
void tell_crash(int signal) {
  const auto say = [](std::string_view text) {
    [[maybe_unused]] const ssize_t n = ::write(STDERR_FILENO, text.data(), text.size());
  };
  const char* abbreviation = ::sigabbrev_np(signal);
  say("\nthe computation crashed: SIG");
  say(abbreviation == nullptr ? "?" : abbreviation);
  say("; the last thing registered was ");
  say(last_registered());
  say("\n");
  ::raise(signal);  // by SA_RESETHAND the default, which ends the program
}

/// While it lives, a crash is told. The stack may be what has overflowed, so there is another.
class CrashTeller {
 public:
  CrashTeller() {
    stack_t other{};
    other.ss_sp = stack_.get();
    other.ss_size = stack_size;
    ::sigaltstack(&other, &former_stack_);
    struct sigaction action {};
    action.sa_handler = tell_crash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK | SA_NODEFER);
    for (std::size_t i = 0; i < crashes.size(); ++i) {
      ::sigaction(crashes[i], &action, &former_[i]);
    }
  }
  ~CrashTeller() {
    for (std::size_t i = 0; i < crashes.size(); ++i) {
      ::sigaction(crashes[i], &former_[i], nullptr);
    }
    ::sigaltstack(&former_stack_, nullptr);
  }
  CrashTeller(const CrashTeller&) = delete;
  CrashTeller& operator=(const CrashTeller&) = delete;

 private:
  static constexpr std::size_t stack_size = 65536;
  std::unique_ptr<char[]> stack_ = std::make_unique<char[]>(stack_size);
  stack_t former_stack_{};
  std::array<struct sigaction, crashes.size()> former_{};
};

std::atomic<bool> is_computing = false;

/// Nothing would be written, and yet the program would end as one that has done its work.
void refuse_to_exit() {
  if (!is_computing) return;
  command_line::complain("the computation ended the program by exit(); " + how_far(),
                         sys::ExitCode::failed);
  std::_Exit(static_cast<int>(sys::ExitCode::failed));
}

/// While it lives, the program may not exit.
class ExitGuard {
 public:
  ExitGuard() {
    [[maybe_unused]] static const int registered_once = std::atexit(refuse_to_exit);
    is_computing = true;
  }
  ~ExitGuard() { is_computing = false; }
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

/// While it lives, a line on the terminal tells how long the computation takes, and it is ended
/// when its time is over.
class Clock {
 public:
  Clock() : limit_(sys::given_limit()), thread_([this] { watch(); }) {}
  ~Clock() {
    {
      const std::lock_guard lock(mutex_);
      is_done_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

 private:
  void watch() {
    const bool is_terminal = ::isatty(STDOUT_FILENO) == 1;
    std::unique_lock lock(mutex_);
    for (seconds passed{1};; passed += seconds(1)) {
      if (changed_.wait_until(lock, begin_ + passed, [this] { return is_done_; })) return;
      if (limit_ && *limit_ > 0 && passed >= seconds(*limit_)) {
        command_line::complain(
            fmt::format("the computation has not ended after {} s and was stopped; {}; "
                        "LITERATE_TIMEOUT=seconds allows more, 0 any time",
                        passed.count(), how_far()),
            sys::ExitCode::failed);
        std::_Exit(static_cast<int>(sys::ExitCode::failed));
      }
      if (is_terminal && passed.count() % 10 == 0) {
        fmt::print("compute   {:>6} s  {}\033[K\r", passed.count(), how_far());
        std::fflush(stdout);
      }
    }
  }

  std::optional<int> limit_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_done_ = false;
  std::thread thread_;  // after all that it uses
};

}  // namespace

void compute_guarded(Document& document, const Inputs& inputs, const Compute& compute) {
  const CrashTeller crash_teller;
  const ExitGuard exit_guard;
  const Clock clock;
  try {
    compute(document, inputs);
  } catch (const sys::InvalidQuantity& error) {
    // An operator, such as a division, knows no line of its caller.
    throw sys::InputError(fmt::format("{}; {}", error.what(), how_far()));
  } catch (const std::invalid_argument& error) {
    throw sys::InputError(fmt::format("{}; {}", error.what(), how_far()));
  } catch (const sys::Error&) {
    throw;
  } catch (const std::exception& error) {
    throw sys::ComputationError(
        fmt::format("{} ({}); {}", error.what(), type_of(error), how_far()));
  }
}

}  // namespace literate
