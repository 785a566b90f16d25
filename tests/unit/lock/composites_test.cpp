// These types travel as a struct that no header declares: the tests compare their names, and check
// that the lock guards them.

#include "compiler/lock/schema/composites.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/parse.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/lock/settle.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {
namespace {

using model::Scalar;
using Shape = model::Type::Shape;

model::Type of(Shape shape, std::vector<model::Type> elements) {
  model::Type type;
  type.shape = shape;
  type.element = std::move(elements);
  type.spelling = "composite";
  return type;
}

class CompositesTest : public testing::Test {
 protected:
  CompositesTest() { add(of(Shape::Optional, {sample::number()})); }

  void add(model::Type type) {
    auto& fields = sample::armHeader(model_).structs[0].fields;
    fields.push_back(sample::field("extra" + std::to_string(fields.size()), std::move(type)));
  }

  std::string name(const model::Type& type) {
    const model::Lookup lookup(model_);
    return compositeName(type, lookup, sample::armHeader(model_));
  }

  Locks locks() {
    model::Diagnostics none;
    return read(update(sample::allOwn(model_), {}).files, none);
  }

  Lock lock() { return locks().files.at("robots/arm.capnp"); }

  std::vector<std::string> slugs(const Locks& old) {
    std::vector<std::string> result;
    for (const model::Diagnostic& one : check(model_, old)) result.push_back(one.slug);
    return result;
  }

  model::Type& last() { return sample::armHeader(model_).structs[0].fields.back().type; }

  model::Model model_ = sample::robots();
};

TEST_F(CompositesTest, NamesSayWhatTheyAreMadeOf) {
  const model::Type number = sample::number();
  const model::Type pose = sample::record("robots::PoseStamped");
  EXPECT_EQ(name(of(Shape::Optional, {number})), "RobotsArmOptionalFloat64");
  EXPECT_EQ(name(of(Shape::Map, {sample::text(3), pose})), "RobotsArmEntryOfTextToPoseStamped");
  EXPECT_EQ(name(of(Shape::Tuple, {sample::matrix(3, 1), sample::listOf(number, 2)})),
            "RobotsArmTupleOfVec3AndListOfFloat64");
  EXPECT_EQ(name(of(Shape::Variant, {sample::milliseconds(), sample::steadyTime()})),
            "RobotsArmEitherOfDuration1Per1000Int64OrSteadyTime");
}

TEST_F(CompositesTest, ANumberedFolderGivesNamesALetter) {
  sample::armHeader(model_).path = "03_own_type/arm.h";
  EXPECT_EQ(name(of(Shape::Optional, {sample::number()})), "Header03OwnTypeArmOptionalFloat64");
}

/// Holds two headers of one namespace whose paths make the same prefix.
class TwinHeadersTest : public CompositesTest {
 protected:
  TwinHeadersTest() {
    sample::armHeader(model_).path = "arm.h";
    model::Header twin;
    twin.path = "arm/arm.h";
    twin.cxxNamespace = "robots";
    twin.structs = {sample::structure(
        "robots::Twin", {sample::field("value", of(Shape::Optional, {sample::number()}))})};
    model_.headers.push_back(twin);
  }

  /// Returns the names of the composite in both schemas, and takes them into the locks.
  std::vector<std::string> composites() {
    model_ = settled(model_, locks_);
    model::Diagnostics none;
    locks_ = read(update(sample::allOwn(model_), locks_).files, none);
    const model::Lookup lookup(model_);
    const model::Type type = of(Shape::Optional, {sample::number()});
    return {compositeName(type, lookup, sample::armHeader(model_)),
            compositeName(type, lookup, model_.headers.back())};
  }

  void forgetSettled() {
    for (model::Header& header : model_.headers) header.wirePrefix.clear();
  }

