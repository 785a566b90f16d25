#pragma once
// This client sends a block of bytes and gets it back, again and again.

#include <suture/component/task/event_task.h>

#include <cstdint>
#include <exception>
#include <future>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/network/sizes/block_loan.h"

namespace bench {

/// Says which blocks go round.
struct Blocks {
  std::size_t bytes;
  bool onLoan = false;  ///< both ends fill them where they leave from
};

/// Sends a block and, when it is back, the next one, from its first cycle on. `Contract` is
/// SmallBlocks or LargeBlocks.
template <class Contract>
class BlockClient final : public suture::EventTask {
 public:
  using Samples = std::vector<std::int64_t>;

  BlockClient(int cpu, Blocks blocks, std::size_t skipped, std::size_t samples)
      : EventTask({.scheduling = {.processor = cpu}}),
        onLoan_(blocks.onLoan),
        skipped_(skipped),
        rounds_(skipped + samples) {
    block_.bytes.assign(blocks.bytes, 0xa5);
    elapsed_.reserve(rounds_);
    server.on().echo([this](const typename Contract::Block&) { arrived(); });
  }
  ~BlockClient() override { stop(); }

  void run() override {
    if (begun_ || !server.connected()) return;
    begun_ = true;
    send();
  }
  /// Call it once: returns the future of how many ns each round took, without the first `skipped`.
  std::future<Samples> samples() { return finished_.get_future(); }

  suture::Required<Contract> server{*this, "Server"};

 private:
  void send() {
    sent_ = suture::now();
    if (const auto sent = bounce(); !sent) {
      finished_.set_exception(std::make_exception_ptr(std::runtime_error(
          std::string("a block was not sent: ") + suture::toString(sent.error()))));
    }
  }
  suture::Result<> bounce() {
    if (!onLoan_) return server.bounce(block_);
    return server.bounce.template loan<kBytes<Contract>>({}, copyOf(block_.bytes));
  }
  void arrived() {
    elapsed_.push_back((suture::now() - sent_).count());
    if (elapsed_.size() < rounds_) return send();
    finished_.set_value(
        Samples(elapsed_.begin() + static_cast<std::ptrdiff_t>(skipped_), elapsed_.end()));
  }

  typename Contract::Block block_;
  suture::Time sent_{};
  bool begun_ = false;
  const bool onLoan_;
  const std::size_t skipped_, rounds_;
  Samples elapsed_;
  std::promise<Samples> finished_;
};

}  // namespace bench
