#pragma once
// Two processes share this ring in memory: one writes, one reads, and each waits by a futex or
// spins.

#include <immintrin.h>

#include <atomic>
#include <cstdint>

#include "harness/futex.h"
#include "harness/plain_pose.h"

namespace peers {

enum class Waiting { Futex, Spinning };
enum class Kind : std::uint32_t { Echo, Push, Blob };

inline constexpr std::uint32_t kPlaces = 1024;
inline constexpr std::size_t kMostBlobBytes = (1u << 20) + 64;

struct Place {
  Kind kind;
  std::uint64_t blobBytes;
  PlainPose pose;
};

/// Tells how far one side has come, and if the other sleeps until it has come further.
class alignas(64) Mark {
 public:
  std::uint32_t get() const { return number_.load(std::memory_order_acquire); }

  void advance(Waiting waiting) {
    number_.store(number_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    if (waiting == Waiting::Spinning) return;
    std::atomic_thread_fence(std::memory_order_seq_cst);
    if (awaited_.load(std::memory_order_relaxed) != 0) futexWake(number_, 1);
  }

  void awaitChange(std::uint32_t seen, Waiting waiting) {
    while (get() == seen) {
      if (waiting == Waiting::Spinning) {
        _mm_pause();
        continue;
      }
      awaited_.store(1);
      if (number_.load() == seen) futexWait(number_, seen);
      awaited_.store(0, std::memory_order_relaxed);
    }
  }

 private:
  std::atomic<std::uint32_t> number_, awaited_;
};

/// It begins as bytes of 0.
class Ring {
 public:
  /// Returns where the next message is to be written; commit() sends it.
  Place& claim(Waiting waiting) {
    const std::uint32_t number = written_.get();
    for (std::uint32_t read = read_.get(); number - read == kPlaces; read = read_.get()) {
      read_.awaitChange(read, waiting);
    }
    return places_[number % kPlaces];
  }
  void commit(Waiting waiting) { written_.advance(waiting); }

  /// Waits for the oldest message, which is there until release().
  const Place& peek(Waiting waiting) {
    const std::uint32_t number = read_.get();
    written_.awaitChange(number, waiting);
    return places_[number % kPlaces];
  }
  void release(Waiting waiting) { read_.advance(waiting); }

  /// Returns the room of the one blob that may be under way.
  char* blob() { return blob_; }

 private:
  Mark written_, read_;
  Place places_[kPlaces];
  alignas(64) char blob_[kMostBlobBytes];
};

}  // namespace peers
