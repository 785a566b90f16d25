// What `suturec diff` says of two schemas.

#include "compiler/lock/differences.h"

#include <gtest/gtest.h>

#include "compiler/lock/parse.h"

namespace suture::compiler::lock {
namespace {

constexpr char kHead[] = "@0x8000000000000001;\nusing Meta = import \"/suture/meta.capnp\";\n";
constexpr char kOld[] =
    "enum Mode @0x8000000000000002 { off @0; on @1; }\n"
    "struct Pose @0x8000000000000003 {\n"
    "  x @0 :Float64 $Meta.unit(\"m\");\n"
    "  y @1 :Float64 = 2;\n"
    "}\n"
    "interface Arm @0x8000000000000004 {\n"
    "  move @0 (goal :Pose) -> () $Meta.kind(\"write\") $Meta.queue(4);\n"
    "}\n";

struct Change {
  const char* from;  ///< in kOld, what becomes
  const char* to;
  bool breaks;
  const char* text;
};

class Differences : public testing::TestWithParam<Change> {};

TEST_P(Differences, AreToldInWords) {
  std::string now = kOld;
  const std::size_t place = now.find(GetParam().from);
  ASSERT_NE(place, std::string::npos);
  now.replace(place, std::string(GetParam().from).size(), GetParam().to);
  const auto found =
      differences(parse("old", std::string(kHead) + kOld), parse("new", std::string(kHead) + now));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, GetParam().text);
  EXPECT_EQ(found[0].breaks, GetParam().breaks);
}

INSTANTIATE_TEST_SUITE_P(
    Lock, Differences,
    testing::Values(
        Change{"on @1;", "on @1; fast @2;", false,
               "'fast' of enum Mode is new; peers of before refuse a message that has it"},
        Change{"x @0 ", "east @0 ", false, "'x' of struct Pose is called 'east' now"},
        Change{"y @1 :Float64 = 2;", "removed1 @1 :Float64 = 2 $Meta.removed(\"y\");", false,
               "'y' of struct Pose was removed; its place is kept"},
        Change{"y @1 :Float64 = 2;\n", "y @1 :Float64 = 2; z @2 :Float64;\n", false,
               "'z' of struct Pose is new"},
        Change{"queue(4)", "queue(8)", false, "'move' of interface Arm: queue 8 instead of 4"},
        Change{"goal :Pose)", "goal :Pose, speed :Float64)", false,
               "parameter 'speed' of 'move' of interface Arm is new"},
        Change{"unit(\"m\")", "unit(\"mm\")", true,
               "'x' of struct Pose: unit \"mm\" instead of \"m\""},
        Change{"x @0 :Float64", "x @0 :Float32", true,
               "'x' of struct Pose: type Float32 instead of Float64"},
        Change{" = 2", " = 3", true, "'y' of struct Pose: default 3 instead of 2"},
        Change{"  y @1 :Float64 = 2;\n", "", true, "'y' of struct Pose is gone without a trace"},
        Change{"(goal :Pose)", "()", true, "parameter 'goal' of 'move' of interface Arm is gone"},
        Change{"kind(\"write\")", "kind(\"void\")", true,
               "'move' of interface Arm: kind \"void\" instead of \"write\""},
        Change{"000004 {", "000004 $Meta.major(2) {", true,
               "interface Arm: major 2 instead of 1; peers of the two refuse each other"},
        Change{"move @0 (goal :Pose) -> () $Meta.kind(\"write\") $Meta.queue(4);",
               "removed0 @0 (goal :Pose) -> () $Meta.removed(\"move\");", true,
               "'move' of interface Arm was removed; who calls it is told so"}));

TEST(Differences, ARenamedTypeIsTheSameWhereItIsUsed) {
  std::string now = kOld;
  for (std::size_t at; (at = now.find("Pose")) != std::string::npos;) now.replace(at, 4, "Place");
  const auto found =
      differences(parse("old", std::string(kHead) + kOld), parse("new", std::string(kHead) + now));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, "struct Pose is called Place now");
  EXPECT_FALSE(found[0].breaks);
}

TEST(Differences, EqualFilesHaveNone) {
  const Lock lock = parse("old", std::string(kHead) + kOld);
  EXPECT_TRUE(differences(lock, lock).empty());
}

}  // namespace
}  // namespace suture::compiler::lock
