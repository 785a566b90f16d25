// These see what the lock keeps of defaults.

#include "tests/unit/lock/lock_fixture.h"

namespace suture::compiler::lock {
namespace {

TEST_F(LockTest, DefaultsAreFrozen) {
  EXPECT_EQ(nodeOf(armLock(before_), "Everything").members[3].defaultValue, "0.25");
  EXPECT_EQ(nodeOf(armLock(before_), "Everything").members[5].defaultValue, "servo");
  field("speed").defaultJson = "0.75";
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-stale"});
  EXPECT_EQ(found[0].message,
            "field 'robots::Everything::speed': default 0.75 instead of 0.25; where a message does "
            "not have it, it still is 0.25");
  const Locks after = lockOf(model_, before_);
  EXPECT_EQ(nodeOf(armLock(after), "Everything").members[3].defaultValue, "0.25");
  EXPECT_TRUE(check(model_, after).empty()) << "it is said once";
}

class EnumDefaults : public LockTest {
 protected:
  EnumDefaults() {
    auto& header = sample::armHeader(model_);
    header.enums.push_back(sample::enumerated("robots::Pace", {{"Slow", 0}, {"Fast", 1}}));
    add("robots::Walk", "Slow");
    add("robots::Run", "Fast");
    locked_ = lockOf(model_, before_);
  }

  void add(const std::string& name, const std::string& pace) {
    model::Field field = sample::field("pace", sample::enumeration("robots::Pace"));
    field.defaultJson = "\"" + pace + "\"";
    sample::armHeader(model_).structs.push_back(sample::structure(name, {field}));
  }

  const std::string& defaultOf(const Locks& locks, const std::string& node) {
    return nodeOf(armLock(locks), node).members[0].defaultValue;
  }

  Locks locked_;
};

TEST_F(EnumDefaults, TheOneOfOrdinalZeroIsNone) {
  EXPECT_EQ(defaultOf(locked_, "Walk"), "");
  EXPECT_EQ(defaultOf(locked_, "Run"), "fast");
}

TEST_F(EnumDefaults, OrderInTheHeaderDoesNotCount) {
  auto& enumerators = sample::armHeader(model_).enums.back().enumerators;
  std::reverse(enumerators.begin(), enumerators.end());
  EXPECT_TRUE(check(model_, locked_).empty());
  add("robots::Sprint", "Fast");
  EXPECT_EQ(defaultOf(lockOf(model_, locked_), "Sprint"), "fast");
}

TEST_F(EnumDefaults, ARenamedEnumeratorHasItsNewName) {
  auto& enumerators = sample::armHeader(model_).enums.back().enumerators;
  enumerators[1].name = "Quick";
  enumerators[1].wireName = "quick";
  enumerators[1].was = "Fast";
  sample::armHeader(model_).structs.back().fields[0].defaultJson = "\"Quick\"";
  EXPECT_EQ(slugs(check(model_, locked_)), Slugs{"lock-renamed"});
  EXPECT_EQ(defaultOf(lockOf(model_, locked_), "Run"), "quick");
}

}  // namespace
}  // namespace suture::compiler::lock
