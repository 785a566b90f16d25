#pragma once
// This is Table 2 of the paper, "A Surgical Assistant Workstation (SAW) Application for a
// Teleoperated Surgical Robot System", section 4. It is in milliseconds; two machines in one
// network, Pentium 4 of 3.2 GHz, Linux 2.6.24.

#include <cstddef>

namespace bench::paper {

struct Row {
  double mean, std, min, max;
};

/// This is one operating system.
struct System {
  const char* name;
  Row scsLocal, scsNetwork;
  double scsDifference;
  Row cscLocal, cscNetwork;
  double cscDifference;
  double codec;  ///< serialization + dynamic creation + deserialization
};

constexpr System kLinux{
    .name = "Linux",
    .scsLocal = {4.00446, 0.178861, 4.00045, 16.0018},
    .scsNetwork = {4.92736, 1.72445, 4.00045, 36.0041},
    .scsDifference = 0.9229,
    .cscLocal = {4.25248, 0.993137, 4.00045, 20.0023},
    .cscNetwork = {4.88347, 1.82513, 3.04369, 32.8634},
    .cscDifference = 0.63099,
    .codec = 0.0043557,
};

constexpr System kLinuxRtai{
    .name = "Linux (RTAI)",
    .scsLocal = {0.992913, 1.72807, 0, 4.00046},
    .scsNetwork = {1.19414, 1.83933, 0, 20.0023},
    .scsDifference = 0.201227,
    .cscLocal = {0.996914, 1.7304, 0, 4.00046},
    .cscNetwork = {1.22542, 0.523384, 0.303618, 19.1435},
    .cscDifference = 0.228506,
    .codec = 0.004239,
};

}  // namespace bench::paper
