#pragma once
// One value of which only the newest counts, between one producer and one consumer.

#include <suture/base/arena.h>
#include <suture/rt/queue/record_copy.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace suture::rt {

/// Three buffers: the producer owns one, the consumer one, the third holds the newest published
/// value. Wait-free on both sides; the consumer's buffer is stable until its next take().
///
/// In foreign memory each process has an object of its own; front() then is a copy, of which any
/// part may be wrong.
class LatestCell {
 public:
  LatestCell(std::size_t size, Arena& arena);
  explicit LatestCell(std::size_t size, Arena&& arena = {}) : LatestCell(size, arena) {}

  /// Producer: the buffer to fill. It still has what it was filled with before; at first, zeros.
  std::byte* claim() { return bufferAt(writing_); }
  /// Producer: makes the filled buffer the newest. Returns true if it replaced a value not yet
  /// taken.
  bool commit();

  /// Consumer: true if something newer than the last take() has been published; it is now front().
  /// In foreign memory, `copy(to, from, size)` copies what is wanted of it.
  template <class Copy>
  bool take(const Copy& copy);
  bool take() { return take(copyAll); }
  /// Either: true if take() would succeed. Then what the producer did before is seen.
  bool fresh() const { return (shared_->load(std::memory_order_acquire) & kFresh) != 0; }
  /// Consumer: what the last successful take() got.
  const std::byte* front() const { return copy_.empty() ? bufferAt(reading_) : copy_.data(); }

  /// When both sides have ended: each buffer, whatever lies in it.
  template <class Visit>
  void forEachBuffer(const Visit& visit) const {
    for (std::uint32_t i = 0; i < kBuffers; ++i) visit(bufferAt(i));
  }

 private:
  static constexpr std::uint32_t kFresh = 4;  // marks the shared index: published and not yet taken
  static constexpr std::uint32_t kBuffers = 3;

  // Names one of the three, whatever the other side has written.
  static std::uint32_t indexIn(std::uint32_t word) { return std::min(word & 3, kBuffers - 1); }

  bool takeNewest();
  std::byte* bufferAt(std::uint32_t index) const { return data_.get() + index * stride_; }

  std::size_t stride_;
  std::shared_ptr<std::byte> data_;
  std::shared_ptr<std::atomic<std::uint32_t>> shared_;
  alignas(64) std::uint32_t writing_ = 0;
  alignas(64) std::uint32_t reading_ = 2;
  std::vector<std::byte> copy_;  // of a consumer in foreign memory
};

template <class Copy>
bool LatestCell::take(const Copy& copy) {
  if (!takeNewest()) return false;
  if (!copy_.empty()) copy(copy_.data(), bufferAt(reading_), stride_);
  return true;
}

}  // namespace suture::rt
