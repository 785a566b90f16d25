// A newer provider may have errors that this build does not know: the command may have run then.
#include <gtest/gtest.h>

#include "reference/played_channel.h"
#include "unit/component/arm_client.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

TEST(FrameErrors, LeaveTheOutcomeOpen) {
  const auto near = reference::armChannel(reference::playedEnds(), "frame");
  const auto far = reference::armChannel(reference::playedEnds(), "frame");
  JoinedLinks links;
  links.far->join(makeSide<ProviderSide>(far, 1));
  links.near->join(makeSide<ClientSide>(near, 1));
  ArmClient client;
  client.arm.attach(near);
  auto call = client.arm.reset.start();
  ASSERT_FALSE(call.poll());
  links.exchange();
  far->commands.fixCut();
  const rt::CommandRecord* const record = far->commands.next();
  ASSERT_NE(record, nullptr);
  far->provider.replyError(record->call, static_cast<Errc>(77));
  links.exchange();
  ASSERT_TRUE(call.poll());
  EXPECT_EQ(call.poll()->error(), Errc::OutcomeUnknown);
}

}  // namespace
}  // namespace suture::frame
