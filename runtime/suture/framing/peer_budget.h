#pragma once
// This bounds the memory that peers make a process hold.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace suture::framing {

/// Any thread but a task's, because it locks. Bounds one kind of memory; whoever holds some says
/// how much by a share.
class PeerBudget {
 public:
  /// Limits are in bytes. All links with the same proof of who the peer is count as one peer, so
  /// all peers by plain TCP share one budget.
  struct Limits {
    std::size_t peer;
    std::size_t process;
  };

  /// Says which limit would be broken.
  struct Beyond {
    std::string whose;  ///< the peer, or "all peers"
    std::size_t limit, left;
  };

  /// One thread. Counts what one user of the memory holds, and subtracts it again when it goes.
  class Share {
   public:
    Share(std::shared_ptr<PeerBudget> budget, std::string peer)
        : budget_(std::move(budget)), peer_(std::move(peer)) {}
    ~Share() { hold(0); }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    /// Says that this holds `bytes` from now on. If that is too much, nothing changes, and the
    /// limit is returned.
    std::optional<Beyond> hold(std::size_t bytes);

   private:
    const std::shared_ptr<PeerBudget> budget_;
    const std::string peer_;
    std::size_t held_ = 0;
  };

  explicit PeerBudget(const Limits& limits) : limits_(limits) {}

 private:
  const Limits limits_;
  std::mutex mutex_;  // held for a few instructions
  std::map<std::string, std::size_t> peers_;
  std::size_t held_ = 0;
};

/// Returns why the messages of a peer that have begun may not take more, in words.
std::string unfinishedBeyond(const PeerBudget::Beyond& beyond);

}  // namespace suture::framing
