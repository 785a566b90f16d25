#include "rivals/cyclone_values.h"

#include <algorithm>
#include <iterator>

namespace peers::cyclone {

peersdds_Pose viewOf(const Pose& pose) {
  peersdds_Pose view;
  std::copy(pose.rotation.begin(), pose.rotation.end(), view.rotation);
  std::copy(pose.position.begin(), pose.position.end(), view.position);
  view.timestamp = pose.timestamp;
  view.valid = pose.valid;
  view.frame = const_cast<char*>(pose.frame.c_str());
  view.reference = const_cast<char*>(pose.reference.c_str());
  return view;
}

peersdds_Blob viewOf(const Blob& blob) {
  peersdds_Blob view{};
  view.timestamp = blob.timestamp;
  view.data._buffer = const_cast<double*>(blob.data.data());
  view.data._length = view.data._maximum = static_cast<std::uint32_t>(blob.data.size());
  return view;
}

void load(const peersdds_Pose& wire, Pose& pose) {
  std::copy(std::begin(wire.rotation), std::end(wire.rotation), pose.rotation.begin());
  std::copy(std::begin(wire.position), std::end(wire.position), pose.position.begin());
  pose.timestamp = wire.timestamp;
  pose.valid = wire.valid;
  pose.frame = wire.frame;
  pose.reference = wire.reference;
}

void load(const peersdds_Blob& wire, Blob& blob) {
  blob.timestamp = wire.timestamp;
  blob.data.assign(wire.data._buffer, wire.data._buffer + wire.data._length);
}

}  // namespace peers::cyclone
