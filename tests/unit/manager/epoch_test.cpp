// The connections of one required interface reach the provider in another order than they were
// made.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/event_task.h>
#include <suture/lane/shm/shared_memory.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/net/dialer.h>
#include <suture/peer.capnp.h>
#include <suture/wiring/memory_layout.h>

#include <atomic>
#include <string>

#include "reference/connect_request.h"
#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct EventArm final : EventTask, StillArm {
  ~EventArm() override { stop(); }
  void run() override {}
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// Counts how often it has heard that the provider closed the connection.
class Notices final : public wire::Notices::Server {
 public:
  explicit Notices(std::atomic<int>& closed) : closed_(closed) {}

 protected:
  kj::Promise<void> closed(ClosedContext) override {
    ++closed_;
    return kj::READY_NOW;
  }

 private:
  std::atomic<int>& closed_;
};

/// A Caller is a link whose caller says any name and number of its process.
class Caller {
 public:
  /// `incarnation`: of its process; 0: it does not say.
  Caller(const std::string& provider, std::string bootId, std::uint64_t incarnation = 0)
      : bootId_(std::move(bootId)),
        incarnation_(incarnation),
        provider_(net::Address::parse(provider)) {
    control_.run(kPatience, [this] {
      return net::dial(control_.port(), provider_, kPatience).then([this](kj::AutoCloseFd socket) {
        link_ = kj::heap<framing::Link>(
            kj::heap<framing::MessageStream>(control_.port(), kj::mv(socket)),
            capnp::rpc::twoparty::Side::CLIENT);
      });
    });
  }
  ~Caller() {
    control_.run(kPatience, [this] {
      held_.clear();
      calls_ = nullptr;
      link_ = nullptr;
    });
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  /// Connects "left:Teleop/Slave" to PSM/Arm. Returns the refusal, or "".
  std::string connect(std::int64_t epoch, const Lane& lane = Lane::Rpc) {
    return control_.run(kPatience,
                        [=, this] { return greet().then([=, this] { return ask(epoch, lane); }); });
  }

  /// Does so in the session that stands already.
  std::string askAgain(std::int64_t epoch) {
    return control_.run(kPatience, [=, this] { return ask(epoch, Lane::Rpc); });
  }

  /// Does so twice by shared memory, whose provider waits for a descriptor, and for no answer.
  void connectTwice(std::int64_t first, std::int64_t second) {
    control_.run(kPatience, [=, this] {
      return greet().then([=, this] {
        auto one = ask(first, Lane::Shm).ignoreResult(),
             other = ask(second, Lane::Shm).ignoreResult();
        return one.then([other = kj::mv(other)]() mutable { return kj::mv(other); });
      });
    });
  }

  /// Says hello in `version` of the protocol. Returns the refusal, or "".
  std::string hello(std::uint16_t version) {
    return control_.run(kPatience, [this, version] {
      auto hello = link_->bootstrap<wire::Peer>().helloRequest();
      hello.setVersion(version);
      hello.setProcess("left");
      return hello.send().then([](auto&& results) {
        return results.isRefused() ? fromWire(results.getRefused()).text : std::string();
      });
    });
  }

  std::atomic<int> closed{0};

 private:
  kj::Promise<void> greet() {
    auto peer = link_->bootstrap<wire::Peer>();
    auto hello = peer.helloRequest();
    hello.setVersion(wire::PROTOCOL_VERSION);
    hello.setProcess("left");
    hello.setBootId(codec::textOf(bootId_));
    hello.setIncarnation(incarnation_);
    return hello.send()
        .then([this, peer](auto&&) mutable {
          return reference::openSecondSocket(control_.port(), provider_, peer);
        })
        .then([this](reference::SecondSocket socket) { calls_ = kj::mv(socket); });
  }

  kj::Promise<std::string> ask(std::int64_t epoch, const Lane& lane) {
    auto request = link_->bootstrap<wire::Peer>().connectRequest();
    reference::askForArm(request, "left");
    request.setEpoch(epoch);
    request.setNotices(kj::heap<Notices>(closed));
    request.setLane(toString(lane));
    if (lane == Lane::Shm) {
      auto memory = request.initBrings().initAs<wire::SharedRequest>();
      memory.setLayout(codec::textOf(memoryLayout(interfaceInfo<reference::ArmLike>())));
      memory.setBell(shm::handOut(std::make_shared<MemoryBlock>("bell", sizeof(std::uint64_t))));
    } else {
      const std::uint32_t socket = KJ_ASSERT_NONNULL(calls_).number;
      request.initBrings().initAs<wire::CallsRequest>().setSocket(socket);
    }
    return request.send().then([this](auto&& results) {
      if (results.isRefused()) return fromWire(results.getRefused()).text;
      if (results.isDeclined()) return codec::stringOf(results.getDeclined());
      held_.add(results.getAccepted().getConnection());
      return std::string();
    });
  }

  const std::string bootId_;
  const std::uint64_t incarnation_;
  const net::Address provider_;
  loop::ControlThread control_;
  kj::Own<framing::Link> link_;
  kj::Maybe<reference::SecondSocket> calls_;
  kj::Vector<wire::Connection::Client> held_;
};

class Epochs : public testing::Test {
 protected:
  Epochs() {
    there_.add("PSM", arm_);
    there_.start();
    loop::ControlThread control;
    provider_ = control.run(kPatience, [&control, address = net::Address::parse(names_.address())] {
      auto link = kj::heap<ManagerLink>(control, std::vector{address}, "test");
      auto& held = *link;
      return held.open(kPatience)
          .then([&held] { return held.resolve("there", kPatience); })
          .then([](ProcessRecord record) { return record.addresses.at(0); })
          .attach(kj::mv(link));
    });
  }
  /// Returns the number of connections that stand.
  std::size_t standing() const {
    std::size_t count = 0;
    for (const auto& channel : there_.channels()) count += channel->status != ChannelStatus::Closed;
    return count;
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  EventArm arm_;
  Manager there_{"there", names_.address()};
  std::string provider_;
};

TEST_F(Epochs, ALaterConnectionEndsTheOneBefore) {
  Caller first(provider_, "a"), second(provider_, "a");
  EXPECT_EQ(first.connect(5), "");
  const auto channel = there_.channels().at(0);
  EXPECT_EQ(second.connect(6), "");
  EXPECT_EQ(channel->status, ChannelStatus::Closed);
  EXPECT_TRUE(eventually([&] { return first.closed == 1; })) << "it is told, if it still lives";
  EXPECT_EQ(second.closed, 0);
  EXPECT_EQ(standing(), 1u);
}

// Lanes may take their time to get ready, so both are under way.
TEST_F(Epochs, TheLaterOfTwoConnectionsStands) {
  for (const auto& [first, second] : {std::pair(5, 6), std::pair(8, 7)}) {
    Caller caller(provider_, "a");
    caller.connectTwice(first, second);
    EXPECT_EQ(standing(), 1u) << first << " and " << second;
  }
}

TEST_F(Epochs, OneThatComesTooLateIsRefused) {
  Caller first(provider_, "a"), second(provider_, "a");
  EXPECT_EQ(second.connect(6), "");
  EXPECT_EQ(first.connect(5),
            "connecting left:Teleop/Slave -> there:PSM/Arm: a later attempt of the same interface "
            "has come first. Nothing has to be done.");
  EXPECT_EQ(standing(), 1u);
  EXPECT_EQ(there_.refusals().count, 1u);
}

// A process that was stopped for so long that its name went to another goes on with its session.
TEST_F(Epochs, AnEarlierProcessTakesNothingBack) {
  Caller first(provider_, "a", 1);
  EXPECT_EQ(first.connect(5), "");
  {
    Caller second(provider_, "a", 2);
    EXPECT_EQ(second.connect(6), "");
    EXPECT_EQ(first.askAgain(7),
              "connecting left:Teleop/Slave -> there:PSM/Arm: another process of the same name "
              "came later and has this connection. End one of the two.");
    EXPECT_EQ(second.closed, 0);
    EXPECT_EQ(second.askAgain(8), "") << "the later one may connect anew";
  }
  ASSERT_TRUE(eventually([&] { return standing() == 0; }));
  EXPECT_EQ(first.askAgain(9), "") << "the later one has gone";
}

// It would misread what lies in shared memory and in frames.
TEST_F(Epochs, OneOfAnotherProtocolIsRefused) {
  Caller caller(provider_, "a");
  EXPECT_EQ(caller.hello(1),
            "talk to process 'there': it speaks version " + std::to_string(wire::PROTOCOL_VERSION) +
                " of the protocol, the caller version 1. Build both from the same release.");
  EXPECT_EQ(caller.hello(wire::PROTOCOL_VERSION), "");
}

TEST_F(Epochs, DifferentClocksAreNotCompared) {
  Caller first(provider_, "a"), second(provider_, "b");
  EXPECT_EQ(first.connect(6), "");
  EXPECT_EQ(second.connect(5), "") << "its machine has been started again";
  EXPECT_EQ(standing(), 1u);
}

TEST_F(Epochs, AnEndedConnectionIsForgotten) {
  {
    Caller first(provider_, "a");
    EXPECT_EQ(first.connect(6), "");
  }
  ASSERT_TRUE(eventually([&] { return standing() == 0; }));
  Caller second(provider_, "a");
  EXPECT_EQ(second.connect(5), "");
}

TEST_F(Epochs, ADeclinedAttemptChangesNoSums) {
  std::shared_ptr<Ledger> sums;
  {
    Caller first(provider_, "a", 1);
    ASSERT_EQ(first.connect(5), "");
    sums = there_.channels().at(0)->terms.ledger;
  }
  ASSERT_TRUE(eventually([&] { return standing() == 0; }));
  Caller other(provider_, "a", 2), again(provider_, "a", 1);
  EXPECT_EQ(other.connect(6, {"hope"}), "the provider's process has no lane 'hope'");
  EXPECT_EQ(again.connect(7), "");
  EXPECT_EQ(there_.channels().back()->terms.ledger, sums);
}

TEST_F(Epochs, AnAcceptedConnectionReplacesTheSums) {
  std::shared_ptr<Ledger> sums;
  {
    Caller first(provider_, "a", 1);
    ASSERT_EQ(first.connect(5), "");
    sums = there_.channels().at(0)->terms.ledger;
  }
  Caller other(provider_, "a", 2), again(provider_, "a", 1);
  EXPECT_EQ(other.connect(6), "");
  EXPECT_EQ(again.connect(7), "");
  EXPECT_NE(there_.channels().back()->terms.ledger, sums);
}

TEST_F(Epochs, WithoutOneNoOtherConnectionEnds) {
  Caller first(provider_, "a"), second(provider_, "a");
  EXPECT_EQ(first.connect(0), "");
  EXPECT_EQ(second.connect(0), "");
  EXPECT_EQ(standing(), 2u);
}

}  // namespace
}  // namespace suture
