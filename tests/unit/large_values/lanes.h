#pragma once
// Tests of large values over each lane have these in common.

#include <gtest/gtest.h>
#include <suture/lane/frame/frame_lane.h>
#include <suture/manager/manager.h>

#include <algorithm>
#include <memory>
#include <string>

namespace large_values {

/// This is `frame` as between builds that differ.
inline const suture::Lane kEncoded{"frame-encoded"};

inline void addEncodedLane(suture::Manager& manager) {
  manager.addLane(std::make_unique<suture::frame::FrameLane>(kEncoded.name.c_str(),
                                                             suture::frame::Form::Encoded));
}

inline std::string nameOf(const testing::TestParamInfo<suture::Lane>& lane) {
  std::string name = toString(lane.param);
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace large_values
