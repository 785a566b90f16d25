#pragma once
// These convert between the two records of the figures and Cap'n Proto, as one writes it by hand.

#include "robot_types/pose.capnp.h"
#include "robot_types/pose.h"

namespace handwritten {

namespace wire = robots::wire;

void write(const robots::PoseSample& value, wire::PoseSample::Builder out);
void write(const robots::PosePrm& value, wire::PosePrm::Builder out);
void read(wire::PoseSample::Reader in, robots::PoseSample& value);
void read(wire::PosePrm::Reader in, robots::PosePrm& value);

}  // namespace handwritten
