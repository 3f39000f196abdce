// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/script_check.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(script_check_test)

using namespace literate;

namespace {

std::string refusal_of(const std::string& script) {
  return message_of<sys::InputError>([&] { require_draws_only(script, "figures/f.gp"); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_command_by_which_a_script_would_do_more_than_draw_is_refused_at_its_line) {
  for (const std::string command :
       {"set output 'x'", "set out", "set terminal png", "set term x11", "set print 'x'",
        "set table 'x'", "save 'x'", "system 'ls'", "!ls", "load 'x'", "call 'x'", "cd '..'",
        "a = 1; set output 'x'", "a = system('ls')", "a = `ls`"}) {
    BOOST_TEST(refusal_of("set grid\n" + command + "\n").starts_with("figures/f.gp:2: "), command);
  }
}

BOOST_AUTO_TEST_CASE(what_only_looks_like_such_a_command_is_left_alone) {
  for (const std::string command :
       {"plot f title 'fitted load'", "# set output 'x'", "set tics out nomirror",
        "set tics nomirror out scale 0.6", "set table $contours separator comma",
        "set key outside right", "loads = 2"}) {
    BOOST_TEST(refusal_of(command) == "(no error)", command);
  }
}

BOOST_AUTO_TEST_SUITE_END()
