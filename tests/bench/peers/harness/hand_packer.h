#pragma once
// Peers that have no serializer use this packer, written by hand, field by field. It is the floor
// of those that have one.

#include <cstddef>

#include "harness/pose.h"

namespace peers {

inline constexpr std::size_t kMostPackedBytes = 256;

/// Returns how many bytes of `room` are taken; there are kMostPackedBytes.
std::size_t pack(const Pose& pose, unsigned char* room);
/// Returns false if these bytes are no pose.
bool unpack(const unsigned char* bytes, std::size_t size, Pose& pose);

}  // namespace peers
