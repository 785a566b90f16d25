#include <gtest/gtest.h>
#include <suture/names/policy.h>
#include <unistd.h>

namespace suture {
namespace {

using net::PeerIdentity;
using Proof = PeerIdentity::Proof;

PeerIdentity process(const std::string& name) { return {Proof::Certificate, 0, name}; }
PeerIdentity user(uid_t number) { return {Proof::User, number, ""}; }
const PeerIdentity kPlain{};
const Endpoint kArm{"robot", "PSM", "Arm"};

TEST(Policy, WithoutRulesAnyPeerMayDoEverything) {
  for (const PeerIdentity& peer : {process("console"), user(1000), kPlain}) {
    EXPECT_TRUE(Policy().admits(peer)) << peer.text();
    EXPECT_EQ(Policy().access(peer, kArm), Access::Full) << peer.text();
  }
}

TEST(Policy, APeerWithoutRuleDoesNothing) {
  const Policy policy(std::vector<Rule>{});
  for (const PeerIdentity& peer : {process("console"), user(0), user(geteuid()), kPlain}) {
    EXPECT_FALSE(policy.admits(peer)) << peer.text();
    EXPECT_EQ(policy.access(peer, kArm), Access::None) << peer.text();
  }
}

TEST(Policy, ARuleNeedsItsProof) {
  const Role all{.full = {"*/*"}, .read = {}};
  const std::pair<const char*, PeerIdentity> cases[] = {{"process:console", process("console")},
                                                        {"process:con*", process("console")},
                                                        {"user:1000", user(1000)},
                                                        {"tcp", kPlain}};
  for (const auto& [who, meant] : cases) {
    const Policy policy({{who, all}});
    for (const PeerIdentity& peer : {process("console"), user(1000), kPlain}) {
      const bool same = peer.proof == meant.proof;
      EXPECT_EQ(policy.access(peer, kArm), same ? Access::Full : Access::None)
          << who << " and " << peer.text();
    }
  }
  const Policy anyProcess({{"process:*", all}});
  EXPECT_FALSE(anyProcess.admits(user(geteuid())));
  EXPECT_FALSE(Policy({{"process:console", all}}).admits(process("console2")));
}

TEST(Policy, TheSameUserIncludesRoot) {
  const Policy policy({{"user:same", {.full = {"*/*"}, .read = {}}}});
  EXPECT_TRUE(policy.admits(user(geteuid())));
  EXPECT_TRUE(policy.admits(user(0)));
  EXPECT_FALSE(policy.admits(user(geteuid() + 12345)));
}

TEST(Policy, TheFirstRuleCounts) {
  const Policy policy({{"process:console", {.full = {}, .read = {"*/*"}}},
                       {"process:*", {.full = {"*/*"}, .read = {}}}});
  EXPECT_EQ(policy.access(process("console"), kArm), Access::Read);
  EXPECT_EQ(policy.access(process("teleop"), kArm), Access::Full);
}

TEST(Policy, PatternsNameInterfacesOfProcesses) {
  const Policy policy({{"tcp", {.full = {"robot:PSM/A*"}, .read = {"PSM/*", "*/component"}}}});
  const std::pair<Endpoint, Access> cases[] = {
      {{"robot", "PSM", "Arm"}, Access::Full},     {{"other", "PSM", "Arm"}, Access::Read},
      {{"robot", "PSM", "Gripper"}, Access::Read}, {{"robot", "ECM", "component"}, Access::Read},
      {{"robot", "ECM", "Arm"}, Access::None},     {{"robot", "PSM2", "Arm"}, Access::None}};
  for (const auto& [provided, access] : cases) {
    EXPECT_EQ(policy.access(kPlain, provided), access) << provided.toString();
  }
}

TEST(Policy, TellsTheUsersThatItNames) {
  const Policy policy({{"user:1000", {}}, {"user:same", {}}, {"process:*", {}}, {"user:7", {}}});
  EXPECT_EQ(policy.users(), (std::vector<uid_t>{1000, 7}));
  EXPECT_TRUE(Policy().users().empty());
}

}  // namespace
}  // namespace suture
