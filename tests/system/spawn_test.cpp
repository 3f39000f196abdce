// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/spawn.hpp"

#include <fcntl.h>
#include <sys/wait.h>

#include <boost/test/unit_test.hpp>
#include <csignal>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(spawn_test)

using namespace sys;

namespace {

bool is_open(int descriptor) {
  return ::fcntl(descriptor, F_GETFD) >= 0;
}

/// Runs a shell script as a child and returns its status of wait.
int status_of(std::string script, const FileActions& actions) {
  std::vector<std::string> arguments{"sh", "-c", std::move(script)};
  std::vector<std::string> environment;
  pid_t child = 0;
  BOOST_REQUIRE_EQUAL(
      posix_spawn(&child, "/bin/sh", actions.get(), nullptr, exec_pointers(arguments).data(),
                  exec_pointers(environment).data()),
      0);
  int status = 0;
  BOOST_REQUIRE_EQUAL(::waitpid(child, &status, 0), child);
  return status;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_descriptor_is_closed_once_by_its_last_owner) {
  int number = 0;
  {
    Descriptor first(::open("/dev/null", O_RDONLY));
    number = first.number();
    const Descriptor second(std::move(first));
    BOOST_TEST(second.number() == number);
    BOOST_TEST(is_open(number));
  }
  BOOST_TEST(!is_open(number));
}

BOOST_AUTO_TEST_CASE(a_closed_descriptor_is_none) {
  Descriptor descriptor(::open("/dev/null", O_RDONLY));
  const int number = descriptor.number();

  descriptor.close();

  BOOST_TEST(!is_open(number));
  BOOST_TEST(descriptor.number() == -1);
}

BOOST_AUTO_TEST_CASE(a_child_starts_with_the_folder_and_descriptors_it_was_given) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "input", "from the input\n");
  FileActions actions;
  actions.change_folder(scratch.path());
  actions.open(0, "input", O_RDONLY);
  actions.open(1, "output", O_WRONLY | O_CREAT, 0600);
  actions.duplicate(1, 2);

  status_of("cat; pwd >&2", actions);

  BOOST_TEST(read_file(scratch / "output") == "from the input\n" + scratch.path().string() + "\n");
}

BOOST_AUTO_TEST_CASE(descriptors_from_a_number_on_are_closed_in_the_child) {
  FileActions actions;
  actions.open(5, "/dev/null", O_RDONLY);
  const std::string is_5_open = "[ -e /proc/self/fd/5 ]";

  const int before = status_of(is_5_open, actions);
  actions.close_from(5);
  const int after = status_of(is_5_open, actions);

  BOOST_TEST(shell_status(before) == 0);
  BOOST_TEST(shell_status(after) == 1);
}

BOOST_AUTO_TEST_CASE(a_status_is_the_exit_status_or_128_plus_the_signal) {
  const FileActions none;
  BOOST_TEST(shell_status(status_of("exit 7", none)) == 7);
  BOOST_TEST(shell_status(status_of("kill -TERM $$", none)) == 128 + SIGTERM);
}

BOOST_AUTO_TEST_CASE(a_pipe_carries_bytes_and_no_child_inherits_it) {
  Pipe pipe = open_pipe(O_NONBLOCK);
  const std::string sent = "some bytes";
  std::string received(sent.size(), ' ');

  BOOST_TEST(::write(pipe.writing.number(), sent.data(), sent.size()) == std::ssize(sent));
  BOOST_TEST(::read(pipe.reading.number(), received.data(), received.size()) == std::ssize(sent));

  BOOST_TEST(received == sent);
  BOOST_TEST(::read(pipe.reading.number(), received.data(), 1) == -1);
  for (const Descriptor* end : {&pipe.reading, &pipe.writing}) {
    BOOST_TEST((::fcntl(end->number(), F_GETFD) & FD_CLOEXEC) != 0);
  }
}

BOOST_AUTO_TEST_CASE(what_could_not_start_is_named_with_the_reason) {
  BOOST_TEST(cannot_start("gnuplot", ENOENT).what() ==
             std::string("cannot start gnuplot: No such file or directory"));
}

BOOST_AUTO_TEST_SUITE_END()
