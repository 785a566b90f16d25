#include "bench/compiler/fast_cdr.h"

#ifdef SUTURE_BENCH_FASTCDR
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <array>
#include <stdexcept>

#include "bench/timed_loops.h"

namespace bench {
namespace {

namespace cdr = eprosima::fastcdr;

using Buffer = std::array<char, 256>;

// An Isometry3d is 16 numbers, the last row constant: 9 and 3 travel, as in every other row.
void serialize(const robots::PosePrm& value, Buffer& buffer) {
  cdr::FastBuffer memory(buffer.data(), buffer.size());
  cdr::Cdr out(memory, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
  out.serialize_encapsulation();
  const Eigen::Matrix3d rotation = value.position.linear();
  const Eigen::Vector3d translation = value.position.translation();
  out.serializeArray(rotation.data(), 9);
  out.serializeArray(translation.data(), 3);
  out << static_cast<std::int64_t>(suture::toNanoseconds(value.timestamp));
  out << value.automatic_timestamp << value.valid << value.moving_frame << value.reference_frame;
}

void deserialize(Buffer& buffer, robots::PosePrm& value) {
  cdr::FastBuffer memory(buffer.data(), buffer.size());
  cdr::Cdr in(memory, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
  in.read_encapsulation();
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  in.deserializeArray(rotation.data(), 9);
  in.deserializeArray(translation.data(), 3);
  value.position.linear() = rotation;
  value.position.translation() = translation;
  std::int64_t stamp = 0;
  in >> stamp >> value.automatic_timestamp >> value.valid;
  in >> value.moving_frame >> value.reference_frame;
  value.timestamp = suture::fromNanoseconds(stamp);
}

}  // namespace

std::optional<Statistics> fastCdrBothWays(const robots::PosePrm& value, std::size_t loops,
                                          std::size_t length) {
  Buffer buffer{};
  robots::PosePrm back;
  serialize(value, buffer);
  deserialize(buffer, back);
  if (!back.position.isApprox(value.position) || back.moving_frame != value.moving_frame) {
    throw std::logic_error("the pose does not survive Fast CDR");
  }
  return timedLoops(loops, length, [&] {
    keep(value);
    serialize(value, buffer);
    keep(buffer);
    deserialize(buffer, back);
    keep(back);
  });
}

}  // namespace bench

#else

namespace bench {

std::optional<Statistics> fastCdrBothWays(const robots::PosePrm&, std::size_t, std::size_t) {
  return std::nullopt;
}

}  // namespace bench

#endif
