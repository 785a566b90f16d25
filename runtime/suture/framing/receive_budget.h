#pragma once
// This bounds the memory that peers make a process hold for messages that have not arrived whole.

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace suture::rpc {

/// Belongs to the control thread. The links of a server share one.
class ReceiveBudget {
 public:
  /// These limits are in bytes. All links with the same proof of who the peer is count as one peer,
  /// so all peers by plain TCP share one budget.
  struct Limits {
    std::size_t peer = 64u << 20;
    std::size_t process = 256u << 20;
  };

  /// Counts what one link holds, and subtracts it again when the link ends.
  class Share {
   public:
    Share(std::shared_ptr<ReceiveBudget> budget, std::string peer)
        : budget_(std::move(budget)), peer_(std::move(peer)) {}
    ~Share() { hold(0); }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    /// Says that the link holds `bytes` from now on. If that is too much, nothing changes, and the
    /// text that is returned says which limit is broken.
    std::optional<std::string> hold(std::size_t bytes);

   private:
    const std::shared_ptr<ReceiveBudget> budget_;
    const std::string peer_;
    std::size_t held_ = 0;
  };

  explicit ReceiveBudget(const Limits& limits) : limits_(limits) {}

 private:
  const Limits limits_;
  std::map<std::string, std::size_t> peers_;
  std::size_t held_ = 0;
};

}  // namespace suture::rpc
