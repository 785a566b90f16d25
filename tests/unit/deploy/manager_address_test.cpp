// These see what a deployment file may say of the global manager's address.

#include <gtest/gtest.h>
#include <suture/deploy/document/deployment.h>

#include "sound_deployment.h"

namespace suture::sound {
namespace {

TEST(ManagerAddress, SocketsCountFromTheFilesFolder) {
  const std::string relative = with("unix:/tmp/suture.sock", "unix:run/a.sock,unix:/run/b.sock");
  const Deployment deployment(JsonDocument::parse(relative, "/home/lab/d.json"));
  EXPECT_EQ(deployment.manager(), "unix:/home/lab/run/a.sock,unix:/run/b.sock");
}

TEST(ManagerAddress, AddressesAreReadWithTheFile) {
  expectOnly(with("unix:/tmp/suture.sock", "unix:/tmp/a.sock,tcp://127.0.0.1:7700"),
             "d.json:2: error: use the address 'unix:/tmp/a.sock,tcp://127.0.0.1:7700': "
             "'unix:/tmp/a.sock' and 'tcp://127.0.0.1:7700' differ in kind. List addresses of one "
             "kind.");
}

TEST(ManagerAddress, SeveralManagersAreListedWithCommas) {
  const std::string both = "unix:/tmp/1.sock,unix:/tmp/2.sock";
  const Deployment deployment(JsonDocument::parse(with("unix:/tmp/suture.sock", both), "d.json"));
  EXPECT_EQ(deployment.manager(), both);
}

TEST(ManagerAddress, MalformedAddressesAreRefused) {
  const auto interface = problemsOf(with("left:MTML/Arm", "left:MTML"));
  ASSERT_EQ(interface.size(), 1u);
  EXPECT_TRUE(interface[0].starts_with("d.json:17: error: 'to': expected the provided interface"))
      << interface[0];
  const auto manager = problemsOf(with("unix:/tmp/suture.sock", "http://x"));
  ASSERT_EQ(manager.size(), 1u);
  EXPECT_TRUE(
      manager[0].starts_with("d.json:2: error: 'manager': expected address of the global manager"))
      << manager[0];
}

TEST(ManagerAddress, TwoProcessesOrRpcNeedAManager) {
  const auto problems = problemsOf(with("\"manager\": \"unix:/tmp/suture.sock\",", ""));
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_TRUE(problems[0].starts_with("d.json:1: error: 2 processes need a global manager"));
  EXPECT_TRUE(problems[1].starts_with("d.json:18: error: lane \"rpc\" needs a global manager"));
}

}  // namespace
}  // namespace suture::sound
