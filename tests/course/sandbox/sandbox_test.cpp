// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/sandbox.hpp"
#include "message_of.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <fstream>
#include <functional>
#include <string>

#include "course/sandbox/child.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(sandbox_test, *boost::unit_test::fixture(&need_walls))

using namespace course;
namespace fs = std::filesystem;

namespace {

struct Ended {
  JobEnd end;
  std::string output, errors;
};

Ended run(const TemporaryFolder& work, Job job, Isolation isolation = Isolation::sandbox) {
  const Sandbox sandbox(isolation, work.path());
  job.output = work.path() / "out";
  job.errors = work.path() / "err";
  const JobEnd end = sandbox.run(job);
  return {end, sys::read_file(job.output), sys::read_file(job.errors)};
}

Job shell(const std::string& script) {
  Job job;
  job.command = {"/bin/sh", "-c", script};
  job.seconds = 3;
  job.memory_mb = 256;
  return job;
}

/// A job without walls.
Ended run_freely(const TemporaryFolder& work, const Job& job) {
  return run(work, job, Isolation::none);
}

/// What `action` returns in a process of its own, which gives up the rights of root if it has them.
bool as_nobody(const TemporaryFolder& work, const std::function<bool()>& action) {
  constexpr uid_t nobody = 65534;
  if (::geteuid() == 0) BOOST_REQUIRE(::chown(work.path().c_str(), nobody, nobody) == 0);
  const pid_t process = ::fork();
  if (process == 0) {
    try {
      if (::geteuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) ::_exit(2);
      ::_exit(action() ? 0 : 1);
    } catch (...) {
      ::_exit(3);
    }
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Whether any process of the machine was started as `sleep seconds`.
bool is_sleeping(const std::string& seconds) {
  std::string command = "sleep " + seconds + " ";
  std::ranges::replace(command, ' ', '\0');
  for (const auto& entry : fs::directory_iterator("/proc")) {
    if (sys::read_proc_file(entry.path() / "cmdline") == command) return true;
  }
  return false;
}

const std::string leaves_daemons =
    "setsid sh -c 'setsid sleep 98761 & setsid sleep 98761' & exit 0";
const std::string many_processes = "for i in $(seq 40); do sleep 3 & done; sleep 3; wait";

}  // namespace

BOOST_AUTO_TEST_CASE(a_job_has_its_streams_and_its_status) {
  const TemporaryFolder work;
  Job job = shell("cat; echo complaint >&2; exit 7");
  job.input = work.write("in", "2.385\n");

  const Ended ended = run(work, job);

  BOOST_TEST(ended.output == "2.385\n");
  BOOST_TEST(ended.errors == "complaint\n");
  BOOST_TEST((ended.end.ending == Ending::normal));
  BOOST_TEST(ended.end.status == 7);
}

BOOST_AUTO_TEST_CASE(a_job_sees_what_it_may_read_and_cannot_write_it) {
  const TemporaryFolder work;
  Job job = shell("cat /given/part/file; echo x > /given/part/file || echo refused");
  job.readable = {{work.write("file", "given\n"), "/given/part/file"}};
  make_readable(work.path() / "file");

  BOOST_TEST(run(work, job).output == "given\nrefused\n");
}

BOOST_AUTO_TEST_CASE(a_job_sees_nothing_else) {
  const TemporaryFolder work;
  const fs::path secret = work.write("secret", "hidden\n");

  const Ended ended = run(work, shell("cat '" + secret.string() + "'; ls /; ls /tmp"));

  BOOST_TEST(ended.output == "bin\ndev\netc\nlib\nlib64\ntmp\nusr\n");
  BOOST_TEST(holds(ended.errors, "secret': No such file"), ended.errors);
  BOOST_TEST(run(work, shell("ls -A /usr/local /usr/src | grep -v :")).output == "\n");
}

BOOST_AUTO_TEST_CASE(a_job_inherits_no_environment) {
  const TemporaryFolder work;
  ::setenv("HALFSPACE_SECRET", "hidden", 1);

  const Ended ended = run(work, shell("env"));

  BOOST_TEST(holds(ended.output, "PATH=/usr/bin:/bin\n"));
  BOOST_TEST(!holds(ended.output, "hidden"));
}

BOOST_AUTO_TEST_CASE(a_job_writes_to_nothing_but_its_streams_unless_it_is_given_room) {
  const TemporaryFolder work;
  const std::string script =
      "for f in / /tmp /dev /dev/shm /etc /usr; do touch $f/x && echo $f; done";
  Job with_room = shell(script);
  with_room.scratch_mb = 1;

  BOOST_TEST(run(work, shell(script)).output == "");
  BOOST_TEST(run(work, with_room).output == "/tmp\n");
}

BOOST_AUTO_TEST_CASE(room_is_what_was_given_and_empty_each_time) {
  const TemporaryFolder work;
  Job job = shell("ls /tmp; yes | head -c 2000000 > /tmp/a || wc -c < /tmp/a");
  job.scratch_mb = 1;
  job.file_kb = 4096;

  BOOST_TEST(run(work, job).output == "1048576\n");
  BOOST_TEST(run(work, job).output == "1048576\n");
}

BOOST_AUTO_TEST_CASE(there_is_no_network_and_no_other_process) {
  const TemporaryFolder work;

  const Ended ended = run(work, shell("bash -c ': >/dev/tcp/127.0.0.1/9'; echo $$"));

  BOOST_TEST(holds(ended.errors, "Operation not permitted"), ended.errors);
  BOOST_TEST(std::stoi(ended.output) <= 4);
}

BOOST_AUTO_TEST_CASE(a_job_that_takes_too_long_is_ended_with_all_it_started) {
  const TemporaryFolder work;
  Job job = shell("trap '' TERM; (trap '' TERM; sleep 100) & sleep 100");
  job.seconds = 1;

  BOOST_TEST((run(work, job).end.ending == Ending::too_slow));
}

BOOST_AUTO_TEST_CASE(output_is_cut_at_its_limit) {
  const TemporaryFolder work;
  Job job = shell("exec yes");
  job.file_kb = 8;

  const Ended ended = run(work, job);

  BOOST_TEST((ended.end.ending == Ending::too_much_output));
  BOOST_TEST(ended.output.size() == 8192U);
}

BOOST_AUTO_TEST_CASE(a_crash_tells_its_signal) {
  const TemporaryFolder work;

  const JobEnd end = run(work, shell("kill -SEGV $$")).end;

  BOOST_TEST((end.ending == Ending::crash));
  BOOST_TEST(end.status == 11);
}

BOOST_AUTO_TEST_CASE(a_status_that_looks_like_a_time_out_is_none) {
  const TemporaryFolder work;

  const JobEnd exited = run(work, shell("exit 124")).end;
  BOOST_TEST((exited.ending == Ending::normal));
  BOOST_TEST(exited.status == 124);
  for (const auto& [signal, number] : {std::pair{"KILL", 9}, std::pair{"XCPU", 24}}) {
    const JobEnd killed = run(work, shell(std::string("kill -") + signal + " $$")).end;
    BOOST_TEST((killed.ending == Ending::crash), signal);
    BOOST_TEST(killed.status == number);
  }
}

BOOST_AUTO_TEST_CASE(a_job_writes_to_files_that_nobody_wrote_before) {
  const TemporaryFolder work;
  work.write("out", "of an earlier job\n");
  fs::create_hard_link(work.path() / "out", work.path() / "kept");

  BOOST_TEST(run(work, shell("echo new")).output == "new\n");

  BOOST_TEST(sys::read_file(work.path() / "kept") == "of an earlier job\n");
}

BOOST_AUTO_TEST_CASE(a_job_that_locks_its_output_is_graded_all_the_same) {
  const TemporaryFolder work;

  const bool is_read_twice = as_nobody(work, [&] {
    for (int i = 0; i < 2; ++i) {
      const Ended ended =
          run_freely(work, shell("echo 1; chmod 0 /proc/self/fd/1 /proc/self/fd/2"));
      if (ended.output != "1\n") return false;
    }
    return true;
  });

  BOOST_TEST(is_read_twice);
}

BOOST_AUTO_TEST_CASE(processes_are_counted_for_each_job) {
  const TemporaryFolder work;
  Job job = shell("for i in 1 2 3 4 5 6 7 8 9; do sleep 0.2 & done 2>/dev/null; wait");
  job.processes = 4;

  BOOST_TEST((run(work, job).end.status != 0));
  job.processes = 20;
  BOOST_TEST(run(work, job).end.status == 0);
}

BOOST_AUTO_TEST_CASE(memory_is_that_of_all_processes_together) {
  const TemporaryFolder work;
  Job job = shell("for i in 1 2 3 4 5 6; do yes | tail -c 150m & done; wait");
  job.seconds = 20;

  const Ended ended = run(work, job);

  BOOST_TEST((ended.end.ending == Ending::too_large), ended.end.status << ": " << ended.errors);
}

BOOST_AUTO_TEST_CASE(the_processors_time_is_that_of_all_processes_together) {
  const TemporaryFolder work;
  Job job = shell("for i in 1 2 3 4; do (while :; do :; done) & done; wait");
  job.seconds = 4;

  const auto begin = std::chrono::steady_clock::now();
  BOOST_TEST((run(work, job).end.ending == Ending::too_slow));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  BOOST_TEST_MESSAGE(time.count() << " s");

  const Child child{.command = job.command,
                    .environment = {"PATH=/usr/bin"},
                    .folder = work.path(),
                    .input = "/dev/null",
                    .output = work.path() / "out",
                    .errors = work.path() / "err",
                    .cpu_seconds = 1};
  BOOST_TEST((run_child(child).excess == Excess::time));
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_there_is_no_error_of_the_grader) {
  const TemporaryFolder work;
  Job job;
  job.command = {"/no/such/program"};

  BOOST_TEST(run(work, job).end.status == 127);
}

BOOST_AUTO_TEST_CASE(without_bubblewrap_nothing_is_graded_and_the_message_names_the_way_out) {
  const TemporaryFolder work;
  work.write("bin/bwrap", "#!/bin/sh\necho no permission >&2\nexit 1\n");
  fs::permissions(work.path() / "bin/bwrap",
                  fs::perms::owner_all | fs::perms::others_exec | fs::perms::others_read);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", ((work.path() / "bin").string() + ":" + path).c_str(), 1);

  BOOST_TEST(message_of<sys::ToolError>([&] { Sandbox(Isolation::sandbox, work.path()); }) ==
             "bubblewrap cannot keep submissions apart here: no permission");
  ::setenv("PATH", path.c_str(), 1);
}

BOOST_AUTO_TEST_CASE(without_walls_limits_hold) {
  const TemporaryFolder work;
  Job job = shell("exec yes");
  job.file_kb = 8;

  BOOST_TEST((run_freely(work, job).end.ending == Ending::too_much_output));
}

BOOST_AUTO_TEST_CASE(without_walls_a_job_of_root_leaves_no_files) {
  if (::geteuid() != 0) return;  // another user's files are not told from the job's
  const TemporaryFolder work;

  run_freely(work, shell("mkdir /tmp/left-behind-98762 && echo x >/tmp/left-behind-98762/x; "
                         "echo x >/dev/shm/left-behind-98762"));

  BOOST_TEST(!fs::exists("/tmp/left-behind-98762"));
  BOOST_TEST(!fs::exists("/dev/shm/left-behind-98762"));
}

BOOST_AUTO_TEST_CASE(without_walls_and_rights_a_job_writes_to_its_scratch_folder_alone) {
  if (write_fence({"/tmp"}).number() < 0) return;  // the kernel has no Landlock
  const TemporaryFolder work;
  const fs::path mine = work.write("mine", "kept\n");
  fs::permissions(mine, fs::perms::all);
  const std::string outside =
      "for file in /tmp/left-98763 /dev/shm/left-98763 /var/tmp/left-98763; do "
      "echo x >$file; mkdir $file.d; done; "
      "rm -f '" +
      mine.string() + "'; truncate -s 0 '" + mine.string() + "'; ";
  const std::string inside =
      "cd \"$HOME\" && echo x >own && mkdir d && mv own d/own && cat d/own && echo x >/dev/null";

  BOOST_TEST(as_nobody(work, [&] {
    const Ended ended = run_freely(work, shell(outside + inside));
    return ended.end.status == 0 && ended.output == "x\n";
  }));

  for (const char* folder : {"/tmp", "/dev/shm", "/var/tmp"}) {
    BOOST_TEST(!fs::exists(fs::path(folder) / "left-98763"), folder);
    BOOST_TEST(!fs::exists(fs::path(folder) / "left-98763.d"), folder);
  }
  BOOST_TEST(sys::read_file(mine) == "kept\n");
}

BOOST_AUTO_TEST_CASE(without_walls_the_kernels_lists_are_refused_as_within) {
  const TemporaryFolder work;

  BOOST_TEST(as_nobody(work, [&] {
    for (const char* list : {"--shmem 98762", "--semaphore 3", "--queue"}) {
      const Ended ended = run_freely(work, shell(std::string("ipcmk ") + list));
      if (!ended.errors.ends_with("Operation not permitted\n")) return false;
    }
    return true;
  }));
}

BOOST_AUTO_TEST_CASE(a_job_has_no_device_but_null) {
  const TemporaryFolder work;

  const Ended ended = run(work, shell("ls /dev; echo x >/dev/null && wc -c </dev/null"));

  BOOST_TEST(ended.output == "null\n0\n");
  BOOST_TEST(ended.errors == "");
}

BOOST_AUTO_TEST_CASE(without_walls_nothing_is_left_behind) {
  const TemporaryFolder work;

  BOOST_TEST((run_freely(work, shell(leaves_daemons)).end.ending == Ending::normal));
  BOOST_TEST(!is_sleeping("98761"));
}

BOOST_AUTO_TEST_CASE(without_walls_and_rights_nothing_is_left_behind_and_processes_are_counted) {
  const TemporaryFolder work;
  Job many = shell(many_processes);
  many.processes = 8;

  BOOST_TEST(as_nobody(
      work, [&] { return run_freely(work, shell(leaves_daemons)).end.ending == Ending::normal; }));
  BOOST_TEST(!is_sleeping("98761"));
  BOOST_TEST(as_nobody(
      work, [&] { return run_freely(work, many).end.ending == Ending::too_many_processes; }));
}

BOOST_AUTO_TEST_CASE(gradings_at_the_same_time_run_as_different_users) {
  if (::geteuid() != 0) return;
  const unsigned user = job_user();
  BOOST_TEST(job_user() == user);
  const pid_t process = ::fork();
  if (process == 0) ::_exit(job_user() == user ? 1 : 0);
  int status = 1;
  ::waitpid(process, &status, 0);

  BOOST_TEST(status == 0);
}

BOOST_AUTO_TEST_CASE(without_walls_a_job_cannot_reach_the_folder_of_another_grading) {
  if (::geteuid() != 0) return;
  const ScratchFolder scratch;
  const Sandbox sandbox(Isolation::none, scratch.path());
  std::ofstream(scratch.path() / "secret") << "hidden\n";
  const TemporaryFolder work;
  const pid_t other = ::fork();
  if (other == 0) {
    run_freely(work, shell("cat '" + (scratch.path() / "secret").string() + "'; ls '" +
                           scratch.path().parent_path().string() + "'"));
    ::_exit(0);
  }
  ::waitpid(other, nullptr, 0);

  BOOST_TEST(sys::read_file(work.path() / "out") == "");
}

BOOST_AUTO_TEST_CASE(a_killed_grading_takes_its_job_and_what_that_started_along) {
  const std::string script = "setsid sh -c 'trap \"\" TERM; sleep 98764 & wait' & sleep 98762";
  for (const bool has_walls : {true, false}) {
    const TemporaryFolder work;
    const pid_t process = ::fork();
    if (process == 0) {
      ::setpgid(0, 0);
      Job job = shell(script);
      job.seconds = 50;
      run(work, job, has_walls ? Isolation::sandbox : Isolation::none);
      ::_exit(0);
    }
    const auto wait_for = [](const char* seconds, bool is_there) {
      for (int i = 0; i < 1500 && is_sleeping(seconds) != is_there; ++i) ::usleep(10'000);
      return is_sleeping(seconds) == is_there;
    };
    BOOST_TEST(wait_for("98762", true));
    BOOST_TEST(wait_for("98764", true));
    ::kill(-process, SIGKILL);
    ::waitpid(process, nullptr, 0);

    BOOST_TEST(wait_for("98762", false));
    BOOST_TEST(wait_for("98764", false));
  }
}

BOOST_AUTO_TEST_CASE(what_a_killed_grading_left_goes_at_the_next) {
  std::array<int, 2> pipe{};
  BOOST_REQUIRE(::pipe(pipe.data()) == 0);
  const pid_t process = ::fork();
  if (process == 0) {
    const ScratchFolder scratch;
    const std::string path = scratch.path().string();
    const auto n = ::write(pipe[1], path.data(), path.size());
    ::kill(::getpid(), n > 0 ? SIGKILL : SIGTERM);
  }
  ::waitpid(process, nullptr, 0);
  std::string left(200, '\0');
  left.resize(static_cast<std::size_t>(::read(pipe[0], left.data(), left.size())));
  ::close(pipe[0]);
  ::close(pipe[1]);
  BOOST_TEST_REQUIRE(fs::exists(left));

  const ScratchFolder mine;
  const ScratchFolder other;

  BOOST_TEST(!fs::exists(left));
  BOOST_TEST(fs::exists(mine.path()));
}

BOOST_AUTO_TEST_SUITE_END()
