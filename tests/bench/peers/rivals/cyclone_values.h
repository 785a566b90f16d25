#pragma once
// The pose and the blob become what the IDL compiler of Cyclone DDS made of them, and back.

#include "harness/pose.h"
#include "rivals/cyclone_node.h"

namespace peers::cyclone {

/// Strings and numbers are lent, for the writer serializes at once.
peersdds_Pose viewOf(const Pose& pose);
peersdds_Blob viewOf(const Blob& blob);

void load(const peersdds_Pose& wire, Pose& pose);
void load(const peersdds_Blob& wire, Blob& blob);

}  // namespace peers::cyclone
