#pragma once
// Bounds the memory that peers make a process hold for messages that have not arrived whole.

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace suture::rpc {

/// The links of a server share it. It belongs to the control thread.
class ReceiveBudget {
 public:
  /// In bytes. All who have the same proof of who they are count as one peer: those of plain TCP
  /// share one budget.
  struct Limits {
    std::size_t peer = 64u << 20;
    std::size_t process = 256u << 20;
  };

  /// Counts what one link holds, and gives it back at its end.
  class Share {
   public:
    Share(std::shared_ptr<ReceiveBudget> budget, std::string peer)
        : budget_(std::move(budget)), peer_(std::move(peer)) {}
    ~Share() { hold(0); }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    /// The link holds `bytes` from now on; if that is too much, it returns which limit is broken.
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
