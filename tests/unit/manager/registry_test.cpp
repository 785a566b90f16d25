#include <gtest/gtest.h>
#include <suture/names/registry.h>

#include <algorithm>

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

std::shared_ptr<Holding> link() { return std::make_shared<Holding>(); }

TEST(Registry, KnowsWhatWasAdded) {
  Registry registry;
  const auto generation = registry.add(recordOf("left"), link());
  ASSERT_TRUE(generation);
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_EQ(registry.find("left")->generation, *generation);
  registry.remove("left", *generation);
  EXPECT_EQ(registry.find("left"), nullptr);
}

TEST(Registry, ATakenNamesHolderIsNamed) {
  Registry registry;
  ASSERT_TRUE(registry.add(recordOf("left", 4711), link()));
  const auto second = registry.add(recordOf("left", 4712), link());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, Kind::NAME_TAKEN);
  EXPECT_NE(second.error().text.find("process 4711 on theatre"), std::string::npos)
      << second.error().text;
  EXPECT_EQ(registry.find("left")->pid, 4711);
}

TEST(Registry, ALateRemovalKeepsTheNextHolder) {
  Registry registry;
  const auto first = registry.add(recordOf("left"), link());
  registry.remove("left", *first);
  const auto second = registry.add(recordOf("left"), link());
  EXPECT_GT(*second, *first);
  registry.remove("left", *first);
  registry.update("left", *first, {{"PSM", {}, {}}});
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.find("left")->components.empty());
}

/// Lets so much time pass that a process which does not renew is silent.
void ageBeyondLeases(Registry& registry) {
  for (int i = 0; i <= wire::MISSABLE_RENEWALS; ++i) registry.age();
}

TEST(Registry, AProcessThatMissesRenewalsIsSilent) {
  Registry registry;
  const auto generation = registry.add(recordOf("left", 4711), link());
  ASSERT_TRUE(registry.renew("left", *generation));
  for (int i = 0; i < wire::MISSABLE_RENEWALS; ++i) registry.age();
  EXPECT_NE(registry.find("left"), nullptr);
  registry.age();
  EXPECT_EQ(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.list().processes.at(0).silent);
  const std::string text = registry.unknown("left", 0).text;
  EXPECT_NE(text.find("process 4711 on theatre has not renewed its name in time"),
            std::string::npos)
      << text;
  EXPECT_TRUE(registry.renew("left", *generation));
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_FALSE(registry.list().processes.at(0).silent);
}

TEST(Registry, AProcessThatNeverRenewsIsSilent) {
  Registry registry;
  ASSERT_TRUE(registry.add(recordOf("left", 4711), link()));
  ageBeyondLeases(registry);
  EXPECT_EQ(registry.find("left"), nullptr);
  EXPECT_TRUE(registry.add(recordOf("left", 4712), link()));
}

TEST(Registry, ASilentProcessLosesItsName) {
  Registry registry;
  const auto first = registry.add(recordOf("left", 4711), link());
  ASSERT_TRUE(registry.renew("left", *first));
  ageBeyondLeases(registry);
  ASSERT_TRUE(registry.add(recordOf("left", 4712), link()));
  EXPECT_FALSE(registry.renew("left", *first));
  registry.remove("left", *first);
  ASSERT_NE(registry.find("left"), nullptr);
  EXPECT_EQ(registry.find("left")->pid, 4712);
}

TEST(Registry, AddressLikeNamesAreRefused) {
  Registry registry;
  for (const std::string name : {"", "a:b", "a/b", "a b", "a\tb", "a\x1b", "a\x7f"}) {
    const auto added = registry.add(recordOf(name), link());
    ASSERT_FALSE(added) << name;
    EXPECT_EQ(added.error().kind, Kind::MALFORMED);
    EXPECT_EQ(added.error().text,
              "register process '" + name +
                  "': a name has 1 to 100 characters, none of them ':', '/', a space or a control "
                  "character. Choose another name.");
  }
  EXPECT_FALSE(registry.add(recordOf(std::string(101, 'x')), link()));
  EXPECT_TRUE(registry.add(recordOf(std::string(100, 'x')), link()));
}

TEST(Registry, AnUnknownNameListsTheKnown) {
  Registry registry;
  EXPECT_NE(registry.unknown("left", 0).text.find("knows none"), std::string::npos);
  ASSERT_TRUE(registry.add(recordOf("left"), link()));
  ASSERT_TRUE(registry.add(recordOf("right"), link()));
  const Refusal refusal = registry.unknown("lefd", 200);
  EXPECT_EQ(refusal.kind, Kind::NO_SUCH_PROCESS);
  for (const char* part : {"'lefd'", "'left' and 'right'", "200 ms", "Did you mean 'left'?"}) {
    EXPECT_NE(refusal.text.find(part), std::string::npos) << refusal.text;
  }
}

/// Returns a record that takes about `bytes`.
ProcessRecord recordOfSize(const std::string& name, std::size_t bytes) {
  ProcessRecord record = recordOf(name);
  record.components.push_back({std::string(bytes - 1000, 'x'), {}, {}});
  return record;
}

