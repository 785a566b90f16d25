#pragma once
// A participant of Cyclone DDS has these topics, which all of its processes share.

extern "C" {
#include "PoseDds.h"
}
#include <dds/dds.h>

#include <cstdint>
#include <string>

#include "harness/fail.h"

namespace peers::cyclone {

enum class Topic { PoseRequest, PoseAnswer, BlobRequest, BlobAnswer, Stream };

/// Ends the process if `result` is an error.
dds_return_t checked(dds_return_t result, const char* what);

class Node {
 public:
  Node();
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  dds_entity_t writer(Topic topic);
  dds_entity_t reader(Topic topic, const dds_listener_t* listener = nullptr);
  dds_entity_t waitset();

 private:
  dds_entity_t made(Topic topic);

  dds_entity_t participant_;
  dds_qos_t* const quality_;
};

void write(dds_entity_t writer, const void* sample);
/// Makes the waitset wake with `token` when the reader has data.
void attach(dds_entity_t waitset, dds_entity_t reader, dds_attach_t token);

/// Calls `take` with each sample that is there, which the library lends. Returns how many.
template <class Sample, class Take>
int takeAll(dds_entity_t reader, const Take& take) {
  constexpr int kMost = 32;
  int valid = 0;
  for (int taken = kMost; taken == kMost;) {
    void* samples[kMost] = {};
    dds_sample_info_t infos[kMost];
    taken = checked(dds_take(reader, samples, infos, kMost, kMost), "take");
    for (int i = 0; i < taken; ++i) {
      if (!infos[i].valid_data) continue;
      take(*static_cast<const Sample*>(samples[i]));
      ++valid;
    }
    if (taken > 0) dds_return_loan(reader, samples, taken);
  }
  return valid;
}

}  // namespace peers::cyclone
