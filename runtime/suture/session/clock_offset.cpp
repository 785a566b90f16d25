#include <suture/codec/stamps.h>
#include <suture/component/channel/peer_state.h>
#include <suture/session/clock_offset.h>

#include <algorithm>

namespace suture {

Duration ClockOffset::error(Time present) const {
  if (one_ || error_ == Duration::max()) return error_;
  return error_ + clockDrift(present - compared_);
}

// Returns true if a clock was stepped, or slewed faster than quartz drifts.
bool ClockOffset::contradicts(Duration offset, Duration errors) const {
  return std::max(offset - offset_, offset_ - offset) > errors;
}

bool ClockOffset::add(Time asked, std::int64_t received, std::int64_t sent, Time answered) {
  const Duration there(codec::bounded(received) / 2 + codec::bounded(sent) / 2);
  const Duration here = asked.time_since_epoch() / 2 + answered.time_since_epoch() / 2;
  const Duration whole = answered - asked,
                 answering(codec::bounded(sent) - codec::bounded(received));
  // Do not believe a peer that says that answering took longer than everything, or less than no
  // time.
  const bool possible = answering >= Duration{0} && answering <= whole;
  const Duration underWay = possible ? whole - answering : whole;
  const Duration offset = there - here, known = error(answered), found = underWay / 2;
  if (found >= known && !contradicts(offset, known + found)) return false;
  offset_ = offset;
  error_ = found;
  compared_ = answered;
  return true;
}

}  // namespace suture
