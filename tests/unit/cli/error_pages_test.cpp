#include "cli/text/error_pages.h"
#include <gtest/gtest.h>
#include <suture/base/errors.h>

namespace suture::cli {
namespace {

TEST(ErrorPages, EachTextLeadsToItsOwnPage) {
  for (unsigned number = 1; number <= static_cast<unsigned>(Errc::NotPermitted); ++number) {
    const std::string text = toString(static_cast<Errc>(number));
    const std::string title = "# " + text + ": `Errc::";
    EXPECT_TRUE(errorPage(text).starts_with(title)) << text;
    EXPECT_TRUE(errorPage("call open of a:B/C: " + text + ": width. Do").starts_with(title));
  }
}

TEST(ErrorPages, NamesLeadToTheirPage) {
  const std::string_view page = errorPage("not produced yet");
  EXPECT_EQ(errorPage("NotYet"), page);
  EXPECT_EQ(errorPage("not-yet"), page);
  EXPECT_EQ(errorPage("Errc::NotYett"), "");
  EXPECT_EQ(errorPage(""), "");
}

}  // namespace
}  // namespace suture::cli
