// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/tool.hpp"

#include <boost/test/unit_test.hpp>

#include "messages.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(tool_test)

BOOST_AUTO_TEST_CASE(a_tool_is_found_in_the_path_or_named_in_an_error) {
  BOOST_TEST(sys::find_tool("sh").filename() == "sh");
  BOOST_TEST(message_of<sys::ToolError>([] { sys::find_tool("no-such-tool"); }) ==
             "no-such-tool is not installed: run `make setup`");
}

BOOST_AUTO_TEST_SUITE_END()
