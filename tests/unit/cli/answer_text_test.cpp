#include "cli/text/answer_text.h"
#include <gtest/gtest.h>

namespace suture::cli {
namespace {

Member member(const char* description) {
  return {.name = "width", .kind = "read", .description = Json::parse(description), .method = {}};
}

TEST(AnswerText, NumbersHaveTheirUnit) {
  const Member width = member(R"({"result": {"type": {"kind": "Float64"}, "unit": "m"}})");
  EXPECT_EQ(answerText(width, {.value = 0.25, .age = {}}), "0.25 m\n");
  EXPECT_EQ(answerText(width, {.value = 0.25, .age = std::chrono::milliseconds(3)}),
            "0.25 m, 3.0 ms old\n");
  EXPECT_EQ(unitOf(member(R"({"payload": {"unit": "rad"}})"), {1, 2}), " rad");
}

TEST(AnswerText, NothingElseHasAUnitBehindIt) {
  const Member pose = member(R"({"result": {"unit": "m"}})");
  EXPECT_EQ(unitOf(pose, {{"x [m]", 1}}), "");  // a struct's members have theirs
  EXPECT_EQ(answerText(pose, {}), "done\n");
  EXPECT_EQ(answerText(member("{}"), {.value = true, .age = {}}), "true\n");
  EXPECT_EQ(unitOf(member(R"({"payload": [{"unit": "m"}, {"unit": "s"}]})"), {1, 2}), "");
}

}  // namespace
}  // namespace suture::cli
