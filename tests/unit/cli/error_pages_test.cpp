#include "cli/text/error_pages.h"
#include <gtest/gtest.h>
#include <suture/base/errors.h>

namespace suture::cli {
namespace {

TEST(ErrorPages, EachTextLeadsToItsOwnPage) {
  for (unsigned number = 1; number <= static_cast<unsigned>(Errc::NotPermitted); ++number) {
    const std::string text = toString(static_cast<Errc>(number));
    const std::string title = "# " + text + ": `Errc::";
    EXPECT_TRUE(explainError(text).starts_with(title)) << text;
    EXPECT_TRUE(explainError("call open of a:B/C: " + text + ": width. Do").starts_with(title));
  }
}

TEST(ErrorPages, NamesLeadToTheirPage) {
  const std::string page = explainError("not produced yet");
  EXPECT_EQ(explainError("NotYet"), page);
  EXPECT_EQ(explainError("not-yet"), page);
  EXPECT_EQ(explainError("Errc::NotYett"), "");
  EXPECT_EQ(explainError(""), "");
}

TEST(ErrorPages, AMessageOfSetUpHasItsRow) {
  EXPECT_EQ(
      explainError("connecting 'A/B': it is already connected: A/B -> C/D. A required interface"),
      "why it happens: a required interface has one provider\n"
      "what to do: disconnect first, or add another required interface\n");
  EXPECT_EQ(explainError("starting 'G': no task lends it a thread. Call lend()").rfind("why it", 0),
            0u);
  EXPECT_EQ(explainError("anything: something else. Do this"), "");
}

}  // namespace
}  // namespace suture::cli
