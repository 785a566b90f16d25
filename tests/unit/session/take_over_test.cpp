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
  net::Address robotsAddress() const {
    return reference::PlayedClient(manager(), "robot").provider();
  }
};

/// Asks for a connection of the console, which is later than any other, on that socket. Returns why
/// there is none.
kj::Promise<std::string> askForConnection(wire::Peer::Client robot, std::uint32_t socket) {
  auto request = robot.connectRequest();
  reference::askForArm(request, "console");
  request.setEpoch(std::numeric_limits<std::int64_t>::max());
  request.initBrings().initAs<wire::CallsRequest>().setSocket(socket);
  return request.send().then([](auto&& results) {
    if (results.isAccepted()) return std::string();
    return results.isRefused() ? fromWire(results.getRefused()).text
                               : std::string(results.getDeclined().cStr());
  });
}

/// Says in a session of its own that it is the console.
kj::Promise<void> greetAsTheConsole(wire::Peer::Client robot) {
  auto hello = robot.helloRequest();
  hello.setVersion(wire::PROTOCOL_VERSION);
  hello.setProcess("console");
  hello.setBootId(bootId());
  return hello.send().ignoreResult();
}

/// The calls of the connection travel on a socket that has been opened for them, or on none.
enum class Socket { Own, None };

/// Asks in a session of its own. Returns why there is no connection.
std::string answerTo(const net::Address& robot, Socket socket) {
  loop::ControlThread control;
  return control.run(kPatience, [&control, robot, socket] {
    return net::dial(control.port(), robot, kPatience)
        .then([&control, robot, socket](kj::AutoCloseFd dialled) {
          auto stream =
              kj::heap<framing::MessageStream>(control.port(), net::ByteStream(kj::mv(dialled)));
          auto link = kj::heap<framing::Link>(kj::mv(stream), Side::CLIENT);
          auto peer = link->bootstrap<wire::Peer>();
          return greetAsTheConsole(peer)
              .then([&control, robot, socket, peer]() mutable -> kj::Promise<std::string> {
                if (socket == Socket::None) return askForConnection(peer, 1);
                return reference::openSecondSocket(control.port(), robot, peer)
                    .then([peer](reference::SecondSocket opened) mutable {
                      auto answer = askForConnection(peer, opened.number);
                      return answer.attach(kj::mv(opened.bytes));
                    });
              })
              .attach(kj::mv(link));
        });
  });
}

TEST_F(TakeOver, AnotherUserCannotTakeTheName) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to be somebody else";
  connect();
  const net::Address address = robotsAddress();
  std::filesystem::permissions(std::filesystem::path(address.path).parent_path(),
                               std::filesystem::perms::all);
  std::string answer;
  asNobody([&] { answer = answerTo(address, Socket::Own); });
  EXPECT_EQ(answer, "");
  EXPECT_EQ(robot->channels().at(0)->status, ChannelStatus::Connected);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_F(TakeOver, IsForTheProcessThatComesAgain) {
  connect();
  const auto before = robot->channels().at(0);
  EXPECT_EQ(answerTo(robotsAddress(), Socket::Own), "");
  EXPECT_EQ(before->status, ChannelStatus::Closed);
}

TEST_F(TakeOver, IsForAConnectionThatIsMade) {
  connect();
  EXPECT_EQ(answerTo(robotsAddress(), Socket::None), "the session's calls have ended");
  EXPECT_EQ(robot->channels().at(0)->status, ChannelStatus::Connected);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

}  // namespace
}  // namespace suture
