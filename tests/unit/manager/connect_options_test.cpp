// Each of these connections is asked for with a time that means nothing, or with zero.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <string>

#include "support/refusal.h"
#include "unit/manager/arm_and_client.h"

namespace suture::test {
namespace {

struct ConnectOptionsTest : testing::Test {
  std::string refused(const ConnectOptions& options) {
    return refusal([&] { here.manager.connect("Teleop/Slave", "PSM/Arm", options); });
  }
  OneProcess<ArmTask> here;
};

TEST_F(ConnectOptionsTest, ANegativeMaxAgeIsRefused) {
  EXPECT_EQ(refused({.contract = {.maxAge = -1ms}}),
            "connecting here:Teleop/Slave -> here:PSM/Arm: a max_age of -1000000 ns. Give a time "
            "that is not negative; 0 stands for none");
}

TEST_F(ConnectOptionsTest, EachNegativeTimeIsRefused) {
  EXPECT_NE(refused({.contract = {.deadline = -1ns}}).find("a deadline of -1 ns"),
            std::string::npos);
  EXPECT_NE(refused({.contract = {.silence = -1ns}}).find("a longest silence of -1 ns"),
            std::string::npos);
  EXPECT_NE(refused({.patience = -1ns}).find("a patience of -1 ns"), std::string::npos);
  EXPECT_NE(refused({.delay = {.commands = -1ns}}).find("a delay of commands of -1 ns"),
            std::string::npos);
  EXPECT_NE(refused({.delay = {.answers = -1ns}}).find("a delay of answers of -1 ns"),
            std::string::npos);
  here.client.slave.limitAge(-2ns);
  EXPECT_NE(refused({}).find("a max_age of -2 ns"), std::string::npos);
}

TEST_F(ConnectOptionsTest, ZeroIsNoLimit) {
  EXPECT_EQ(refused({.patience = 0ns, .delay = {.commands = 0ns}, .contract = {.maxAge = 0ns}}),
            "");
}

}  // namespace
}  // namespace suture::test
