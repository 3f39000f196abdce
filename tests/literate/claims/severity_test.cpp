// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/severity.hpp"

#include <boost/test/unit_test.hpp>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(severity_test)

using literate::digest_of_code;
using literate::read_severity;

namespace {

// A checkout with code, a case, and the record of three faults.
struct Checkout {
  Checkout() {
    write("src/a.cpp", "int a = 1;  // one\n");
    write("case.toml", "side = 3\n");
    write_record(
        "claim,sign,factor,case\nlonger,refuted,,gone\nfar,,,\n\"(program)\",ended,ended,\n");
  }
  void write(const std::string& name, const std::string& text) const {
    sys::write_file_atomically(folder / name, text);
  }
  void write_record(const std::string& rows) const {
    write("severity.csv", "# " + digest_of_code(folder.path(), {"src", "case.toml"}) +
                              " of src:case.toml\n" + rows);
  }
  std::optional<literate::Severity> read(const std::string& case_file = "case.toml") const {
    return read_severity(folder / "severity.csv", folder.path(), folder / case_file);
  }

  TemporaryFolder folder;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_record_tells_how_many_faults_turn_each_claim) {
  const auto severity = Checkout().read();

  BOOST_TEST_REQUIRE(severity.has_value());
  BOOST_TEST(severity->text_of("longer") == "2 of 3 faults");
  BOOST_TEST(severity->text_of("far") == "none of 3 faults");
  BOOST_TEST(severity->text_of("new") == "not known");
  BOOST_TEST(severity->summary() ==
             "Of 3 planted faults the verdicts show 2; internal checks, or an abort of the "
             "program, show 1 more; "
             "nothing here shows the other 0.");
}

BOOST_AUTO_TEST_CASE(the_digest_is_that_which_the_script_computes) {
  const Checkout checkout;
  BOOST_TEST(digest_of_code(checkout.folder.path(), {"src", "case.toml"}) ==
             "9c72fe8173df2cec29647e97bc78aa0bf5647a4da597a63a528c377d584c3690");
}

BOOST_AUTO_TEST_CASE(a_record_of_other_code_tells_nothing) {
  const Checkout checkout;
  checkout.write("src/a.cpp", "int a = 2;  // one\n");
  BOOST_TEST(!checkout.read());

  checkout.write("src/a.cpp", "int a = 1;  // one\n");
  BOOST_TEST(checkout.read().has_value());

  for (const auto* other : {"int a = 1;  // two\n", "int a = 1;  //one\n"}) {
    checkout.write("src/a.cpp", other);
    BOOST_TEST(!checkout.read(), other);
  }

  checkout.write("src/a.cpp", "int a = 1;  // one\n");
  checkout.write("src/b.cpp", "int b = 1;\n");
  BOOST_TEST(!checkout.read());
}

BOOST_AUTO_TEST_CASE(a_record_of_another_case_or_none_tells_nothing) {
  const Checkout checkout;
  checkout.write("other.toml", "side = 3\n");
  BOOST_TEST(!checkout.read("other.toml"));
  BOOST_TEST(!read_severity(checkout.folder / "none.csv", checkout.folder.path(),
                            checkout.folder / "case.toml"));
  std::filesystem::remove_all(checkout.folder / "src");
  BOOST_TEST(!checkout.read());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_record_is_refused_with_its_name) {
  const Checkout checkout;
  for (const char* text : {"", "claim,sign\n", "# 12 of src:case.toml\nclaim,sign\n"}) {
    checkout.write("severity.csv", text);
    const std::string message = message_of<sys::SourceError>([&] { checkout.read(); });
    BOOST_TEST(holds(message, "severity.csv:1:1: "));
  }
  checkout.write_record("");
  BOOST_CHECK_THROW(checkout.read(), sys::SourceError);
  checkout.write_record("claim,sign\nlonger\n");
  BOOST_CHECK_THROW(checkout.read(), sys::SourceError);
  checkout.write_record("claim,sign,factor\nlonger,undecided,bogus\n");
  BOOST_TEST(message_of<sys::SourceError>([&] { checkout.read(); }) ==
             (checkout.folder / "severity.csv").string() +
                 ":3:18: 'bogus' is no verdict; 'make severity' writes it");
}

BOOST_AUTO_TEST_SUITE_END()
