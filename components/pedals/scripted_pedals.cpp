#include "pedals/scripted_pedals.h"

#include "parameters/valid_time.h"

namespace robots {
namespace {

/// Returns true if what happens `after` a start and lasts for `length` happens at `since` after the
/// start.
bool isNow(suture::Duration since, suture::Duration after, suture::Duration length) {
  return after > suture::Duration{0} && since >= after && since < after + length;
}

}  // namespace

ScriptedPedals::ScriptedPedals(const ScriptedPedalsParameters& parameters)
    : PeriodicTask({.period = parameters.period}), parameters_(parameters) {
  requireTimeOrZero("clutch_after", parameters.clutch_after);
  requireTime("clutch_for", parameters.clutch_for);
  requireTimeOrZero("leave_after", parameters.leave_after);
  requireTime("leave_for", parameters.leave_for);
}

void ScriptedPedals::onStart() {
  start_ = suture::now();
  pedalPort_.emit().clutch(pedals_.clutch);
  pedalPort_.emit().camera(pedals_.camera);
  pedalPort_.emit().coagulation(pedals_.coagulation);
  presencePort_.emit().operator_present(presence_.present);
}

void ScriptedPedals::run() {
  const suture::Time now = suture::now();
  const bool pressed = isNow(now - start_, parameters_.clutch_after, parameters_.clutch_for);
  const bool there = !isNow(now - start_, parameters_.leave_after, parameters_.leave_for);
  if (pressed != pedals_.clutch) pedalPort_.emit().clutch(pressed);
  if (there != presence_.present) presencePort_.emit().operator_present(there);
  pedals_.clutch = pressed;
  presence_.present = there;
  pedals_.stamp = presence_.stamp = now;
}

}  // namespace robots
