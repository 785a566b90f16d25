// Each error has a text of its own, and so does its absence.
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/base/plain.h>

#include <set>
#include <string>

namespace suture {
namespace {

TEST(Errors, HaveDifferentTexts) {
  constexpr auto kLast = static_cast<int>(kLastErrc);
  std::set<std::string> texts;
  for (int code = 0; code <= kLast; ++code) texts.insert(toString(static_cast<Errc>(code)));
  EXPECT_EQ(texts.size(), std::size_t{kLast} + 1);
  EXPECT_FALSE(texts.contains("unknown error"));
}

TEST(Errors, AreExplainedByAShellCommand) {
  const std::string several =
      "d.json:3: error: no class 'A'; add \"library\"\nd.json:4: error: more";
  EXPECT_EQ(explained(several),
            several + "\n`suture why \"no class 'A'; add \\\"library\\\"\"` tells more");
  EXPECT_EQ(explained("open $HOME: `no`\x1b"),
            "open $HOME: `no`\x1b\n`suture why \"open \\$HOME: \\`no\\`?\"` tells more");
}

TEST(Errors, AreNoneWhereTheCodeIsZero) { EXPECT_STREQ(toString(Errc{}), "no error"); }

}  // namespace
}  // namespace suture
