#include "03_own_data_type/display.h"

#include <chrono>
#include <cstdio>

namespace tracking {
namespace {

const char* toString(Visibility visibility) {
  switch (visibility) {
    case Visibility::Hidden: return "hidden";
    case Visibility::Partial: return "partly visible";
    case Visibility::Full: return "fully visible";
  }
  return "?";
}

void print(const Observation& seen) {
  const Eigen::Vector3d tip = seen.tip.translation();
  const double turn = Eigen::AngleAxisd(seen.tip.rotation()).angle();
  std::printf("%s, %s\n", seen.instrument.c_str(), toString(seen.visibility));
  std::printf("  tip at %.3f %.3f %.3f m, turned by %.2f rad\n", tip.x(), tip.y(), tip.z(), turn);
  std::printf("  jaws open by %.2f rad\n", seen.jaw_angle);
  for (const Marker& marker : seen.markers) {
    const Eigen::Vector3d& at = marker.position;
    std::printf("  marker %u at %.3f %.3f %.3f m\n", marker.number, at.x(), at.y(), at.z());
  }
}

}  // namespace

Display::Display() : PeriodicTask({.period = std::chrono::milliseconds(500)}) {}

void Display::run() {
  if (const auto seen = tracker_.observation()) print(*seen);
  std::fflush(stdout);
}

}  // namespace tracking
