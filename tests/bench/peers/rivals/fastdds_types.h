#pragma once
// Fast DDS is told by these how the pose and the blob travel; Fast CDR does the work.

#include <fastcdr/Cdr.h>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <functional>

#include "harness/pose.h"

namespace peers::fastdds {

namespace rtps = eprosima::fastrtps::rtps;

/// It does what both have in common.
template <class Value>
class ValueType : public eprosima::fastdds::dds::TopicDataType {
 public:
  ValueType(const char* name, std::uint32_t mostBytes) {
    setName(name);
    m_typeSize = mostBytes;
    m_isGetKeyDefined = false;
  }

  bool serialize(void* value, rtps::SerializedPayload_t* payload) override;
  bool deserialize(rtps::SerializedPayload_t* payload, void* value) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* value) override;
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
  void* createData() override { return new Value; }
  void deleteData(void* value) override { delete static_cast<Value*>(value); }
};

struct PoseType final : ValueType<Pose> {
  PoseType() : ValueType("Pose", 256) {}
};
struct BlobType final : ValueType<Blob> {
  BlobType() : ValueType("Blob", (1u << 20) + 64) {}
};

}  // namespace peers::fastdds
