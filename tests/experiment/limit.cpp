#include "integration/operator/limit.h"

#include <suture/testing/test_clock.h>

#include <Eigen/Core>
#include <chrono>

#include "experiment/experiment.h"
#include "experiment/room/operating_room.h"
#include "integration/operator/lag_probe.h"
#include "integration/teleoperation/scene/knot_scene.h"
#include "surgeon/operator.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;
using robots::OperatorParameters;

constexpr suture::Duration kResolution = 2500us;
// The camera is exact, so that only the delay decides.
constexpr CameraModel kExact{.dropout = 0, .disparity = 0};

Trial over(suture::Duration roundTrip) {
  return {.link = {.roundTrip = roundTrip}, .fixtures = false};
}

bool begins(suture::TestClock& clock, const OperatingRoom& room) {
  return clock.until([&] { return room.guiding(); }, 30s);
}

/// Says where the knot is before any hand moves it.
struct AtRest {
  Eigen::Vector3d knot = Eigen::Vector3d::Zero();  // m, in the scene
  double loop = 0;                                 // s: how late the picture is without a link
};

Eigen::Vector3d directionOf(Axis axis) {
  return axis == Axis::AlongStrand ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
}

AtRest measureAtRest(const Eigen::Vector3d& direction) {
  suture::TestClock clock;
  robots::test::LagProbe probe(kScale, direction,
                               robots::test::knotScene().camera.linear().transpose() * direction);
  OperatingRoom room(over(0ms), kExact);
  room.seat(probe);
  room.start();
  if (!begins(clock, room)) return {};
  clock.advance(5s);  // the strand comes to rest
  AtRest rest{.knot = room.knot()};
  probe.begin();
  clock.advance(robots::test::LagProbe::kTakes);
  room.stop();
  rest.loop = probe.lag();
  return rest;
}

/// Tells if the knot comes to rest 2 mm from `knot`: so near that no bound of speed, and no tissue,
/// is reached.
bool isStable(const Eigen::Vector3d& knot, const Eigen::Vector3d& direction,
              suture::Duration roundTrip) {
  suture::TestClock clock;
  const Eigen::Vector3d target = knot + 0.002 * direction;
  robots::Operator surgeon({.target = target, .scale = kScale, .remnant = 0, .tremor = 0});
  OperatingRoom room(over(roundTrip), kExact);
  room.seat(surgeon);
  room.connectOperator();
  room.start();
  return begins(clock, room) &&
         robots::test::diesOut([&] { return direction.dot(room.knot() - target); });
}

}  // namespace

Limit findLimit(Axis axis) {
  const Eigen::Vector3d direction = directionOf(axis);
  const AtRest rest = measureAtRest(direction);
  const auto stable = robots::test::longestStable(
      [&](suture::Duration roundTrip) { return isStable(rest.knot, direction, roundTrip); }, 50ms,
      370ms, kResolution);
  return {.loop = rest.loop,
          .byFormula = robots::test::limitByFormula(OperatorParameters{}, rest.loop),
          .measured = robots::inSeconds(stable)};
}

}  // namespace experiment
