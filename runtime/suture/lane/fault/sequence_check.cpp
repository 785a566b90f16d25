#include <suture/lane/fault/sequence_check.h>

namespace suture {
namespace {

constexpr std::uint64_t kRemembered = 64;

}  // namespace

// Takes a message that is kRemembered or more behind to have come, since nothing is known of it: if
// it has not, it was counted as lost when later ones overtook it.
bool SequenceCheck::hasCome(std::uint64_t sequence) const {
  const std::uint64_t ago = reached_ - sequence;
  return ago >= kRemembered || (recent_ >> ago & 1) != 0;
}

void SequenceCheck::advanceTo(std::uint64_t sequence, bool came) {
  const std::uint64_t step = sequence - reached_;
  counters_.lost.fetch_add(came ? step - 1 : step, std::memory_order_relaxed);
  recent_ = step >= kRemembered ? 0 : recent_ << step;
  if (came) recent_ |= 1;
  reached_ = sequence;
}

bool SequenceCheck::accepts(std::uint64_t sequence) {
  if (sequence > reached_) {
    advanceTo(sequence, true);
    return true;
  }
  if (hasCome(sequence)) {
    counters_.duplicated.fetch_add(1, std::memory_order_relaxed);
  } else {
    recent_ |= std::uint64_t{1} << (reached_ - sequence);  // its duplicate will count as one
    counters_.overtaken.fetch_add(1, std::memory_order_relaxed);
  }
  return false;
}

void SequenceCheck::passOver(std::uint64_t sequence) {
  if (sequence > reached_) advanceTo(sequence, false);
}

}  // namespace suture
