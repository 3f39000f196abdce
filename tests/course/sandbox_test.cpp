// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "course/student_text.hpp"
#include "literate/error.hpp"
#include "literate/files.hpp"
#include "temporary_file.hpp"

using namespace course;
namespace fs = std::filesystem;

namespace {

struct Ended {
  JobEnd end;
  std::string output, errors;
};

Ended run(const TemporaryFolder& work, Job job) {
  const Sandbox sandbox(Isolation::sandbox, work.path());
  job.output = work.path() / "out";
  job.errors = work.path() / "err";
  const JobEnd end = sandbox.run(job);
  return {end, literate::read_file(job.output), literate::read_file(job.errors)};
}

Job shell(const std::string& script) {
  Job job;
  job.command = {"/bin/sh", "-c", script};
  job.seconds = 3;
  job.memory_mb = 256;
  return job;
}

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

  const Ended ended = run(work, shell("cat '" + secret.string() + "'; ls / /proc/1/root /tmp"));

  BOOST_TEST(ended.output.find("hidden") == std::string::npos);
  BOOST_TEST(ended.output.find("root") == ended.output.find("root:"));
  BOOST_TEST(!shown(ended.errors, 100).empty());
}

BOOST_AUTO_TEST_CASE(a_job_inherits_no_environment) {
  const TemporaryFolder work;
  ::setenv("HALFSPACE_SECRET", "hidden", 1);

  const Ended ended = run(work, shell("env; cat /proc/*/environ"));

  BOOST_TEST(ended.output.find("hidden") == std::string::npos);
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
  Job job = shell("ls /tmp; head -c 2000000 /dev/zero > /tmp/a || wc -c < /tmp/a");
  job.scratch_mb = 1;
  job.file_kb = 4096;

  BOOST_TEST(run(work, job).output == "1048576\n");
  BOOST_TEST(run(work, job).output == "1048576\n");
}

BOOST_AUTO_TEST_CASE(there_is_no_network_and_no_other_process) {
  const TemporaryFolder work;

  const Ended ended = run(work, shell("cat /proc/net/route | wc -l; ls -d /proc/[0-9]* | wc -l"));

  BOOST_TEST(ended.output.substr(0, 2) == "1\n");
  BOOST_TEST(std::stoi(ended.output.substr(2)) <= 4);
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
  Job job = shell("for i in 1 2 3 4 5 6; do cat /dev/zero | tail -c 150m & done; wait");
  job.seconds = 20;

  const Ended ended = run(work, job);

  BOOST_TEST((ended.end.ending == Ending::too_large), ended.end.status << ": " << ended.errors);
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

  BOOST_CHECK_EXCEPTION(Sandbox(Isolation::sandbox, work.path()), literate::ToolError,
                        [](const auto& error) {
                          return std::string(error.what()) ==
                                 "bubblewrap cannot keep submissions apart here: no permission; "
                                 "--unsafe grades without it, with limits only";
                        });
  ::setenv("PATH", path.c_str(), 1);
}

BOOST_AUTO_TEST_CASE(without_walls_limits_hold) {
  const TemporaryFolder work;
  const Sandbox sandbox(Isolation::none, work.path());
  Job job = shell("exec yes");
  job.output = work.path() / "out";
  job.errors = work.path() / "err";
  job.file_kb = 8;

  BOOST_TEST((sandbox.run(job).ending == Ending::too_much_output));
}
