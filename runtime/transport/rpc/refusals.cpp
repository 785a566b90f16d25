#include <suture/transport/rpc/refusals.h>

#include <cstdio>

namespace suture::rpc {
namespace {

constexpr Duration kPause = std::chrono::minutes(1);
constexpr std::size_t kMostLines = 20;

}  // namespace

void Refusals::add(const std::string& peer, const std::string& text) {
  const std::string line = peer + ": " + text;
  {
    const std::lock_guard lock(mutex_);
    ++summary_.count;
    summary_.latest = line;
  }
  if (isToBeTold(line)) std::fprintf(stderr, "%s: refused %s\n", owner_.c_str(), line.c_str());
}

bool Refusals::isToBeTold(const std::string& line) {
  const Time present = now();
  std::erase_if(told_, [present](const auto& one) { return present - one.second >= kPause; });
  return told_.size() < kMostLines && told_.try_emplace(line, present).second;
}

Refusals::Summary Refusals::summary() const {
  const std::lock_guard lock(mutex_);
  return summary_;
}

}  // namespace suture::rpc
