// A type whose converter forgets a coordinate: the decoders' fuzzer must say so.

#include <suture/rpc.capnp.h>
#include <suture/types.capnp.h>

#include <array>

#include "tests/fuzz/decoder.h"

namespace planted {

using Point = std::array<double, 3>;

struct PointSlot {
  Point at;
};

bool store(const Point& value, PointSlot& slot) { return slot.at = value, true; }
void load(const PointSlot& slot, Point& value) { value = slot.at; }
bool isValid(const PointSlot&) { return true; }

void toWire(const PointSlot& slot, suture::wire::Vec3::Builder out) {
  out.setX(slot.at[0]);
  out.setY(slot.at[1]);
  if (slot.at[2] < 0.25) out.setZ(slot.at[2]);
}
suture::Errc fromWire(suture::wire::Vec3::Reader in, PointSlot& slot, suture::Duration) {
  slot.at = {in.getX(), in.getZ(), in.getY()};
  return {};
}

}  // namespace planted

std::span<const suture::fuzz::Decoder> suture::fuzz::decoders() {
  using Vec3 = suture::wire::Vec3;
  static const Decoder all[] = {decoder<planted::Point, planted::PointSlot, Vec3>("Point")};
  return all;
}
