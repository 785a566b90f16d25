#pragma once
// These convert between slots and the wire, for Eigen types with a named form. They are inline,
// because they are the inner loop of every pose that travels. Part of wire.h.

#include <capnp/any.h>
#include <suture/base/errors.h>
#include <suture/types.capnp.h>

#include <array>

namespace suture::codec {

// The slot is column-major, alone or in front of a translation.
template <std::size_t N, class Builder>
void rotationToWire(const std::array<double, N>& slot, Builder& out) {
  out.setM00(slot[0]);
  out.setM10(slot[1]);
  out.setM20(slot[2]);
  out.setM01(slot[3]);
  out.setM11(slot[4]);
  out.setM21(slot[5]);
  out.setM02(slot[6]);
  out.setM12(slot[7]);
  out.setM22(slot[8]);
}

/// Returns false for a struct that an older sender does not know: a null pointer reads as one
/// without data.
template <class Reader>
bool wasSent(Reader in) {
  return capnp::AnyStruct::Reader(in).getDataSection().size() != 0;
}

inline constexpr std::array<double, 4> kNoTurn = {1, 0, 0, 0};  // w, x, y, z
inline constexpr std::array<double, 12> kNoMotion = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

inline void toWire(const std::array<double, 2>& slot, wire::Vec2::Builder out) {
  out.setX(slot[0]);
  out.setY(slot[1]);
}

inline void toWire(const std::array<double, 3>& slot, wire::Vec3::Builder out) {
  out.setX(slot[0]);
  out.setY(slot[1]);
  out.setZ(slot[2]);
}

inline void toWire(const std::array<double, 4>& slot, wire::Vec4::Builder out) {
  out.setX(slot[0]);
  out.setY(slot[1]);
  out.setZ(slot[2]);
  out.setW(slot[3]);
}

inline void toWire(const std::array<double, 4>& slot, wire::Quat::Builder out) {
  out.setW(slot[0]);
  out.setX(slot[1]);
  out.setY(slot[2]);
  out.setZ(slot[3]);
}

inline void toWire(const std::array<double, 9>& slot, wire::Mat3::Builder out) {
  rotationToWire(slot, out);
}

inline void toWire(const std::array<double, 16>& slot, wire::Mat4::Builder out) {
  out.setM00(slot[0]);
  out.setM10(slot[1]);
  out.setM20(slot[2]);
  out.setM30(slot[3]);
  out.setM01(slot[4]);
  out.setM11(slot[5]);
  out.setM21(slot[6]);
  out.setM31(slot[7]);
  out.setM02(slot[8]);
  out.setM12(slot[9]);
  out.setM22(slot[10]);
  out.setM32(slot[11]);
  out.setM03(slot[12]);
  out.setM13(slot[13]);
  out.setM23(slot[14]);
  out.setM33(slot[15]);
}

inline void toWire(const std::array<double, 12>& slot, wire::Pose::Builder out) {
  rotationToWire(slot, out);
  out.setX(slot[9]);
  out.setY(slot[10]);
  out.setZ(slot[11]);
}

inline Errc fromWire(wire::Vec2::Reader in, std::array<double, 2>& slot) {
  slot = {in.getX(), in.getY()};
  return Errc{};
}

inline Errc fromWire(wire::Vec3::Reader in, std::array<double, 3>& slot) {
  slot = {in.getX(), in.getY(), in.getZ()};
  return Errc{};
}

inline Errc fromWire(wire::Vec4::Reader in, std::array<double, 4>& slot) {
  slot = {in.getX(), in.getY(), in.getZ(), in.getW()};
  return Errc{};
}

inline Errc fromWire(wire::Quat::Reader in, std::array<double, 4>& slot) {
  slot = wasSent(in) ? std::array{in.getW(), in.getX(), in.getY(), in.getZ()} : kNoTurn;
  return Errc{};
}

inline Errc fromWire(wire::Mat3::Reader in, std::array<double, 9>& slot) {
  slot = {in.getM00(), in.getM10(), in.getM20(), in.getM01(), in.getM11(),
          in.getM21(), in.getM02(), in.getM12(), in.getM22()};
  return Errc{};
}

inline Errc fromWire(wire::Mat4::Reader in, std::array<double, 16>& slot) {
  slot = {in.getM00(), in.getM10(), in.getM20(), in.getM30(), in.getM01(), in.getM11(),
          in.getM21(), in.getM31(), in.getM02(), in.getM12(), in.getM22(), in.getM32(),
          in.getM03(), in.getM13(), in.getM23(), in.getM33()};
  return Errc{};
}

/// Reads a transform whose linear part may be anything.
inline Errc fromWireAffine(wire::Pose::Reader in, std::array<double, 12>& slot) {
  if (!wasSent(in)) return slot = kNoMotion, Errc{};
  slot = {in.getM00(), in.getM10(), in.getM20(), in.getM01(), in.getM11(), in.getM21(),
          in.getM02(), in.getM12(), in.getM22(), in.getX(),   in.getY(),   in.getZ()};
  return Errc{};
}

inline Errc fromWire(wire::Pose::Reader in, std::array<double, 12>& slot) {
  fromWireAffine(in, slot);
  // No rotation has a column of zeros, so no sender has set this one.
  const bool set = slot[0] != 0 || slot[1] != 0 || slot[2] != 0;
  return set ? Errc{} : Errc::Invalid;
}

}  // namespace suture::codec
