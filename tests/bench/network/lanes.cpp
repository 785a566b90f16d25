#include "bench/network/lanes.h"

#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/lane/frame/frame_lane.h>

#include <memory>

namespace bench {

void addEncodedFrames(suture::Manager& manager) {
  manager.addLane(std::make_unique<suture::frame::FrameLane>(kEncodedFrames.name.c_str(),
                                                             suture::frame::Form::Encoded));
}

void connectBy(const suture::Lane& lane, suture::Manager& manager, const std::string& required,
               const std::string& provided, const suture::ConnectionContract& contract) {
  manager.connect(required, provided, {.lane = lane, .contract = contract});
  for (const auto& channel : manager.channels()) {
    const bool isThis = channel->name().find(":" + required + " -> ") != std::string::npos;
    if (!isThis || channel->lane == toString(lane)) continue;
    throw suture::SetupError(std::string("a connection over the lane ") + toString(lane),
                             "lane " + channel->lane + " " + channel->terms.laneReason,
                             "The figures would be those of another");
  }
}

}  // namespace bench
