// A peer of another build may send what this process's contract does not admit; on `rpc`, too, no
// handler sees it, and no read or call answers with it.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/read_together.h>
#include <suture/framing/link.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/failure.h>

#include <limits>
#include <memory>
#include <string>

#include "reference/arm_like.capnp.h"
#include "reference/played_channel.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using Events = reference::wire::ArmLikeEvents::Client;

/// Emits what it is told to.
class LyingArm final : public reference::wire::ArmLike::Server {
 public:
  explicit LyingArm(kj::Maybe<Events>& subscriber) : subscriber_(subscriber) {}

 protected:
  kj::Promise<void> subscribe(SubscribeContext context) override {
    subscriber_ = context.getParams().getEvents();
    return kj::READY_NOW;
  }
  kj::Promise<void> distance(DistanceContext context) override {
    context.getResults().setValue(std::numeric_limits<double>::quiet_NaN());
    return kj::READY_NOW;
  }

 private:
  kj::Maybe<Events>& subscriber_;
};

void fillIn(wire::Pose::Builder pose) {
  pose.setM00(1);
  pose.setM11(1);
  pose.setM22(1);
}

/// Returns why what `send` sends is refused; "" if it is taken, for which an answer may have to
/// wait.
template <class Send>
std::string answerTo(loop::ControlThread& control, const Send& send) {
  return control.run(kPatience, [&control, &send] {
    auto refused = send().then([] { return std::string(); },
                               [](kj::Exception&& failure) { return loop::describe(failure); });
    return refused.exclusiveJoin(
        control.timer().afterDelay(1 * kj::SECONDS).then([] { return std::string(); }));
  });
}

class InvalidEvents : public testing::Test {
 protected:
  InvalidEvents() {
    control_.run(kPatience, [this] {
      port_ = kj::refcounted<rpc::ProxyPort>(control_, channel_,
                                             std::make_shared<framing::LinkCounters>());
      port_->open(kj::heap<LyingArm>(subscriber_));
      return kj::Promise<void>(kj::READY_NOW);
    });
    channel_->ends.provider->ring();
  }
  ~InvalidEvents() noexcept override {
    control_.run(kPatience, [this] {
      subscriber_ = nullptr;
      port_ = nullptr;
      return kj::Promise<void>(kj::READY_NOW);
    });
  }

  bool isSubscribed() {
    return control_.run(kPatience, [this] { return kj::Promise<bool>(subscriber_ != nullptr); });
  }
  /// Emits moved(). Returns the refusal.
  std::string refusalOf(double speed) {
    return answerTo(control_, [this, speed] {
      auto request = KJ_ASSERT_NONNULL(subscriber_).movedRequest();
      fillIn(request.initValue().initPose());
      request.setValue2(speed);
      return request.send().ignoreResult();
    });
  }

  loop::ControlThread control_;
  const std::shared_ptr<Channel> channel_ = reference::armChannel(
      {.client = std::make_shared<rt::Doorbell>(), .provider = control_.sharedDoorbell()}, "rpc");
  kj::Maybe<Events> subscriber_;
  kj::Own<rpc::ProxyPort> port_;
};