  Locks locks_;
};

TEST_F(TwinHeadersTest, HeadersWithOnePrefixAreToldApart) {
  EXPECT_EQ(composites(), (std::vector<std::string>{"ArmOptionalFloat64", "Arm2OptionalFloat64"}));
  EXPECT_TRUE(slugs(locks_).empty());
}

TEST_F(TwinHeadersTest, TheUsedHeaderKeepsItsPrefix) {
  const model::Header first = sample::armHeader(model_);
  model_.headers.erase(model_.headers.begin());
  model_ = settled(model_, locks_);
  model::Diagnostics none;
  locks_ = read(update(sample::allOwn(model_), locks_).files, none);
  forgetSettled();
  model_.headers.insert(model_.headers.begin(), first);
  EXPECT_EQ(composites(), (std::vector<std::string>{"Arm2OptionalFloat64", "ArmOptionalFloat64"}));
  forgetSettled();
  EXPECT_EQ(composites(), (std::vector<std::string>{"Arm2OptionalFloat64", "ArmOptionalFloat64"}));
}

TEST_F(TwinHeadersTest, LocksThatShareANameAreReported) {
  model::Diagnostics none;
  EXPECT_EQ(slugs(read(update(sample::allOwn(model_), {}).files, none)),
            (std::vector<std::string>{"wire-name-clash"}));
}

TEST_F(CompositesTest, BoundsDoNotChangeAName) {
  EXPECT_EQ(name(of(Shape::Optional, {sample::text(3)})),
            name(of(Shape::Optional, {sample::text(4)})));
}

TEST_F(CompositesTest, AGrowingVariantKeepsItsNumbers) {
  const model::Type number = sample::number(), flag = sample::scalar(Scalar::Bool);
  add(of(Shape::Optional, {of(Shape::Variant, {number, flag})}));
  const Locks old = locks();
  last() = of(Shape::Optional, {of(Shape::Variant, {sample::scalar(Scalar::Int32), flag, number})});
  EXPECT_EQ(slugs(old), (std::vector<std::string>{"lock-renamed", "lock-new", "lock-renamed"}));
  model::Diagnostics none;
  const Lock now = read(update(model_, old).files, none).files.at("robots/arm.capnp");
  const auto grown = std::find_if(now.nodes.begin(), now.nodes.end(), [](const Node& node) {
    return node.name == "RobotsArmEitherOfInt32OrBoolOrFloat64";
  });
  ASSERT_NE(grown, now.nodes.end());
  ASSERT_EQ(grown->members.size(), 3u);
  EXPECT_EQ(grown->members[0].name, "float64");
  EXPECT_EQ(grown->members[2].name, "int32");
  for (const Node& node : now.nodes) EXPECT_FALSE(node.removed()) << node.name;
}

TEST_F(CompositesTest, AVariantNeverLosesAnAlternative) {
  const model::Type number = sample::number(), flag = sample::scalar(Scalar::Bool);
  add(of(Shape::Variant, {number, flag, sample::scalar(Scalar::Int32)}));
  const Locks old = locks();
  last() = of(Shape::Variant, {number, flag});
  const std::vector<std::string> found = slugs(old);
  EXPECT_NE(std::find(found.begin(), found.end(), "lock-break"), found.end());
}

TEST_F(CompositesTest, AlternativesOfOneTypeAreToldApart) {
  const model::Lookup lookup(model_);
  const model::Type type =
      of(Shape::Variant, {sample::number(), sample::text(2), sample::number()});
  EXPECT_EQ(compositeMembers(type, lookup, sample::armHeader(model_)),
            (std::vector<std::string>{"float64", "text", "float64At2"}));
}

TEST_F(CompositesTest, AUnionIsWrittenAndReadBack) {
  const Lock once = lock();
  const auto node = std::find_if(once.nodes.begin(), once.nodes.end(), [](const Node& one) {
    return one.name == "RobotsArmOptionalFloat64";
  });
  ASSERT_NE(node, once.nodes.end());
  EXPECT_TRUE(node->isUnion);
  ASSERT_EQ(node->members.size(), 2u);
  EXPECT_EQ(node->members[1].type, "Float64");
  EXPECT_NE(write(once).find("  union {\n    none @0 :Void;\n"), std::string::npos);
  EXPECT_EQ(write(parse(once.path, write(once))), write(once));
}

TEST_F(CompositesTest, TwoUsesShareOneStruct) {
  add(of(Shape::Optional, {sample::number()}));
  const Lock once = lock();
  EXPECT_EQ(std::count_if(once.nodes.begin(), once.nodes.end(),
                          [](const Node& one) { return one.isUnion; }),
            1);
}

TEST_F(CompositesTest, ThePartsAreGuarded) {
  const Locks old = locks();
  EXPECT_TRUE(slugs(old).empty());
  last() = of(Shape::Optional, {sample::scalar(Scalar::Float32)});
  const std::vector<std::string> found = slugs(old);
  EXPECT_NE(std::find(found.begin(), found.end(), "lock-break"), found.end());
}

TEST_F(CompositesTest, TwoOfOneNameAreAClash) {
  const model::Type number = sample::number();
  const model::Type pair = of(Shape::Tuple, {number, number});
  const model::Type triple = of(Shape::Tuple, {number, number, number});
  add(of(Shape::Tuple, {pair, number, number}));
  add(of(Shape::Tuple, {triple, number}));
  add(of(Shape::Tuple, {triple, number}));
  const model::Type& other = last();
  ASSERT_EQ(name(other), "RobotsArmTupleOfTupleOfFloat64AndFloat64AndFloat64AndFloat64");
  Locks none;
  const std::vector<std::string> found = slugs(none);
  EXPECT_EQ(std::count(found.begin(), found.end(), "wire-name-clash"), 1);
  const model::Diagnostics updated = update(model_, none).diagnostics;
  ASSERT_EQ(updated.size(), 1u);
  EXPECT_EQ(updated[0].slug, "wire-name-clash");
}

TEST_F(CompositesTest, OneOfTwoSpellingsIsNoClash) {
  const model::Type number = sample::number();
  model::Type tuple = of(Shape::Tuple, {number, number});
  add(tuple);
  tuple.spelling = "another";
  tuple.element[0].spelling = "another";
  add(tuple);
  EXPECT_TRUE(update(model_, Locks{}).diagnostics.empty());
}

TEST_F(CompositesTest, AUserTypesSameNameClashes) {
  model::Struct clash = sample::structure("robots::RobotsArmOptionalFloat64", {});
  sample::armHeader(model_).structs.push_back(clash);
  Locks none;
  const std::vector<std::string> found = slugs(none);
  EXPECT_NE(std::find(found.begin(), found.end(), "wire-name-clash"), found.end());
}

}  // namespace
}  // namespace suture::compiler::lock
