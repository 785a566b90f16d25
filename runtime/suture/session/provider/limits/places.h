#pragma once
// This bounds how many there may be of what peers ask for.

#include <atomic>
#include <cstddef>
#include <memory>

namespace suture {

/// One thread asks and takes; any thread may give a place back.
class Places {
 public:
  /// A Place is free again when the last copy of it goes.
  using Place = std::shared_ptr<void>;

  explicit Places(std::size_t most) : most_(most) {}

  std::size_t most() const { return most_; }
  bool allFree() const { return *taken_ == 0; }
  bool anyFree() const { return *taken_ < most_; }
  /// Call it only when there is a free one.
  Place take() {
    ++*taken_;
    return {taken_.get(), [taken = taken_](void*) { --*taken; }};
  }

 private:
  const std::size_t most_;
  const std::shared_ptr<std::atomic<std::size_t>> taken_ =
      std::make_shared<std::atomic<std::size_t>>(0);
};

}  // namespace suture
