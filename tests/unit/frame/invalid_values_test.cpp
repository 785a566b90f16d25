// A provider of another build may send rows and answers that this process's contract does not
// admit, in frames that are whole: no read and no call answers with them.
#include <gtest/gtest.h>
#include <suture/component/read_together.h>

#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "reference/played_channel.h"
#include "unit/component/arm_client.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned kMeasuredCp = 0, kMeasuredJs = 1;

/// The test plays the provider.
class InvalidFrames : public testing::TestWithParam<Form> {
 protected:
  InvalidFrames() {
    links_.far->join(makeSide<ProviderSide>(far_, 1, GetParam()));
    links_.near->join(makeSide<ClientSide>(near_, 1, GetParam()));
    client_.arm.attach(near_);
  }

  /// Publishes a row of both reads, with this for a coordinate of the pose.
  void publish(double x) {
    reference::PoseStamped pose;
    pose.pose.translation().x() = x;
    auto& slot = *new (far_->state->draft(kMeasuredCp)) reference::PoseStampedSlot();
    ASSERT_TRUE(store(pose, slot));
    new (far_->state->draft(kMeasuredJs)) reference::JointStateSlot();
    far_->state->publish(now(), {.valid = 1 << kMeasuredCp | 1 << kMeasuredJs});
    links_.exchange();
  }
  /// Answers the call that waits with this distance.
  void answer(double distance) {
    links_.exchange();
    far_->commands.fixCut();
    const rt::CommandRecord* const record = far_->commands.next();
    ASSERT_NE(record, nullptr);
    ASSERT_TRUE(far_->provider.claim(record->call));
    const ResultForm form{.size = sizeof(distance), .command = record->command};
    far_->provider.reply(record->call, form, [&](std::byte* result) {
      std::memcpy(result, &distance, sizeof(distance));
      return Errc{};
    });
    far_->commands.pop();
    links_.exchange();
  }

  const std::shared_ptr<Channel> near_ = reference::armChannel(reference::playedEnds(), "frame"),
                                 far_ = reference::armChannel(reference::playedEnds(), "frame");
  JoinedLinks links_;
  ArmClient client_;
};

INSTANTIATE_TEST_SUITE_P(InEachForm, InvalidFrames, testing::Values(Form::Slots, Form::Encoded),
                         [](const auto& one) {
                           return one.param == Form::Slots ? "Slots" : "Encoded";
                         });

TEST_P(InvalidFrames, AReadGetsNoInvalidRow) {
  EXPECT_EQ(client_.arm.measured_cp().error(), Errc::NotYet);  // which asks for it
  EXPECT_EQ(client_.arm.measured_js().error(), Errc::NotYet);
  links_.exchange();
  publish(kNoNumber);
  const Time published = now();
  EXPECT_EQ(client_.arm.measured_cp().error(), Errc::Invalid);
  EXPECT_EQ(client_.arm.lastInvalid().text(), "measured_cp.pose");
  EXPECT_EQ(client_.arm.measured_cp.at(published).error(), Errc::Invalid);
  EXPECT_EQ(readTogether(client_.arm.measured_cp, client_.arm.measured_js).error(), Errc::Invalid);
  EXPECT_TRUE(client_.arm.measured_js().hasValue()) << "the rest of the row is valid";
  publish(0.5);
  EXPECT_TRUE(client_.arm.measured_cp().hasValue());
}

TEST_P(InvalidFrames, ACallGetsNoInvalidAnswer) {
  auto call = client_.arm.distance.start({});
  answer(kNoNumber);
  ASSERT_NE(call.poll(), nullptr);
  EXPECT_EQ(call.poll()->error(), Errc::Invalid);
  EXPECT_EQ(client_.arm.lastInvalid().text(), "distance");
  call = client_.arm.distance.start({});
  answer(0.5);
  ASSERT_NE(call.poll(), nullptr);
  EXPECT_EQ(call.poll()->value(), 0.5);
}

}  // namespace
}  // namespace suture::frame
