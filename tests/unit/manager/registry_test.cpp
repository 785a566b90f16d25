#include <gtest/gtest.h>
#include <suture/manager/registry.h>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

ProcessRecord recordOf(const std::string& name, std::int32_t pid = 7) {
  ProcessRecord record;
  record.name = name;
  record.pid = pid;
  record.host = "theatre";
  return record;
}

TEST(Registry, KnowsWhatWasAddedUntilItIsRemoved) {
  Registry registry;
  const auto generation = registry.add(recordOf("left"));
  ASSERT_TRUE(generation);
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_EQ(registry.find("left")->generation, *generation);
  registry.remove("left", *generation);
  EXPECT_EQ(registry.find("left"), nullptr);
}

TEST(Registry, ATakenNameIsRefusedAndTheHolderNamed) {
  Registry registry;
  ASSERT_TRUE(registry.add(recordOf("left", 4711)));
  const auto second = registry.add(recordOf("left", 4712));
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, Kind::NAME_TAKEN);
  EXPECT_NE(second.error().text.find("process 4711 on theatre"), std::string::npos)
      << second.error().text;
  EXPECT_EQ(registry.find("left")->pid, 4711);
}

TEST(Registry, ALateRemovalDoesNotTakeTheNameFromItsNextHolder) {
  Registry registry;
  const auto first = registry.add(recordOf("left"));
  registry.remove("left", *first);
  const auto second = registry.add(recordOf("left"));
  EXPECT_GT(*second, *first);
  registry.remove("left", *first);
  registry.update("left", *first, {{"PSM", {}, {}}});
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.find("left")->components.empty());
}

/// As often as it takes until who does not renew is silent.
void ageBeyondLeases(Registry& registry) {
  for (int i = 0; i <= wire::MISSABLE_RENEWALS; ++i) registry.age();
}

TEST(Registry, WhoMissesTooManyRenewalsIsSilentUntilTheNext) {
  Registry registry;
  const auto generation = registry.add(recordOf("left", 4711));
  ASSERT_TRUE(registry.renew("left", *generation));
  for (int i = 0; i < wire::MISSABLE_RENEWALS; ++i) registry.age();
  EXPECT_NE(registry.find("left"), nullptr);
  registry.age();
  EXPECT_EQ(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.list().at(0).silent);
  const std::string text = registry.unknown("left", 0).text;
  EXPECT_NE(text.find("process 4711 on theatre has been silent"), std::string::npos) << text;
  EXPECT_TRUE(registry.renew("left", *generation));
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_FALSE(registry.list().at(0).silent);
}

TEST(Registry, WhoIsStoppedBeforeItsFirstRenewalIsSilentToo) {
  Registry registry;
  ASSERT_TRUE(registry.add(recordOf("left", 4711)));
  ageBeyondLeases(registry);
  EXPECT_EQ(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.add(recordOf("left", 4712)));
}

TEST(Registry, TheNameOfASilentProcessGoesToWhoAsksForIt) {
  Registry registry;
  const auto first = registry.add(recordOf("left", 4711));
  ASSERT_TRUE(registry.renew("left", *first));
  ageBeyondLeases(registry);
  ASSERT_TRUE(registry.add(recordOf("left", 4712)));
  EXPECT_FALSE(registry.renew("left", *first));
  registry.remove("left", *first);
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_EQ(registry.find("left")->pid, 4712);
}

TEST(Registry, NamesThatWouldBeMistakenForAnAddressAreRefused) {
  Registry registry;
  for (const std::string name : {"", "a:b", "a/b", "a b"}) {
    const auto added = registry.add(recordOf(name));
    ASSERT_FALSE(added) << name;
    EXPECT_EQ(added.error().kind, Kind::MALFORMED);
  }
  EXPECT_FALSE(registry.add(recordOf(std::string(101, 'x'))));
  EXPECT_TRUE(registry.add(recordOf(std::string(100, 'x'))));
}

TEST(Registry, AnUnknownNameIsAnsweredWithWhatThereIs) {
  Registry registry;
  EXPECT_NE(registry.unknown("left", 0).text.find("knows none"), std::string::npos);
  ASSERT_TRUE(registry.add(recordOf("left")));
  ASSERT_TRUE(registry.add(recordOf("right")));
  const Refusal refusal = registry.unknown("lefd", 200);
  EXPECT_EQ(refusal.kind, Kind::NO_SUCH_PROCESS);
  for (const char* part : {"'lefd'", "'left' and 'right'", "200 ms", "Did you mean 'left'?"}) {
    EXPECT_NE(refusal.text.find(part), std::string::npos) << refusal.text;
  }
}

}  // namespace
}  // namespace suture
