#include <suture/manager/clock_offset.h>
#include <suture/transport/rpc/stamps.h>

#include <algorithm>

namespace suture {

void ClockOffset::add(Time asked, std::int64_t received, std::int64_t sent, Time answered) {
  const Duration there(rpc::bounded(received) / 2 + rpc::bounded(sent) / 2);
  const Duration here = asked.time_since_epoch() / 2 + answered.time_since_epoch() / 2;
  // What a peer says of itself makes it no better.
  const Duration answering(std::max<std::int64_t>(rpc::bounded(sent) - rpc::bounded(received), 0));
  const Duration underWay = std::max(answered - asked - answering, Duration{0});
  if (underWay / 2 >= error_) return;
  offset_ = there - here;
  error_ = underWay / 2;
}

}  // namespace suture
