// Written by suturec from robot_types/kinematics_query.h. Do not edit.
#include "robot_types/kinematics_query.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/kinematics_query.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(ForwardKinematicsRequest::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::cp), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::result), bool>);
static_assert(std::is_same_v<decltype(ForwardKinematicsResponse::message), std::string>);
static_assert(std::is_same_v<decltype(InverseKinematicsRequest::cp), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(InverseKinematicsRequest::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::jp), std::vector<double>>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::result), bool>);
static_assert(std::is_same_v<decltype(InverseKinematicsResponse::message), std::string>);

}  // namespace

bool store(const ForwardKinematicsRequest& value, ForwardKinematicsRequestSlot& slot) {
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  return fits;
}

void load(const ForwardKinematicsRequestSlot& slot, ForwardKinematicsRequest& value) {
  load(slot.jp, value.jp);
}

void reserve(const ForwardKinematicsRequestSlot*, ForwardKinematicsRequest& value) {
  suture::reserveFor<decltype(ForwardKinematicsRequestSlot::jp)>(value.jp);
}

bool store(const ForwardKinematicsResponse& value, ForwardKinematicsResponseSlot& slot) {
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

void load(const ForwardKinematicsResponseSlot& slot, ForwardKinematicsResponse& value) {
  load(slot.cp, value.cp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

void reserve(const ForwardKinematicsResponseSlot*, ForwardKinematicsResponse& value) {
  suture::reserveFor<decltype(ForwardKinematicsResponseSlot::message)>(value.message);
}

bool store(const InverseKinematicsRequest& value, InverseKinematicsRequestSlot& slot) {
  bool fits = true;
  fits &= store(value.cp, slot.cp);
  fits &= store(value.jp, slot.jp);
  return fits;
}

void load(const InverseKinematicsRequestSlot& slot, InverseKinematicsRequest& value) {
  load(slot.cp, value.cp);
  load(slot.jp, value.jp);
}

void reserve(const InverseKinematicsRequestSlot*, InverseKinematicsRequest& value) {
  suture::reserveFor<decltype(InverseKinematicsRequestSlot::jp)>(value.jp);
}

bool store(const InverseKinematicsResponse& value, InverseKinematicsResponseSlot& slot) {
  bool fits = true;
  fits &= store(value.jp, slot.jp);
  fits &= store(value.result, slot.result);
  fits &= store(value.message, slot.message);
  return fits;
}

void load(const InverseKinematicsResponseSlot& slot, InverseKinematicsResponse& value) {
  load(slot.jp, value.jp);
  load(slot.result, value.result);
  load(slot.message, value.message);
}

void reserve(const InverseKinematicsResponseSlot*, InverseKinematicsResponse& value) {
  suture::reserveFor<decltype(InverseKinematicsResponseSlot::jp)>(value.jp);
  suture::reserveFor<decltype(InverseKinematicsResponseSlot::message)>(value.message);
}

// --- between slots and Cap'n Proto

void toWire(const ForwardKinematicsRequestSlot& slot, wire::ForwardKinematicsRequest::Builder out) {
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
}

suture::Errc fromWire(wire::ForwardKinematicsRequest::Reader in, ForwardKinematicsRequestSlot& slot,
                      suture::Duration) {
  return fromWire(in.getJp(), slot.jp);
}

bool isValid(const ForwardKinematicsRequestSlot& slot, suture::FieldPath* path) {
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

void toWire(const ForwardKinematicsResponseSlot& slot, wire::ForwardKinematicsResponse::Builder out) {
  toWire(slot.cp, out.initCp());
  out.setResult(slot.result != 0);
  toWire(slot.message, out.initMessage(sizeOf(slot.message)));
}

suture::Errc fromWire(wire::ForwardKinematicsResponse::Reader in,
                      ForwardKinematicsResponseSlot& slot, suture::Duration) {
  slot.result = in.getResult();
  return suture::rpc::firstError({
      in.hasCp() ? fromWire(in.getCp(), slot.cp)
          : suture::rpc::fromDefault(ForwardKinematicsResponse().cp, slot.cp),
      fromWire(in.getMessage(), slot.message),
  });
}

bool isValid(const ForwardKinematicsResponseSlot& slot, suture::FieldPath* path) {
  return isValid(slot.cp) || suture::refusedAt(path, "cp");
}

void toWire(const InverseKinematicsRequestSlot& slot, wire::InverseKinematicsRequest::Builder out) {
  toWire(slot.cp, out.initCp());
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
}

suture::Errc fromWire(wire::InverseKinematicsRequest::Reader in, InverseKinematicsRequestSlot& slot,
                      suture::Duration) {
  return suture::rpc::firstError({
      in.hasCp() ? fromWire(in.getCp(), slot.cp)
          : suture::rpc::fromDefault(InverseKinematicsRequest().cp, slot.cp),
      fromWire(in.getJp(), slot.jp),
  });
}

bool isValid(const InverseKinematicsRequestSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.cp)) return suture::refusedAt(path, "cp");
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

void toWire(const InverseKinematicsResponseSlot& slot, wire::InverseKinematicsResponse::Builder out) {
  toWire(slot.jp, out.initJp(sizeOf(slot.jp)));
  out.setResult(slot.result != 0);
  toWire(slot.message, out.initMessage(sizeOf(slot.message)));
}

suture::Errc fromWire(wire::InverseKinematicsResponse::Reader in,
                      InverseKinematicsResponseSlot& slot, suture::Duration) {
  slot.result = in.getResult();
  return suture::rpc::firstError({
      fromWire(in.getJp(), slot.jp),
      fromWire(in.getMessage(), slot.message),
  });
}

bool isValid(const InverseKinematicsResponseSlot& slot, suture::FieldPath* path) {
  return isValid(slot.jp, path) || suture::refusedAt(path, "jp");
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsRequest& value) {
  return rpc::encodeAs<robots::wire::ForwardKinematicsRequest,
                       robots::ForwardKinematicsRequestSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsRequest& value) {
  return rpc::decodeAs<robots::wire::ForwardKinematicsRequest,
                       robots::ForwardKinematicsRequestSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ForwardKinematicsResponse& value) {
  return rpc::encodeAs<robots::wire::ForwardKinematicsResponse,
                       robots::ForwardKinematicsResponseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ForwardKinematicsResponse& value) {
  return rpc::decodeAs<robots::wire::ForwardKinematicsResponse,
                       robots::ForwardKinematicsResponseSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsRequest& value) {
  return rpc::encodeAs<robots::wire::InverseKinematicsRequest,
                       robots::InverseKinematicsRequestSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsRequest& value) {
  return rpc::decodeAs<robots::wire::InverseKinematicsRequest,
                       robots::InverseKinematicsRequestSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::InverseKinematicsResponse& value) {
  return rpc::encodeAs<robots::wire::InverseKinematicsResponse,
                       robots::InverseKinematicsResponseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::InverseKinematicsResponse& value) {
  return rpc::decodeAs<robots::wire::InverseKinematicsResponse,
                       robots::InverseKinematicsResponseSlot>(bytes, value);
}

}  // namespace suture
