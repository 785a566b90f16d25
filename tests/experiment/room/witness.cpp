#include "experiment/room/witness.h"

#include "strand/strand.h"

namespace experiment {
namespace {

constexpr std::size_t kPlaces = 60'000;  // a minute, so that no cycle allocates
constexpr std::size_t kChanges = 1000;

}  // namespace

Witness::Witness() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {
  strand_.makeOptional();
  guidance_.makeOptional();
  record_.guidance.reserve(kChanges);
  for (Course* const course : {&record_.left, &record_.right, &record_.leftSetpoint,
                               &record_.rightSetpoint, &record_.knot}) {
    course->places.reserve(kPlaces);
  }
}

void Witness::run() {
  see(left_, record_.left, record_.leftSetpoint);
  see(right_, record_.right, record_.rightSetpoint);
  const auto strand = strand_.strand();
  if (strand && strand->valid) {
    record_.knot.add(strand->stamp, strand->nodes.col(robots::Strand::kKnot));
  }
  seeGuidance();
}

void Witness::see(suture::Required<robots::Arm>& arm, Course& measured, Course& setpoint) {
  const auto here = arm.measured_cp(), there = arm.setpoint_cp();
  if (here && here->valid) measured.add(here->stamp, here->pose.translation());
  if (there && there->valid) setpoint.add(there->stamp, there->pose.translation());
}

void Witness::seeGuidance() {
  const auto state = guidance_.guidance_state();
  const bool guides = state && *state == robots::GuidanceState::Guiding;
  const bool guided = record_.guidance.size() % 2 == 1;
  if (guides == guided) return;
  const std::int64_t now = suture::toNanoseconds(suture::now());
  record_.guidance.push_back(now);
  if (guides && guidedSince_ == 0) guidedSince_ = now;
}

}  // namespace experiment