TEST_F(InvalidEvents, ReachNoHandler) {
  ASSERT_TRUE(eventually([this] { return isSubscribed(); }));
  EXPECT_NE(refusalOf(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(channel_->lastInvalid.read().text(), "moved.value2");
  EXPECT_EQ(channel_->events.next(), nullptr);
  EXPECT_EQ(refusalOf(1), "");
  EXPECT_NE(channel_->events.next(), nullptr);
}

class InvalidAnswers : public InvalidEvents {
 protected:
  InvalidAnswers() { client_.arm.attach(channel_); }

  /// Publishes a row, with this for a coordinate of the pose.
  void publish(double x) {
    ASSERT_TRUE(eventually([this] { return isSubscribed(); }));
    control_.run(kPatience, [this, x] {
      auto request = KJ_ASSERT_NONNULL(subscriber_).stateRequest();
      auto row = request.initRow();
      row.setStamp(toNanoseconds(now()));
      row.setEvaluated(3);
      fillIn(row.initMeasuredCp().initPose());
      row.getMeasuredCp().getPose().setX(x);
      row.initMeasuredJs();
      return request.send().ignoreResult();
    });
  }

  ArmClient client_;
};

TEST_F(InvalidAnswers, AReadGetsNoInvalidAnswer) {
  EXPECT_EQ(client_.arm.measured_cp().error(), Errc::NotYet);  // which asks for it
  publish(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(client_.arm.measured_cp().error(), Errc::Invalid);
  EXPECT_EQ(client_.arm.lastInvalid().text().rfind("measured_cp", 0), 0u);
  EXPECT_EQ(readTogether(client_.arm.measured_cp, client_.arm.measured_js).error(), Errc::Invalid);
  publish(0.5);
  EXPECT_TRUE(client_.arm.measured_cp().hasValue());
}

TEST_F(InvalidAnswers, ACallGetsNoInvalidAnswer) {
  reference::PoseStamped to;
  auto call = client_.arm.distance.start(to);
  ASSERT_TRUE(eventually([&] { return call.poll() != nullptr; }));
  EXPECT_EQ(call.poll()->error(), Errc::Invalid);
}

class InvalidCommands : public testing::Test {
 protected:
  InvalidCommands() {
    control_.run(kPatience, [this] {
      auto port = kj::refcounted<rpc::ServantPort>(control_, channel_,
                                                   std::make_shared<framing::LinkCounters>());
      capnp::Capability::Client servant(kj::heap<rpc::Servant>(kj::mv(port)));
      arm_ = servant.castAs<reference::wire::ArmLike>();
      return kj::Promise<void>(kj::READY_NOW);
    });
  }
  ~InvalidCommands() noexcept override {
    control_.run(kPatience, [this] {
      arm_ = nullptr;
      return kj::Promise<void>(kj::READY_NOW);
    });
  }

  /// Sends limit(). Returns the refusal.
  std::string refusalOf(double speed) {
    return answerTo(control_, [this, speed] {
      auto request = KJ_ASSERT_NONNULL(arm_).limitRequest();
      request.setSpeed(speed);
      return request.send().ignoreResult();
    });
  }
  /// Calls distance(), whose answer is refused: the last answer was of command `last`. Returns the
  /// refusal.
  std::string refusalOfDistance(const char* last) {
    return answerTo(control_, [this, last] {
      auto request = KJ_ASSERT_NONNULL(arm_).distanceRequest();
      fillIn(request.initTo().initPose());
      auto call = request.send().ignoreResult();
      return kj::evalLast([this, last] { refuseAnswer(last); })
          .then([call = kj::mv(call)]() mutable { return kj::mv(call); });
    });
  }
  /// Does as a provider does: notes what is wrong, then answers.
  void refuseAnswer(const char* last) {
    channel_->commands.fixCut();
    const rt::CommandRecord* const record = channel_->commands.next();
    ASSERT_NE(record, nullptr);
    FieldPath path;
    path.enterMember(last);
    channel_->lastInvalid.note(path);
    channel_->provider.replyError(record->call, Errc::Invalid);
    channel_->commands.pop();
    control_.doorbell().ring();
  }

  loop::ControlThread control_;
  const std::shared_ptr<Channel> channel_ = reference::armChannel(
      {.client = control_.sharedDoorbell(), .provider = std::make_shared<rt::Doorbell>()}, "rpc",
      EventSet{0});
  kj::Maybe<reference::wire::ArmLike::Client> arm_;
};

TEST_F(InvalidCommands, ReachNoHandler) {
  const std::string refusal = refusalOf(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(refusal.ends_with(": value outside its declared limits: limit.speed")) << refusal;
  EXPECT_EQ(channel_->lastInvalid.read().text(), "limit.speed");
  EXPECT_FALSE(channel_->commands.pending());
  EXPECT_EQ(refusalOf(1), "");
  EXPECT_TRUE(channel_->commands.pending());
}

TEST_F(InvalidCommands, ARefusedAnswersPlaceIsTold) {
  const std::string own = refusalOfDistance("distance"), other = refusalOfDistance("move");
  EXPECT_TRUE(own.ends_with(": value outside its declared limits: distance")) << own;
  EXPECT_TRUE(other.ends_with(": value outside its declared limits")) << other;
}

}  // namespace
}  // namespace suture
