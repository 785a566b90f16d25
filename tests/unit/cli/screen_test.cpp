#include "cli/text/screen.h"
#include <gtest/gtest.h>

namespace suture::cli {
namespace {

TEST(Screen, ATextCannotSteerTheTerminal) {
  EXPECT_EQ(plain("a\x1b[2Jb\x07\x7f"), "a?[2Jb??");
  EXPECT_EQ(plain("a\xc2\x9b"
                  "2Jb"),
            "a?2Jb");  // U+009B, as good as escape and bracket
  EXPECT_EQ(plain("\xc3\xa9t\xc3\xa9\tline\n"), "\xc3\xa9t\xc3\xa9\tline\n");
}

TEST(Screen, ShowsShortValuesOnOneLine) {
  EXPECT_EQ(valueText(Json::parse(R"({"a": [1, 2], "long": {"x": 1, "y": "t"}})")),
            "a     [1, 2]\nlong  {x: 1, y: \"t\"}\n");
  EXPECT_EQ(valueText(Json(42)), "42\n");
  EXPECT_EQ(valueText(Json(-0.09350000000000003)), "-0.0935\n");
  EXPECT_EQ(valueText(Json(1.0)), "1.0\n") << "it is no whole number";
  EXPECT_EQ(valueText(Json(1.1248198369963932e-32)), "1.12482e-32\n");
  EXPECT_EQ(valueText(Json::object()), "{}\n");
}

TEST(Screen, BreaksLongLists) {
  Json numbers = Json::array();
  for (int i = 0; i < 100; ++i) numbers.push_back(1000 + i);
  const std::string text = valueText({{"numbers", numbers}});
  EXPECT_EQ(text.rfind("numbers\n  1000 1001 ", 0), 0u);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    EXPECT_LE(text.find('\n', begin) - begin, 100u);
  }
}

TEST(Screen, ShowsAPoseAsAMatrix) {
  const Json pose = Json::parse(
      R"({"m00":1,"m01":0,"m02":0,"m10":0,"m11":1,"m12":0,"m20":0,"m21":0,"m22":10,"x":1,"y":2,"z":3})");
  EXPECT_EQ(valueText(pose), "1  0  0   | 1\n0  1  0   | 2\n0  0  10  | 3\n");
}

TEST(Screen, TakesAnyShapeOfAMatrix) {
  EXPECT_EQ(valueText(Json::parse(R"({"m00": 1})")), "m00  1\n");
  EXPECT_EQ(valueText(Json::parse(R"({"m00":1,"a":0,"b":0,"c":0,"d":0,"e":0,"f":0,"g":0,"h":0})"))
                .substr(0, 6),
            "m00  1");
}

}  // namespace
}  // namespace suture::cli
