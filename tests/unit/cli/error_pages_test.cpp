#include "cli/text/error_pages.h"
#include <gtest/gtest.h>
#include <suture/base/errors.h>

namespace suture::cli {
namespace {

TEST(ErrorPages, EachTextLeadsToItsOwnPage) {
  for (unsigned number = 1; number <= static_cast<unsigned>(kLastErrc); ++number) {
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

TEST(ErrorPages, ASetUpMessageHasItsRow) {
  EXPECT_EQ(
      explainError("connecting 'A/B': it is already connected: A/B -> C/D. A required interface"),
      "why it happens: A required interface has one provider, so a second connection would have to "
      "end the first.\n"
      "what to do: Call `disconnect()` first, or add another required interface.\n"
      "others like it: suture why set-up-connections\n");
  EXPECT_EQ(explainError("starting 'G': no task lends it a thread. Call lend()").rfind("why it", 0),
            0u);
  EXPECT_EQ(explainError("anything: something else. Do this"), "");
}

TEST(ErrorPages, ARunningProcesssLineHasItsRow) {
  const std::string row = explainError(
      "robot: connection 'a:B/C -> d:E/F' is lost, silent: its process has not answered for 2000 "
      "ms. It is connected anew when that process goes on");
  EXPECT_TRUE(row.starts_with("why it happens: The other process is stopped")) << row;
  EXPECT_TRUE(row.ends_with("others like it: suture why running\n")) << row;
}

TEST(ErrorPages, OneRowMayBeAboutSeveralMessages) {
  const std::string one = explainError("keep keys in /x: no. Give a folder in one that exists.");
  EXPECT_NE(one, "");
  EXPECT_EQ(explainError("write /x/ca.key: no. Give another folder."), one);
}

TEST(ErrorPages, AToldQuestionLeadsToItsRow) {
  const std::string message =
      "f.json:3: error: lane \"shm\" needs a global manager, and key "
      "'manager' is missing; give its address, or use lane \"auto\"";
  EXPECT_EQ(whatToAsk(message),
            "suture why \"\\\" needs a global manager, and key 'manager' is missing\"");
  EXPECT_EQ(explainError("\" needs a global manager, and key 'manager' is missing"),
            explainError(message));
  EXPECT_EQ(whatToAsk("component 'A' was asked to stop: it is still running. Its run() has to"),
            "suture why \"it is still ...\"");
  EXPECT_NE(explainError("it is still ..."), "");
  EXPECT_EQ(whatToAsk("anything: something else. Do this"), "");
}

TEST(ErrorPages, AGuessedNameNeedsNoMoreWords) {
  EXPECT_EQ(whatToAsk("find verb 'pss': there are 'ps' and 'read'. Did you mean 'ps'?"), "");
}

}  // namespace
}  // namespace suture::cli
