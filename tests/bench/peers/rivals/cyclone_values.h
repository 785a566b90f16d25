#pragma once
// These turn the pose and the blob into the types that Cyclone DDS's IDL compiler wrote for them,
// and back.

#include "harness/pose.h"
#include "rivals/cyclone_node.h"

namespace peers::cyclone {

/// The result points into the value, which must outlive it. That is enough for a writer, because it
/// serializes at once.
peersdds_Pose viewOf(const Pose& pose);
peersdds_Blob viewOf(const Blob& blob);

void load(const peersdds_Pose& wire, Pose& pose);
void load(const peersdds_Blob& wire, Blob& blob);

}  // namespace peers::cyclone
