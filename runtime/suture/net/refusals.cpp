#include <suture/base/plain.h>
#include <suture/net/refusals.h>
#include <suture/rt/standard_error.h>

namespace suture::net {
namespace {

constexpr Duration kPause = std::chrono::minutes(1);
constexpr std::size_t kMostLines = 20;
constexpr std::size_t kLongest = 4096;

// Returns `text` as it may be printed: the name that a peer gives itself must not control a
// terminal, look like a line of another process, or fill a log.
std::string printable(const std::string& text) {
  std::string shown;
  for (const char one : plain(text.substr(0, kLongest))) {
    shown += one;
    if (one == '\n') shown += "  ";
  }
  return text.size() > kLongest ? shown + "..." : shown;
}

}  // namespace

void Refusals::add(const std::string& peer, const std::string& text) {
  const std::string line = printable(peer + ": " + text);
  {
    const std::lock_guard lock(mutex_);
    ++summary_.count;
    summary_.latest = line;
  }
  if (!mayPrint(line)) return;
  if (!rt::printUnlessFull(owner_ + ": refused " + line)) printed_.erase(line);
}

bool Refusals::mayPrint(const std::string& line) {
  const Time present = now();
  std::erase_if(printed_, [present](const auto& one) { return present - one.second >= kPause; });
  return printed_.size() < kMostLines && printed_.try_emplace(line, present).second;
}

Refusals::Summary Refusals::summary() const {
  const std::lock_guard lock(mutex_);
  return summary_;
}

}  // namespace suture::net
