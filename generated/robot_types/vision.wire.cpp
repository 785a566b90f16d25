// Written by suturec from robot_types/vision.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/vision.capnp.h"
#include "robot_types/vision.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PoseArraySlot& slot, wire::PoseArray::Builder out) {
  toWire(slot.reference_frame, out.initReferenceFrame(sizeOf(slot.reference_frame)));
  toWire(slot.moving_frames, out.initMovingFrames(sizeOf(slot.moving_frames)));
  suture::codec::toWireList(slot.positions, out.initPositions(sizeOf(slot.positions)),
                            [](const std::array<double, 12>& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.visible, out.initVisible(sizeOf(slot.visible)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::PoseArray::Reader in, PoseArraySlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      fromWire(in.getMovingFrames(), slot.moving_frames),
      suture::codec::fromWireList(in.getPositions(), slot.positions,
                                  [](auto item, std::array<double, 12>& target) {
                                    return fromWire(item, target);
                                  }),
      fromWire(in.getVisible(), slot.visible),
  });
}

void toWire(const ImageFrameSlot& slot, wire::ImageFrame::Builder out) {
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  out.setChannels(slot.channels);
  toWire(slot.data, out.initData(sizeOf(slot.data)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::ImageFrame::Reader in, ImageFrameSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.channels = in.getChannels();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return fromWire(in.getData(), slot.data);
}

void toWire(const CameraInfoSlot& slot, wire::CameraInfo::Builder out) {
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  toWire(slot.distortion, out.initDistortion(5));
  toWire(slot.intrinsic, out.initIntrinsic());
  toWire(slot.rectification, out.initRectification());
  toWire(slot.projection, out.initProjection(12));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::CameraInfo::Reader in, CameraInfoSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getDistortion(), slot.distortion),
      in.hasIntrinsic() ? fromWire(in.getIntrinsic(), slot.intrinsic)
          : suture::codec::fromDefault(CameraInfo().intrinsic, slot.intrinsic),
      in.hasRectification() ? fromWire(in.getRectification(), slot.rectification)
          : suture::codec::fromDefault(CameraInfo().rectification, slot.rectification),
      in.getProjection().size() != 0 ? fromWire(in.getProjection(), slot.projection)
          : suture::codec::fromDefault(CameraInfo().projection, slot.projection),
  });
}

void toWire(const DepthMapSlot& slot, wire::DepthMap::Builder out) {
  toWire(slot.reference_frame, out.initReferenceFrame(sizeOf(slot.reference_frame)));
  out.setWidth(slot.width);
  out.setHeight(slot.height);
  toWire(slot.points, out.initPoints(sizeOf(slot.points)));
  toWire(slot.color, out.initColor(sizeOf(slot.color)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::DepthMap::Reader in, DepthMapSlot& slot, suture::Duration shift) {
  slot.width = in.getWidth();
  slot.height = in.getHeight();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      fromWire(in.getPoints(), slot.points),
      fromWire(in.getColor(), slot.color),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseArray& value) {
  return codec::encodeAs<robots::wire::PoseArray, robots::PoseArraySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseArray& value) {
  return codec::decodeAs<robots::wire::PoseArray, robots::PoseArraySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ImageFrame& value) {
  return codec::encodeAs<robots::wire::ImageFrame, robots::ImageFrameSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ImageFrame& value) {
  return codec::decodeAs<robots::wire::ImageFrame, robots::ImageFrameSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::CameraInfo& value) {
  return codec::encodeAs<robots::wire::CameraInfo, robots::CameraInfoSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CameraInfo& value) {
  return codec::decodeAs<robots::wire::CameraInfo, robots::CameraInfoSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::DepthMap& value) {
  return codec::encodeAs<robots::wire::DepthMap, robots::DepthMapSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::DepthMap& value) {
  return codec::decodeAs<robots::wire::DepthMap, robots::DepthMapSlot>(bytes, value);
}

}  // namespace suture
