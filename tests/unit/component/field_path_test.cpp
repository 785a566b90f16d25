#include <gtest/gtest.h>
#include <suture/base/field_path.h>

#include <string>

namespace suture {
namespace {

TEST(FieldPath, ReadsAsCxxDoes) {
  FieldPath path;
  EXPECT_TRUE(path.empty());
  EXPECT_EQ(path.text(), "");
  path.enterMember("x");
  path.enterElement(2);
  path.enterMember("lower");
  path.enterKey("left");
  path.enterKey(-1);
  path.enterMember("bounds");
  EXPECT_EQ(path.text(), "bounds[-1][\"left\"].lower[2].x");
  EXPECT_FALSE(path.empty());
}

TEST(FieldPath, KnowsItsOutermostMember) {
  FieldPath path;
  path.enterMember("goal");
  path.enterMember("servo_cp");
  EXPECT_TRUE(path.beginsWith("servo_cp"));
  EXPECT_FALSE(path.beginsWith("servo"));
  EXPECT_FALSE(path.beginsWith("servo_cp.goal.pose"));
  FieldPath alone;
  alone.enterMember("distance");
  EXPECT_TRUE(alone.beginsWith("distance"));
  EXPECT_FALSE(FieldPath().beginsWith("distance"));
}

TEST(FieldPath, LosesItsOuterPartWhenLong) {
  FieldPath path;
  path.enterMember("length");
  for (int i = 0; i < 100; ++i) {
    path.enterElement(7);
    path.enterMember("children");
  }
  EXPECT_TRUE(path.text().starts_with("...")) << path.text();
  EXPECT_TRUE(path.text().ends_with("children[7].children[7].length")) << path.text();
  EXPECT_LT(path.text().size(), 128u);
}

// A map's keys may come from another process, and the path is shown on a terminal.
TEST(FieldPath, AKeySteersNoTerminal) {
  FieldPath path;
  path.enterKey("a\x1b[2J\n");
  EXPECT_EQ(path.text(), "[\"a?[2J?\"]");
  FieldPath longer;
  longer.enterKey(std::string(1000, 'k'));
  EXPECT_EQ(longer.text(), "[\"" + std::string(32, 'k') + "...\"]");
}

TEST(FieldPath, ACheckIsNotAskedForIt) {
  EXPECT_FALSE(refusedAt(nullptr, "x"));
  FieldPath path;
  EXPECT_FALSE(refusedAt(&path, "x"));
  EXPECT_EQ(path.text(), "x");
}

}  // namespace
}  // namespace suture
