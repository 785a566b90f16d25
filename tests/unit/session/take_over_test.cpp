// A connection takes the place of the one before only where the same peer asks.

#include <gtest/gtest.h>
#include <suture/loop/failure.h>
#include <suture/names/records.h>
#include <suture/net/dialer.h>
#include <suture/session/boot_id.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <string>

#include "reference/connect_request.h"
#include "reference/played_client.h"
#include "reference/remote_arm.h"
#include "support/other_user.h"
#include "support/patience.h"

namespace suture {
namespace {

using capnp::rpc::twoparty::Side;

/// Lets this user's processes command the arm, and those of another user look at it.
struct TakeOver : RemoteArm {
  void SetUp() override {
    const Role commands{.full = {"*/*"}, .read = {}}, looks{.full = {}, .read = {"*/*"}};
    begin(unixAddress(),
          Policy({{"user:same", commands}, {"user:" + std::to_string(kNobody), looks}}));
  }
  rpc::Address robotsAddress() const {
    return reference::PlayedClient(manager(), "robot").provider();
  }
};

/// Says in a session of its own that it is the console, which has connected later than any other,
/// and asks for a connection on a socket that it has not. Returns why it has none.
kj::Promise<std::string> askAsTheConsole(wire::Peer::Client robot) {
  auto hello = robot.helloRequest();
  hello.setVersion(wire::PROTOCOL_VERSION);
  hello.setProcess("console");
  hello.setBootId(bootId());
  return hello.send().then([robot](auto&&) mutable {
    auto request = robot.connectRequest();
    reference::askForArm(request, "console");
    request.setEpoch(std::numeric_limits<std::int64_t>::max());
    request.initBrings().initAs<wire::CallsRequest>().setSocket(1);
    return request.send().then([](auto&& results) {
      return results.isRefused() ? fromWire(results.getRefused()).text
                                 : std::string(results.getDeclined().cStr());
    });
  });
}

std::string answerTo(const rpc::Address& robot) {
  rpc::ControlThread control;
  return control.run(kPatience, [&control, robot] {
    return rpc::dial(control.port(), robot, kPatience).then([&control](kj::AutoCloseFd socket) {
      auto stream = kj::heap<rpc::MessageStream>(control.port(), rpc::ByteStream(kj::mv(socket)));
      auto link = kj::heap<rpc::Link>(kj::mv(stream), Side::CLIENT);
      return askAsTheConsole(link->bootstrap<wire::Peer>()).attach(kj::mv(link));
    });
  });
}

TEST_F(TakeOver, IsNotForAnotherUserWhoGivesTheSameName) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to be somebody else";
  connect();
  const rpc::Address address = robotsAddress();
  std::filesystem::permissions(std::filesystem::path(address.path).parent_path(),
                               std::filesystem::perms::all);
  std::string answer;
  asNobody([&] { answer = answerTo(address); });
  EXPECT_EQ(answer, "the session's calls have ended");
  ASSERT_EQ(robot->channels().size(), 1u);
  EXPECT_EQ(robot->channels()[0]->status, ChannelStatus::Connected);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_F(TakeOver, IsForTheProcessThatComesAgain) {
  connect();
  const auto before = robot->channels().at(0);
  EXPECT_EQ(answerTo(robotsAddress()), "the session's calls have ended");
  EXPECT_EQ(before->status, ChannelStatus::Closed);
}

}  // namespace
}  // namespace suture