void expectLimit(const tl::expected<std::uint64_t, Refusal>& added, const std::string& named) {
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().kind, Kind::LIMIT_REACHED);
  EXPECT_NE(added.error().text.find(named), std::string::npos) << added.error().text;
}

TEST(Registry, ARecordIsBounded) {
  Registry registry;
  expectLimit(registry.add(recordOfSize("left", (1u << 20) + 2000), link()), "1048576 bytes");
  const auto generation = registry.add(recordOf("left"), link());
  const auto updated =
      registry.update("left", *generation, recordOfSize("left", (1u << 20) + 2000).components);
  ASSERT_FALSE(updated);
  EXPECT_TRUE(updated.error().text.starts_with(
      "replace the components of process 'left': its components and interfaces take "))
      << updated.error().text;
  EXPECT_NE(updated.error().text.find("1048576 bytes"), std::string::npos) << updated.error().text;
  EXPECT_TRUE(registry.find("left")->components.empty());
  EXPECT_TRUE(registry.update("left", *generation, recordOfSize("left", 1u << 20).components));
}

TEST(Registry, ALinksNamesAndBytesAreBounded) {
  Registry registry;
  const auto holding = link();
  for (std::size_t i = 0; i < Registry::kMostNamesOfALink; ++i) {
    ASSERT_TRUE(registry.add(recordOf("name" + std::to_string(i)), holding));
  }
  expectLimit(registry.add(recordOf("left"), holding), "64 names");
  EXPECT_TRUE(registry.add(recordOf("left"), link()));

  const auto large = link();
  std::uint64_t last = 0;
  for (int i = 0; i < 4; ++i) {
    const auto added = registry.add(recordOfSize("large" + std::to_string(i), 1'000'000), large);
    ASSERT_TRUE(added);
    last = *added;
  }
  expectLimit(registry.add(recordOfSize("fifth", 1'000'000), large), "4194304 bytes");
  registry.remove("large3", last);
  EXPECT_TRUE(registry.add(recordOfSize("fifth", 1'000'000), large));
}

TEST(Registry, ARefusedSuccessorTakesNoName) {
  Registry registry;
  const auto generation = registry.add(recordOf("left", 4711), link());
  ageBeyondLeases(registry);
  expectLimit(registry.add(recordOfSize("left", (1u << 20) + 2000), link()), "1048576 bytes");
  EXPECT_TRUE(registry.renew("left", *generation));
  EXPECT_EQ(registry.find("left")->pid, 4711);
}

/// Returns a new link of that peer.
std::shared_ptr<Holding> linkOf(const std::shared_ptr<Holding>& peer) {
  auto link = std::make_shared<Holding>();
  link->peer = peer;
  return link;
}

TEST(Registry, NamesOfAPeersLinksAreBounded) {
  Registry registry;
  const auto peer = link();
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < Registry::kMostNamesOfAPeer; ++i) {
    const auto added = registry.add(recordOf("name" + std::to_string(i)), linkOf(peer));
    ASSERT_TRUE(added);
    last = *added;
  }
  expectLimit(registry.add(recordOf("left"), linkOf(peer)), "2048, and the manager knows no more");
  EXPECT_TRUE(registry.add(recordOf("left"), linkOf(link()))) << "another peer has room";
  registry.remove("name2047", last);
  EXPECT_TRUE(registry.add(recordOf("right"), linkOf(peer)));
}

TEST(Registry, BytesOfAPeersLinksAreBounded) {
  Registry registry;
  const auto peer = link();
  std::size_t added = 0;
  while (registry.add(recordOfSize(std::to_string(added), 1'000'000), linkOf(peer))) ++added;
  EXPECT_EQ(added, 33u);
  expectLimit(registry.add(recordOfSize("more", 1'000'000), linkOf(peer)), "33554432 bytes");
  EXPECT_TRUE(registry.add(recordOfSize("more", 1'000'000), linkOf(link())));
}

TEST(Registry, AllTogetherAreBounded) {
  Registry registry;
  std::size_t added = 0;
  while (registry.add(recordOfSize(std::to_string(added), 1'000'000), link())) ++added;
  EXPECT_EQ(added, 67u);
  expectLimit(registry.add(recordOfSize("more", 1'000'000), link()), "67108864 bytes");
}

TEST(Registry, ListsEachProcessOnceOverManyPages) {
  Registry registry;
  for (int i = 100; i < 120; ++i) {
    ASSERT_TRUE(registry.add(recordOfSize(std::to_string(i), i == 105 ? 300'000 : 30'000), link()));
  }
  std::vector<std::string> names;
  int pages = 0;
  for (Registry::Page page{{}, true}; page.more; ++pages) {
    page = registry.list(names.empty() ? "" : names.back(), 100'000);
    ASSERT_FALSE(page.processes.empty());
    for (const ProcessRecord& one : page.processes) names.push_back(one.name);
  }
  EXPECT_EQ(names.size(), 20u);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(pages, 8);
}

}  // namespace
}  // namespace suture
