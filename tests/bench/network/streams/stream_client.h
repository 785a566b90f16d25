#pragma once
// This client sends poses as fast as there is room for them.

#include <suture/base/errors.h>
#include <suture/component/task/event_task.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <future>
#include <vector>

#include "bench/local/sample_server.h"
#include "bench/sample_loop.suture.h"

namespace bench {

/// Sends blocks of `block` poses, the next one when all of one have been executed; the first does
/// not count.
class StreamClient final : public suture::EventTask {
 public:
  StreamClient(int cpu, std::size_t block, std::size_t blocks)
      : EventTask({.scheduling = {.processor = cpu}}), block_(block), blocks_(blocks) {
    pose_.sequence = 0;
  }
  ~StreamClient() override { stop(); }

  void run() override {
    if (!server.connected()) return;
    if (left_ == 0 && !awaited_) begin();
    feed();
  }

  /// Returns, once, what will have the millions of poses a second of each block.
  std::future<std::vector<double>> rates() { return finished_.get_future(); }
  /// Any thread, once there are the rates: returns how many poses were sent.
  std::uint64_t sent() const { return pose_.sequence; }

  suture::Required<SampleServer> server{*this, "Server"};

 private:
  // The server is rung for every so many, and executes them while more come.
  static constexpr std::size_t kBurst = 256;

  void begin() {
    if (rates_.size() > blocks_) return;
    left_ = block_;
    began_ = suture::now();
  }

  // Where there is no room, run() is called when there is some.
  void feed() {
    while (left_ > 1) {
      std::size_t burst = std::min({std::size_t{server.put.room()}, left_ - 1, kBurst});
      if (burst == 0) return;
      left_ -= burst;
      for (; burst > 0; --burst) {
        ++pose_.sequence;
        server.put(pose_);
      }
      ringNow();
    }
    if (left_ == 1 && server.put.room() > 0) sendLast();
  }

  void sendLast() {
    left_ = 0;
    awaited_ = true;
    ++pose_.sequence;
    server.put.start(pose_).then([this](const suture::Result<void>& last) { ended(last); });
  }

  void ended(const suture::Result<void>& last) {
    awaited_ = false;
    if (!last) {
      return finished_.set_exception(std::make_exception_ptr(
          suture::SetupError("stream poses", suture::toString(last.error()), "Run it again")));
    }
    const auto elapsed = static_cast<double>((suture::now() - began_).count());
    rates_.push_back(1e3 * static_cast<double>(block_) / elapsed);
    if (rates_.size() <= blocks_) return begin();
    finished_.set_value({rates_.begin() + 1, rates_.end()});
  }

  const std::size_t block_, blocks_;
  robots::PoseSample pose_ = poseSample();
  std::size_t left_ = 0;
  bool awaited_ = false;
  suture::Time began_{};
  std::vector<double> rates_;
  std::promise<std::vector<double>> finished_;
};

}  // namespace bench
