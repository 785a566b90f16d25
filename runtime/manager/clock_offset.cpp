#include <suture/manager/clock_offset.h>
#include <suture/transport/rpc/stamps.h>

namespace suture {

namespace {

// A quartz is off by some 50 us in a second, in a machine that is warm or cold by twice that.
constexpr int kMicrosecondsOfDrift = 100;

}  // namespace

Duration ClockOffset::error(Time present) const {
  if (one_ || error_ == Duration::max()) return error_;
  return error_ + (present - compared_) * kMicrosecondsOfDrift / 1'000'000;
}

bool ClockOffset::add(Time asked, std::int64_t received, std::int64_t sent, Time answered) {
  const Duration there(rpc::bounded(received) / 2 + rpc::bounded(sent) / 2);
  const Duration here = asked.time_since_epoch() / 2 + answered.time_since_epoch() / 2;
  const Duration whole = answered - asked, answering(rpc::bounded(sent) - rpc::bounded(received));
  // Who says that answering took longer than everything, or less than no time, is not believed.
  const bool possible = answering >= Duration{0} && answering <= whole;
  const Duration underWay = possible ? whole - answering : whole;
  if (underWay / 2 >= error(answered)) return false;
  offset_ = there - here;
  error_ = underWay / 2;
  compared_ = answered;
  return true;
}

}  // namespace suture
