#pragma once
// This passes a value, of which only the newest counts, from one producer to one consumer.

#include <suture/base/arena.h>
#include <suture/rt/queue/record_copy.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rt {

/// One producer thread, one consumer thread. A LatestCell has three buffers: the producer owns one,
/// the consumer owns one, and the third holds the newest published value. Wait-free on both sides;
/// the consumer's buffer does not change until its next take().
///
/// In foreign memory each process has an object of its own; front() then is a copy, and any part of
/// it may be wrong.
class LatestCell {
 public:
  LatestCell(std::size_t size, Arena& arena);
  explicit LatestCell(std::size_t size, Arena&& arena = {}) : LatestCell(size, arena) {}

  /// The producer. Returns the buffer to fill. It still holds what it was filled with before; at
  /// first, zeros.
  std::byte* claim() { return bufferAt(writing_); }
  /// The producer. Makes the filled buffer the newest. Returns true if it replaced a value that was
  /// not taken yet.
  bool commit();

  /// The consumer. Returns true if something newer than the last take() has been published; it is
  /// front() from then on. In foreign memory, `copy(to, from, size)` copies the wanted part of it.
  template <class Copy>
  bool take(const Copy& copy);
  bool take() { return take(copyAll); }
  /// Either thread. Returns true if take() would succeed; the caller then sees what the producer
  /// did before.
  bool fresh() const { return (shared_->load(std::memory_order_acquire) & kFresh) != 0; }
  /// The consumer. Returns what the last successful take() got.
  const std::byte* front() const { return copy_.empty() ? bufferAt(reading_) : copy_.data(); }

  /// Once both sides have ended. Calls `visit` with each buffer, whatever lies in it.
  template <class Visit>
  void forEachBuffer(const Visit& visit) const {
    for (std::uint32_t i = 0; i < kBuffers; ++i) visit(bufferAt(i));
  }

 private:
  static constexpr std::uint32_t kFresh = 4;  // marks the shared index: published and not yet taken
  static constexpr std::uint32_t kBuffers = 3;

  // Returns the index of one of the three buffers, whatever the other side has written.
  static std::uint32_t indexIn(std::uint32_t word) { return std::min(word & 3, kBuffers - 1); }

  bool takeNewest();
  std::byte* bufferAt(std::uint32_t index) const { return data_.get() + index * stride_; }

  std::size_t stride_;
  std::shared_ptr<std::byte> data_;
  std::shared_ptr<std::atomic<std::uint32_t>> shared_;
  alignas(64) std::uint32_t writing_ = 0;
  alignas(64) std::uint32_t reading_ = 2;
  std::vector<std::byte> copy_;  // a consumer in foreign memory reads this one
};

template <class Copy>
bool LatestCell::take(const Copy& copy) {
  if (!takeNewest()) return false;
  if (!copy_.empty()) copy(copy_.data(), bufferAt(reading_), stride_);
  return true;
}

}  // namespace suture::rt
