// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/images.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(images_test)

using namespace literate;

namespace {

/// A document with one picture beside it.
class Paper {
 public:
  explicit Paper(const std::string& latex) {
    sys::write_file_atomically(folder_ / "paper/a.tex", latex);
    sys::write_file_atomically(folder_ / "paper/pictures/rig.png", "picture");
    sys::write_file_atomically(folder_ / "elsewhere.png", "picture");
  }
  Images images() const { return images_of(folder_ / "paper"); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(each_picture_is_listed_once) {
  const Images images = Paper(
                            "\\image[width=3cm]{pictures/rig.png}\n"
                            "\\includegraphics{./pictures/rig.png} % \\image{none.png}\n"
                            "\\includegraphics{logo}\n")
                            .images();

  BOOST_TEST(images.errors.empty());
  BOOST_TEST(images.files == std::vector<std::string>{"pictures/rig.png"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_picture_that_is_missing_or_cannot_be_one_is_told_with_its_place) {
  const auto error = [](const std::string& file) {
    return Paper("One.\n  \\image{" + file + "}\n").images().errors.at(0);
  };
  BOOST_TEST(error("pictures/rug.png") ==
             "paper/a.tex:2:3: picture 'pictures/rug.png' is not there");
  BOOST_TEST(error("../elsewhere.png").find("outside the document's folder") != std::string::npos);
  BOOST_TEST(error("a.tex").find("is no .png, .jpg or .pdf file") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
