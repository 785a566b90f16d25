#include "rivals/fastdds_types.h"

#include <fastcdr/FastBuffer.h>
#include <fastdds/rtps/common/SerializedPayload.h>

namespace peers::fastdds {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kPadding = 3;

void put(Cdr& to, const Pose& pose) {
  to << pose.rotation << pose.position << pose.timestamp << pose.valid << pose.frame
     << pose.reference;
}
void get(Cdr& from, Pose& pose) {
  from >> pose.rotation >> pose.position >> pose.timestamp >> pose.valid >> pose.frame >>
      pose.reference;
}
std::size_t textBytes(const std::string& text) { return kPadding + 4 + text.size() + 1; }
std::size_t bytesOf(const Pose& pose) {
  return kEncapsulation + 13 * sizeof(double) + 1 + textBytes(pose.frame) +
         textBytes(pose.reference);
}

void put(Cdr& to, const Blob& blob) { to << blob.timestamp << blob.data; }
void get(Cdr& from, Blob& blob) { from >> blob.timestamp >> blob.data; }
std::size_t bytesOf(const Blob& blob) {
  return kEncapsulation + (2 + blob.data.size()) * sizeof(double);
}

}  // namespace

template <class Value>
bool ValueType<Value>::serialize(void* value, rtps::SerializedPayload_t* payload) {
  FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
  Cdr to(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  payload->encapsulation = CDR_LE;
  to.serialize_encapsulation();
  put(to, *static_cast<const Value*>(value));
  payload->length = static_cast<std::uint32_t>(to.getSerializedDataLength());
  return true;
}

template <class Value>
bool ValueType<Value>::deserialize(rtps::SerializedPayload_t* payload, void* value) {
  FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
  Cdr from(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  from.read_encapsulation();
  get(from, *static_cast<Value*>(value));
  return true;
}

template <class Value>
std::function<std::uint32_t()> ValueType<Value>::getSerializedSizeProvider(void* value) {
  const auto bytes = static_cast<std::uint32_t>(bytesOf(*static_cast<const Value*>(value)));
  return [bytes] { return bytes; };
}

template class ValueType<Pose>;
template class ValueType<Blob>;

}  // namespace peers::fastdds
