// These break a contract on purpose, and give ids anew.

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/lock/contract_hash.h"
#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/wire_contract.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {
namespace {

using model::Diagnostics;

class BreakTest : public testing::Test {
 protected:
  static Locks read(const std::vector<model::Artefact>& texts) {
    Diagnostics none;
    Locks locks = lock::read(texts, none);
    EXPECT_TRUE(none.empty());
    return locks;
  }

  /// Returns the locks after an update that takes breaks.
  Locks accept(const Locks& old) {
    const Update taken = update(sample::allOwn(model_), old, {.acceptBreaks = true});
    EXPECT_TRUE(taken.diagnostics.empty());
    Locks locks = old;
    for (auto& [path, lock] : read(taken.files).files) locks.files[path] = lock;
    return locks;
  }

  std::string hash(const Locks& locks) {
    return contractHashes(model_, upToDate(model_, locks)).at("robots::Arm");
  }

  static unsigned majorIn(const Locks& locks, const std::string& contract) {
    return majorOf(indexed(locks.files), contract);
  }

  model::Field& speed() { return sample::armHeader(model_).structs[0].fields[3]; }

  model::Model model_ = sample::robots();
  const Locks before_ = read(update(sample::allOwn(model_), {}).files);
};

TEST_F(BreakTest, AnAcceptedBreakRaisesTheMajorVersion) {
  EXPECT_EQ(majorIn(before_, "robots::Arm"), 1u);
  speed().unit = "mm/s";
  const Locks once = accept(before_);
  EXPECT_EQ(majorIn(once, "robots::Arm"), 2u);
  EXPECT_TRUE(check(model_, once).empty());
  speed().type = sample::scalar(model::Scalar::Float32);
  EXPECT_EQ(majorIn(accept(once), "robots::Arm"), 3u);
}

TEST_F(BreakTest, AnotherTypeHasItsOwnDefault) {
  speed().defaultJson = "0.75";
  const Locks old = accept({});
  speed().type = sample::text(4);
  speed().defaultJson = "\"fast\"";
  EXPECT_TRUE(check(model_, accept(old)).empty()) << "capnp refuses a number as a text's default";
  const std::string& text = accept(old).files.at("robots/arm.capnp").text;
  EXPECT_EQ(text.find(":Text = 0.75"), std::string::npos);
}

TEST_F(BreakTest, OnlyABreakRaisesTheMajor) {
  speed().unit = "mm/s";
  const Locks once = accept(before_);
  sample::armHeader(model_).structs[0].fields.push_back(sample::field("extra", sample::number()));
  EXPECT_EQ(majorIn(accept(once), "robots::Arm"), 2u);
}

TEST_F(BreakTest, OtherContractsKeepTheirMajorVersion) {
  model::Interface other = sample::armHeader(model_).interfaces[0];
  other.name = "robots::Other";
  other.wireName = "Other";
  other.events.clear();
  other.commands.resize(1);
  sample::armHeader(model_).interfaces.push_back(other);
  const Locks both = accept(before_);
  speed().unit = "mm/s";
  const Locks after = accept(both);
  EXPECT_EQ(majorIn(after, "robots::Arm"), 2u);
  EXPECT_EQ(majorIn(after, "robots::Other"), 1u);
}

// Its rows have the base's reads, so only what a command takes tells if the base is followed.
TEST_F(BreakTest, ABaseRaisesItsDerivedContract) {
  const model::Struct wish = sample::structure(
      "robots::Wish", {sample::field("speed", sample::scalar(model::Scalar::Float64))});
  model::Header& header = sample::armHeader(model_);
  header.structs.push_back(wish);
  header.interfaces[0].commands.push_back(
      sample::write("wish", "value", sample::record("robots::Wish")));
  const Locks both = accept(before_);
  const unsigned base = majorIn(both, "robots::Arm"), derived = majorIn(both, "robots::Gripper");
  header.structs.back().fields[0].type = sample::scalar(model::Scalar::Float32);
  const Locks after = accept(both);
  EXPECT_EQ(majorIn(after, "robots::Arm"), base + 1);
  EXPECT_EQ(majorIn(after, "robots::Gripper"), derived + 1);
}

TEST_F(BreakTest, PeersOfTwoMajorsHaveTwoHashes) {
  const std::string before = hash(before_);
  speed().unit = "mm/s";
  const Locks after = accept(before_);
  speed().unit = "m/s";
  const Locks back = accept(after);
  EXPECT_EQ(majorIn(back, "robots::Arm"), 3u);
  EXPECT_NE(hash(back), before) << "the same words after two breaks are another contract";
}

TEST_F(BreakTest, AnEnumCannotBecomeAStruct) {
  auto& header = sample::armHeader(model_);
  header.structs.push_back(sample::structure("robots::Kind", {}));
  const Locks old = accept(before_);
  header.structs.pop_back();
  header.enums.push_back(sample::enumerated("robots::Kind", {{"One", 1}}));
  const Diagnostics found = check(model_, old);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].slug, "lock-break");
}

TEST_F(BreakTest, ANewIdSettlesACopy) {
  std::string text = before_.files.at("robots/arm.capnp").text;
  const Locks copied = read({{"robots/arm.capnp", text}, {"robots/copy.capnp", text}});
  EXPECT_EQ(check(model_, copied).front().slug, "lock-duplicate-id");
  const Update renewed = update(model_, copied, {.newIds = {"Mode", "Nothing"}});
  EXPECT_EQ(renewed.unknownIds, std::vector<std::string>{"Nothing"});
  const auto isMode = [](const model::Diagnostic& one) {
    return one.message.starts_with("Mode has the id");
  };
  EXPECT_TRUE(std::none_of(renewed.diagnostics.begin(), renewed.diagnostics.end(), isMode));
}

}  // namespace
}  // namespace suture::compiler::lock
