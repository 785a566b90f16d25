#pragma once
// This is one small value that one thread writes now and then and any thread may read.

#include <suture/base/words.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace suture::rt {

/// One writer thread, any number of reader threads. Neither ever waits for the other, even if it
/// was preempted: a reader reads again only if the writer has finished a value meanwhile. Never
/// allocates or locks. Every word is an atomic, so that this is correct under the C++ memory model.
template <class T>
class Snapshot {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// The writer only.
  void write(const T& value) {
    std::array<std::uint64_t, kWords> copy{};
    std::memcpy(copy.data(), &value, sizeof(T));
    const std::uint64_t written = written_.load(std::memory_order_relaxed) + 1;
    auto& words = words_[written % 2];
    for (std::size_t i = 0; i < kWords; ++i) words[i].store(copy[i], std::memory_order_release);
    written_.store(written, std::memory_order_release);
  }

  /// Any thread. Returns the last value written; T{} before the first.
  T read() const {
    T value{};
    std::array<std::uint64_t, kWords> copy;
    std::uint64_t written;
    do {
      written = written_.load(std::memory_order_acquire);
      if (written == 0) return value;
      const auto& words = words_[written % 2];
      for (std::size_t i = 0; i < kWords; ++i) copy[i] = words[i].load(std::memory_order_acquire);
    } while (written_.load(std::memory_order_relaxed) != written);
    std::memcpy(static_cast<void*>(&value), copy.data(), sizeof(T));
    return value;
  }

 private:
  static constexpr std::size_t kWords = wordsFor(sizeof(T));

  std::atomic<std::uint64_t> written_{0};  // how many values
  // The last value is at its number modulo two; the writer writes the other.
  std::array<std::array<std::atomic<std::uint64_t>, kWords>, 2> words_{};
};

}  // namespace suture::rt
