// This is a type whose converter forgets a coordinate: the decoders' fuzzer must say so.

#include "tests/fuzz/decoder.h"  // first

#include <suture/types.capnp.h>

#include <array>

namespace planted {

using Point = std::array<double, 3>;

struct PointSlot {
  Point at;
};

bool store(const Point& value, PointSlot& slot) { return slot.at = value, true; }
void load(const PointSlot& slot, Point& value) { value = slot.at; }
bool isValid(const PointSlot&, suture::FieldPath*) { return true; }

void toWire(const PointSlot& slot, suture::wire::Vec3::Builder out) {
  out.setX(slot.at[0]);
  out.setY(slot.at[1]);
}
suture::Errc fromWire(suture::wire::Vec3::Reader in, PointSlot& slot, suture::Duration) {
  slot.at = {in.getX(), in.getY(), in.getZ()};
  return {};
}

}  // namespace planted

std::span<const suture::fuzz::Decoder> suture::fuzz::decoders() {
  using Vec3 = suture::wire::Vec3;
  static const Decoder all[] = {decoder<planted::Point, planted::PointSlot, Vec3>("Point")};
  return all;
}
