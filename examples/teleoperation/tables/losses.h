#pragma once
// This tells the losses of a run from its end.

#include <suture/observe/report.h>

#include <cstdint>

namespace demo {

/// Returns how often the connection was lost while the system ran; 0 without a contract. Processes
/// do not end at the same instant, and one whose provider has ended before it sees that as a loss.
/// A connection that is missing at the end for another reason fails its process.
inline std::uint64_t lossesOf(const suture::ConnectionReport& one) {
  if (!one.contract || one.contract->losses == 0) return 0;
  const bool hasGone = one.whyLost.starts_with("ended: ") || one.whyLost.starts_with("closed: ");
  const bool endedFirst = one.status == suture::ChannelStatus::Lost && hasGone;
  return one.contract->losses - (endedFirst ? 1 : 0);
}

}  // namespace demo
