#pragma once
// A sink that counts, and is as slow as a test wants it.

#include <suture/record/sink.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "support/pass.h"

namespace suture {

class CountingSink final : public Sink {
 public:
  explicit CountingSink(Duration delay = Duration{0}) : delay_(delay) {}

  void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
           std::span<const CollectedValue> values) override {
    const std::lock_guard lock(mutex_);
    collector = from.collector;
    numbers.push_back(number);
    stamps.push_back(stamp);
    for (const CollectedValue& value : values) absent += value.slot == nullptr ? 1 : 0;
    pass(delay_);
  }
  void event(const CollectedInterface&, std::uint16_t event, Time stamp,
             const std::byte*) override {
    const std::lock_guard lock(mutex_);
    numbers.push_back(event);
    stamps.push_back(stamp);
    pass(delay_);
  }
  void missed(const CollectedInterface&, std::uint64_t count) override {
    const std::lock_guard lock(mutex_);
    lost += count;
  }

  // Stable once the collector has stopped.
  std::string collector;
  std::vector<std::uint64_t> numbers;
  std::vector<Time> stamps;
  std::uint64_t lost = 0;
  std::size_t absent = 0;

 private:
  const Duration delay_;
  std::mutex mutex_;
};

}  // namespace suture
