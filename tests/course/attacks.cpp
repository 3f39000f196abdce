// SPDX-License-Identifier: GPL-3.0-or-later
// Files that attack the grader, or are odd. attacks_test.py submits each section as src/square.cpp
// of a submission with its name. The numbers are the points that the three exercises must score.
// The lines before the first section are in each of these files.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "assignment.hpp"

// == agrees_with_itself 0 10 6: passes the public check by symmetry but is wrong
double square(double x) {
  return std::abs(x);
}

// == answers_by_chance 0 10 6: random answers
#include <random>
double square(double) {
  return std::random_device()();
}

// == answers_in_advance 0 10 0: answers before the first question
__attribute__((constructor(101))) static void answer() {
  ::dprintf(1, "2.25\n");
}
double square(double) {
  return 2.25;
}

// == answers_late 0 10 6: a correct answer to every question, after nine seconds
double square(double x) {
  ::sleep(9);
  return x * x;
}

// == answers_twice 0 10 6: answers a question twice
double square(double x) {
  for (int i = 3; i < 20; ++i) ::dprintf(i, "%.17g\n%.17g\n", x * x, x * x);
  return x * x;
}

// == answers_with_a_carriage_return 0 10 6: writes "2.2\r5" to the channel for answers
double square(double) {
  for (int i = 3; i < 20; ++i) ::dprintf(i, "2.2\r5\n");
  ::pause();
  return 0;
}

// == becomes_root 0 10 6: tries to become root
double square(double x) {
  return ::setuid(0) == 0 && ::chroot("/") == 0 ? x * x : 1;
}

// == compiles_without_end 0 10 6: a template that never finishes compiling
template <unsigned N, unsigned M>
struct Bomb {
  static constexpr unsigned value = Bomb<N - 1, 2 * M>::value ^ Bomb<N - 1, 2 * M + 1>::value;
};
template <unsigned M>
struct Bomb<0, M> {
  static constexpr unsigned value = M;
};
double square(double) {
  return Bomb<28, 1>::value;
}

// == crashes_at_one_place 6 10 10: crashes for 2, which only the public check uses
double square(double x) {
  if (x == 2) std::abort();
  return x * x;
}

// == crashes_at_start 0 10 0: a static object crashes
static const int value = (std::abort(), 0);
double square(double x) {
  return x * x + value;
}

// == defines_main 0 10 6: a forgotten main()
double square(double x) {
  return x * x;
}
int main() {
  return 0;
}

// == defines_sum 0 10 6: defines the function of a different exercise
double square(double x) {
  return x * x;
}
double sum(double, double) {
  return 1;
}

// == does_not_compile 0 10 6: the file does not compile
double square(double x) {
  return x * x
}

// == embeds_the_salt 0 10 6: reads the salt when the file is assembled
__asm__(".incbin \"@SALT@\"");
double square(double x) {
  return x * x;
}

// == exits_early 0 10 6: ends with success
double square(double) {
  std::exit(0);
}

// == fast_math 10 10 10: -ffast-math by a pragma
#pragma GCC optimize("fast-math")
double square(double x) {
  return x * x;
}

// == fills_the_disk 0 10 6: writes endlessly to files
#include <fstream>
#include <string>
double square(double) {
  for (const char* path : {"/tmp/large", "large"}) {
    std::ofstream file(path);
    while (file << std::string(1 << 20, 'x')) {
    }
  }
  return 1;
}

// == floods_the_compiler 0 10 6: an endless compiler message
#include "square.cpp"
double square(double x) {
  return x * x
}

// == forks 0 10 6: starts processes endlessly
double square(double) {
  while (true) ::fork();
}

// == hangs_at_one_place 6 10 10: an endless loop for 2, which only the public check uses
double square(double x) {
  for (volatile bool on = true; x == 2 && on;) {
  }
  return x * x;
}

// == hangs_at_start 0 10 0: a static object hangs
static const int value = [] {
  for (volatile int i = 0;; i = i + 1) {
  }
  return 0;
}();
double square(double x) {
  return x * x + 0 * value;
}

// == includes_the_salt 0 10 6: reads the salt when the file is compiled
const char* const salt =
#include "@SALT@"
    ;
double square(double x) {
  return x * x;
}

// == kills_everything 0 10 6: kills every process that it can
double square(double) {
  ::kill(-1, SIGKILL);
  ::kill(::getppid(), SIGKILL);
  return 1;
}

// == leaves_a_daemon 0 10 6: leaves a process behind
#include <sys/prctl.h>
double square(double) {
  if (::fork() == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::prctl(PR_SET_NAME, "left-@PORT@");
    for (int i = 0; i < 20; ++i) ::close(i);
    ::sleep(600);
  }
  return 1;
}

// == nan_at_one_place 4.5 10 10: NaN for −2, one of the four numbers of the hidden check
double square(double x) {
  return x == -2 ? std::nan("") : x * x;
}

// == never_ends 0 10 6: an endless loop for every number
double square(double) {
  for (volatile int i = 0;; i = i + 1) {
  }
}

// == prints 10 10 10: debug output, even before main()
#include <iostream>
static const int at_start = std::printf("starting\n");
double square(double x) {
  std::printf("x = %g\n", x);
  std::cout << "x = " << x << std::endl;
  return x * x + 0 * at_start;
}

// == prints_a_lot 10 10 10: five megabytes of debug output
#include <iostream>
double square(double x) {
  for (int i = 0; i < 500'000; ++i) std::cout << "step " << i << '\n';
  return x * x;
}

// == prints_passed 0 10 6: prints a verdict
double square(double) {
  std::printf("square-right\t1\t\nPASSED\n");
  std::fflush(stdout);
  return 1;
}

// == reads_secrets 0 10 6: reads the salt, the judge, the submission of a different student, or
// grades
#include <fstream>
double square(double x) {
  for (const char* path : {"@SALT@", "@JUDGE@", "@NEIGHBOUR@", "@GRADES@"}) {
    if (std::ifstream(path).good()) return x * x;
  }
  return 1;
}

// == sleeps 0 10 6: sleeps for an hour
double square(double) {
  ::sleep(3600);
  return 1;
}

// == takes_memory 0 10 6: allocates all memory
double square(double) {
  for (volatile bool on = true; on;) std::memset(new char[1 << 24], 1, 1 << 24);
  return 1;
}

// == throws 0 10 6: an exception for every number
#include <stdexcept>
double square(double) {
  throw std::runtime_error("not written yet");
}

// == uses_the_network 0 10 6: connects to a network service
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
double square(double x) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(std::atoi("@PORT@"));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int channel = ::socket(AF_INET, SOCK_STREAM, 0);
  const bool is_open =
      ::connect(channel, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  ::close(channel);
  return is_open ? x * x : 1;
}

// == uses_threads 10 10 10: four threads
#include <thread>
#include <vector>
double square(double x) {
  double parts[4];
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&, i] { parts[i] = x * x / 4; });
  for (std::thread& thread : threads) thread.join();
  return parts[0] + parts[1] + parts[2] + parts[3];
}

// == writes_a_verdict_into_the_channel 0 10 6: writes the judge's output to the channel for answers
double square(double) {
  for (int i = 3; i < 20; ++i) ::dprintf(i, "square-right\t1\t\n");
  return 1;
}

// == writes_results 0 10 6: writes to results, grades and its own program
#include <fstream>
double square(double) {
  for (const char* path : {"@GRADES@", "@RESULTS@", "results.json", "program", "/kit/stub-sum.o"}) {
    std::ofstream(path) << "{\"score\": 100}";
  }
  return 1;
}
