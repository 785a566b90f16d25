// These compare what `suturec diff` says of two schemas.

#include "compiler/lock/differences.h"

#include <gtest/gtest.h>

#include "compiler/lock/schema/parse.h"

namespace suture::compiler::lock {
namespace {

constexpr char kHead[] = "@0x8000000000000001;\nusing Meta = import \"/suture/meta.capnp\";\n";
constexpr char kOldSchema[] =
    "enum Mode @0x8000000000000002 { off @0; on @1; }\n"
    "struct Pose @0x8000000000000003 {\n"
    "  x @0 :Float64 $Meta.unit(\"m\");\n"
    "  y @1 :Float64 = 2;\n"
    "}\n"
    "interface Arm @0x8000000000000004 {\n"
    "  move @0 (goal :Pose) -> () $Meta.kind(\"write\") $Meta.queue(4);\n"
    "}\n";

struct Edited {
  const char* from;  ///< in kOldSchema, what becomes
  const char* to;
  Effect effect;
  const char* text;
};

class Differences : public testing::TestWithParam<Edited> {};

TEST_P(Differences, AreToldInWords) {
  std::string now = kOldSchema;
  const std::size_t place = now.find(GetParam().from);
  ASSERT_NE(place, std::string::npos);
  now.replace(place, std::string(GetParam().from).size(), GetParam().to);
  const auto found = differences(parse("old", std::string(kHead) + kOldSchema),
                                 parse("new", std::string(kHead) + now));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text(), GetParam().text);
  EXPECT_EQ(found[0].effect, GetParam().effect);
}

INSTANTIATE_TEST_SUITE_P(
    Lock, Differences,
    testing::Values(
        Edited{"on @1;", "on @1; fast @2;", Effect::Refusals,
               "'fast' of enum Mode is new; peers of before refuse a message that has it"},
        Edited{"x @0 ", "east @0 ", Effect::None, "'x' of struct Pose is called 'east' now"},
        Edited{"y @1 :Float64 = 2;", "removed1 @1 :Float64 = 2 $Meta.removed(\"y\");", Effect::None,
               "'y' of struct Pose was removed; its place is kept"},
        Edited{"y @1 :Float64 = 2;\n", "y @1 :Float64 = 2; z @2 :Float64;\n", Effect::None,
               "'z' of struct Pose is new"},
        Edited{"unit(\"m\")", "unit(\"m\") $Meta.range(lowest = 0, highest = 1)", Effect::Refusals,
               "'x' of struct Pose: range (lowest = 0, highest = 1) instead of none; each side "
               "refuses what lies outside its own"},
        Edited{"queue(4)", "queue(8)", Effect::None,
               "'move' of interface Arm: queue 8 instead of 4"},
        Edited{"goal :Pose)", "goal :Pose, speed :Float64)", Effect::None,
               "parameter 'speed' of 'move' of interface Arm is new"},
        Edited{"unit(\"m\")", "unit(\"mm\")", Effect::Break,
               "'x' of struct Pose: unit \"mm\" instead of \"m\""},
        Edited{"x @0 :Float64", "x @0 :Float32", Effect::Break,
               "'x' of struct Pose: type Float32 instead of Float64"},
        Edited{" = 2", " = 3", Effect::Break, "'y' of struct Pose: default 3 instead of 2"},
        Edited{"  y @1 :Float64 = 2;\n", "", Effect::Break,
               "'y' of struct Pose is gone without a trace"},
        Edited{"(goal :Pose)", "()", Effect::Break,
               "parameter 'goal' of 'move' of interface Arm is gone"},
        Edited{"kind(\"write\")", "kind(\"void\")", Effect::Break,
               "'move' of interface Arm: kind \"void\" instead of \"write\""},
        Edited{"off @0; on @1;", "off @0; removed1 @1 $Meta.removed(\"on\");", Effect::Refusals,
               "'on' of enum Mode was removed; peers of now refuse a message that has it"},
        Edited{"queue(4)", "queue(4) $Meta.latest", Effect::None,
               "'move' of interface Arm: latest given instead of none"},
        Edited{"000004 {", "000004 $Meta.version(2) {", Effect::Break,
               "interface Arm: version 2 instead of none; peers of the two refuse each other"},
        Edited{"000004 {", "000004 extends(Base) {", Effect::Break,
               "interface Arm has another base; peers of before know it without"},
        Edited{"000004 {", "000004 $Meta.major(2) {", Effect::Break,
               "interface Arm: major 2 instead of 1; peers of the two refuse each other"},
        Edited{"move @0 (goal :Pose) -> () $Meta.kind(\"write\") $Meta.queue(4);",
               "removed0 @0 (goal :Pose) -> () $Meta.removed(\"move\");", Effect::Break,
               "'move' of interface Arm was removed; who calls it is told so"}));

std::vector<std::string> textsOf(const std::string& old, const std::string& now) {
  std::vector<std::string> texts;
  const Lock before = parse("old", kHead + old), after = parse("new", kHead + now);
  for (const Difference& one : differences(before, after)) texts.push_back(one.text());
  return texts;
}

TEST(Differences, ARenamedParameterIsGoneAndNew) {
  std::string now = kOldSchema;
  now.replace(now.find("goal"), 4, "target");
  EXPECT_EQ(textsOf(kOldSchema, now),
            (std::vector<std::string>{"parameter 'goal' of 'move' of interface Arm is gone",
                                      "parameter 'target' of 'move' of interface Arm is new"}));
}

TEST(Differences, OnlyTheRemovedParameterIsTold) {
  const std::string old = "interface Arm @0x8000000000000004 { move @0 (a :Bool, b :Bool) -> (); }";
  const std::string now = "interface Arm @0x8000000000000004 { move @0 (b :Bool) -> (); }";
  EXPECT_EQ(textsOf(old, now),
            std::vector<std::string>{"parameter 'a' of 'move' of interface Arm is gone"});
}

TEST(Differences, ExchangedParametersHaveOtherPlaces) {
  const std::string old = "interface Arm @0x8000000000000004 { move @0 (a :Bool, b :Bool) -> (); }";
  const std::string now = "interface Arm @0x8000000000000004 { move @0 (b :Bool, a :Bool) -> (); }";
  EXPECT_EQ(textsOf(old, now).size(), 2u);
}

TEST(Differences, SomethingRenamedWithoutWasIsGuessed) {
  const std::string old = "struct Pose @0x8000000000000003 { x @0 :Float64; }";
  const std::string now =
      "struct Pose @0x8000000000000003 { removed0 @0 :Float64 $Meta.removed(\"x\"); y @1 :Float64; "
      "}";
  EXPECT_EQ(textsOf(old, now).back(),
            "'y' of struct Pose is new; if it is 'x' under another name, say was(\"x\")");
}

TEST(Differences, ACppDefaultsDifferenceIsTold) {
  const std::string old = "struct Pose @0x8000000000000003 { x @0 :Float64 = 2; }";
  const std::string now =
      "struct Pose @0x8000000000000003 { x @0 :Float64 = 2 $Meta.default(\"3\"); }";
  EXPECT_EQ(textsOf(old, now),
            std::vector<std::string>{"'x' of struct Pose: default 3 instead of 2; where a message "
                                     "does not have it, it still is 2"});
}

TEST(Differences, ARenamedTypeStaysTheSame) {
  std::string now = kOldSchema;
  for (std::size_t at; (at = now.find("Pose")) != std::string::npos;) now.replace(at, 4, "Place");
  const auto found = differences(parse("old", std::string(kHead) + kOldSchema),
                                 parse("new", std::string(kHead) + now));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text(), "struct Pose is called Place now");
  EXPECT_EQ(found[0].effect, Effect::None);
}

TEST(Differences, EqualFilesHaveNone) {
  const Lock lock = parse("old", std::string(kHead) + kOldSchema);
  EXPECT_TRUE(differences(lock, lock).empty());
}

}  // namespace
}  // namespace suture::compiler::lock
