// Written by suturec from robot_types/kinematics_query.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/kinematics_query.capnp.h"
#include "robot_types/kinematics_query.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const ForwardKinematicsRequestSlot& slot, wire::ForwardKinematicsRequest::Builder out) {
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
}

suture::Errc fromWire(wire::ForwardKinematicsRequest::Reader in, ForwardKinematicsRequestSlot& slot,
                      suture::Duration) {
  return fromWire(in.getJp(), slot.jp);
}

void toWire(const ForwardKinematicsResponseSlot& slot, wire::ForwardKinematicsResponse::Builder out) {
  toWire(slot.cp, out.initCp());
  out.setResult(slot.result != 0);
  toWire(slot.message, out.initMessage(sizeOf(slot.message)));
}

suture::Errc fromWire(wire::ForwardKinematicsResponse::Reader in,
                      ForwardKinematicsResponseSlot& slot, suture::Duration) {
  slot.result = in.getResult();
  return suture::codec::firstError({
      in.hasCp() ? fromWire(in.getCp(), slot.cp)
          : suture::codec::fromDefault(ForwardKinematicsResponse().cp, slot.cp),
      fromWire(in.getMessage(), slot.message),
  });
}

void toWire(const InverseKinematicsRequestSlot& slot, wire::InverseKinematicsRequest::Builder out) {
  toWire(slot.cp, out.initCp());
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
}

suture::Errc fromWire(wire::InverseKinematicsRequest::Reader in, InverseKinematicsRequestSlot& slot,
                      suture::Duration) {
  return suture::codec::firstError({
      in.hasCp() ? fromWire(in.getCp(), slot.cp)
          : suture::codec::fromDefault(InverseKinematicsRequest().cp, slot.cp),
      fromWire(in.getJp(), slot.jp),
  });
}

void toWire(const InverseKinematicsResponseSlot& slot, wire::InverseKinematicsResponse::Builder out) {
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
  out.setResult(slot.result != 0);
  toWire(slot.message, out.initMessage(sizeOf(slot.message)));
}

suture::Errc fromWire(wire::InverseKinematicsResponse::Reader in,
                      InverseKinematicsResponseSlot& slot, suture::Duration) {
  slot.result = in.getResult();
  return suture::codec::firstError({
      fromWire(in.getJp(), slot.jp),
      fromWire(in.getMessage(), slot.message),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsRequest& value) {
  return codec::encodeAs<robots::wire::ForwardKinematicsRequest,
                         robots::ForwardKinematicsRequestSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsRequest& value) {
  return codec::decodeAs<robots::wire::ForwardKinematicsRequest,
                         robots::ForwardKinematicsRequestSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsResponse& value) {
  return codec::encodeAs<robots::wire::ForwardKinematicsResponse,
                         robots::ForwardKinematicsResponseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsResponse& value) {
  return codec::decodeAs<robots::wire::ForwardKinematicsResponse,
                         robots::ForwardKinematicsResponseSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsRequest& value) {
  return codec::encodeAs<robots::wire::InverseKinematicsRequest,
                         robots::InverseKinematicsRequestSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsRequest& value) {
  return codec::decodeAs<robots::wire::InverseKinematicsRequest,
                         robots::InverseKinematicsRequestSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsResponse& value) {
  return codec::encodeAs<robots::wire::InverseKinematicsResponse,
                         robots::InverseKinematicsResponseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsResponse& value) {
  return codec::decodeAs<robots::wire::InverseKinematicsResponse,
                         robots::InverseKinematicsResponseSlot>(bytes, value);
}

}  // namespace suture
