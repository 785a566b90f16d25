// Where clocks differ, a stamp is given on the reader's clock.
#include <gtest/gtest.h>

#include "reference/played_channel.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

using namespace std::chrono_literals;

constexpr std::uint16_t kHoldMethod = 2, kStoppedMethod = 2;

/// Makes a channel to a process whose clock stands so to this one's.
std::shared_ptr<Channel> makeChannel(Duration shift) {
  return reference::armChannel(reference::playedEnds(reference::peerWithClock(shift)), "frame");
}

struct StampedEnds {
  explicit StampedEnds(Form form) {
    links.far->join(makeSide<ProviderSide>(far, 1, form));
    links.near->join(makeSide<ClientSide>(near, 1, form));
  }

  const std::shared_ptr<Channel> near = makeChannel(-7s), far = makeChannel(-5s);
  JoinedLinks links;
};

class FrameStamps : public testing::TestWithParam<Form> {};
INSTANTIATE_TEST_SUITE_P(InEachForm, FrameStamps, testing::Values(Form::Slots, Form::Encoded),
                         [](const auto& one) {
                           return one.param == Form::Slots ? "Slots" : "Encoded";
                         });

TEST_P(FrameStamps, CommandStampsAreOfTheProvidersClock) {
  StampedEnds ends(GetParam());
  const Time sent = now();
  ASSERT_TRUE(ends.near->commands.claim(kHoldMethod, sent, 0));
  ends.near->commands.commit();
  ends.links.exchange();
  ends.far->commands.fixCut();
  const rt::CommandRecord* const record = ends.far->commands.next();
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->stamp, sent - 5s);
}

TEST_P(FrameStamps, StampsAreOfTheClientsClock) {
  StampedEnds ends(GetParam());
  ends.near->state->ask(0);
  ends.links.exchange();
  const Time produced = now();
  ASSERT_TRUE(ends.far->events.push(kStoppedMethod, produced, {}));
  ends.far->state->publish(produced, {.valid = 1});
  ends.links.exchange();
  const rt::EventRecord* const event = ends.near->events.next();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->stamp, produced - 7s);
  EXPECT_EQ(ends.near->state->readRowNumber(1, {}).stamp, produced - 7s);
}

TEST_P(FrameStamps, NoStampIsInTheFuture) {
  StampedEnds ends(GetParam());
  ASSERT_TRUE(ends.far->events.push(kStoppedMethod, now() + 1h, {}));
  ends.links.exchange();
  const rt::EventRecord* const event = ends.near->events.next();
  ASSERT_NE(event, nullptr);
  EXPECT_LE(event->stamp, now());
}

}  // namespace
}  // namespace suture::frame
