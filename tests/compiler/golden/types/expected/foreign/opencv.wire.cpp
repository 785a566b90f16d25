// Written by suturec from foreign/opencv.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "foreign/opencv.capnp.h"
#include "foreign/opencv.suture.h"

namespace foreign {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const cvPoint3dSlot& slot, wire::Point3d::Builder out) {
  out.setX(slot.x);
  out.setY(slot.y);
  out.setZ(slot.z);
}

suture::Errc fromWire(wire::Point3d::Reader in, cvPoint3dSlot& slot, suture::Duration) {
  slot.x = in.getX();
  slot.y = in.getY();
  slot.z = in.getZ();
  return suture::Errc{};
}

void toWire(const cvMatx33dSlot& slot, wire::Matx33d::Builder out) {
  toWire(slot.val, out.initVal(9));
}

suture::Errc fromWire(wire::Matx33d::Reader in, cvMatx33dSlot& slot, suture::Duration) {
  return in.getVal().size() != 0 ? fromWire(in.getVal(), slot.val)
      : suture::codec::fromDefault(cv::Matx33d().val, slot.val);
}

void toWire(const ViewSlot& slot, wire::View::Builder out) {
  toWire(slot.intrinsics, out.initIntrinsics());
  suture::codec::toWireList(slot.points, out.initPoints(sizeOf(slot.points)),
                            [](const cvPoint3dSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::View::Reader in, ViewSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getIntrinsics(), slot.intrinsics, shift),
      suture::codec::fromWireList(in.getPoints(), slot.points,
                                  [&](auto item, cvPoint3dSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
  });
}

// --- Camera as Cap'n Proto

namespace {

void encodeCameraAim(const CameraAimArguments& slot, wire::Camera::AimParams::Builder out) {
  toWire(slot.at, out.initAt());
}
suture::Errc decodeCameraAim(wire::Camera::AimParams::Reader in, CameraAimArguments& slot,
                             suture::Duration shift) {
  return in.hasAt() ? fromWire(in.getAt(), slot.at, shift) : suture::Errc::Invalid;
}

void encodeCameraViewResult(const ViewSlot& slot, wire::Camera::ViewResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCameraViewResult(wire::Camera::ViewResults::Reader in, ViewSlot& slot,
                                    suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCameraViewColumn(const ViewSlot& slot, wire::CameraStateRow::Builder out) {
  toWire(slot, out.initView());
}
suture::Errc decodeCameraViewColumn(wire::CameraStateRow::Reader in, ViewSlot& slot,
                                    suture::Duration shift) {
  return in.hasView() ? fromWire(in.getView(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeCameraColumn(unsigned column, const std::byte* memory,
                        wire::CameraStateRow::Builder out) {
  switch (column) {
    case CameraColumn::view: return encodeCameraViewColumn(suture::slotIn<ViewSlot>(memory), out);
  }
}
suture::Errc decodeCameraColumn(wire::CameraStateRow::Reader in, unsigned column, std::byte* memory,
                                suture::Duration shift) {
  switch (column) {
    case CameraColumn::view:
      return decodeCameraViewColumn(in, suture::newSlot<ViewSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kCameraCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Camera>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Camera::AimParams>,
     .arguments = suture::codec::messageOf<wire::Camera::AimParams, CameraAimArguments,
                                           encodeCameraAim, decodeCameraAim>},
    {.interface = capnp::typeId<wire::Camera>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Camera::ViewParams>,
     .result = suture::codec::messageOf<wire::Camera::ViewResults, ViewSlot, encodeCameraViewResult,
                                        decodeCameraViewResult>,
     .stamp = suture::codec::stampIn<wire::Camera::ViewResults>},
};

}  // namespace

const suture::codec::Codec& cameraCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Camera>,
      .contract = capnp::typeId<wire::Camera>(),
      .subscriber = capnp::typeId<wire::CameraEvents>(),
      .commands = kCameraCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::CameraEvents::StateParams, wire::CameraStateRow,
                                  encodeCameraColumn, decodeCameraColumn>,
  };
  return kCodec;
}

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const cv::Point3d& value) {
  return codec::encodeAs<foreign::wire::Point3d, foreign::cvPoint3dSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, cv::Point3d& value) {
  return codec::decodeAs<foreign::wire::Point3d, foreign::cvPoint3dSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const cv::Matx33d& value) {
  return codec::encodeAs<foreign::wire::Matx33d, foreign::cvMatx33dSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, cv::Matx33d& value) {
  return codec::decodeAs<foreign::wire::Matx33d, foreign::cvMatx33dSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::View& value) {
  return codec::encodeAs<foreign::wire::View, foreign::ViewSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::View& value) {
  return codec::decodeAs<foreign::wire::View, foreign::ViewSlot>(bytes, value);
}

}  // namespace suture
