#pragma once
// This is one small value that one thread writes now and then and any thread may read.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace suture::rt {

/// One writer thread, any number of reader threads. Neither ever waits for the other: a reader that
/// was overtaken by the writer reads again. Never allocates or locks. Every word is an atomic, so
/// that this is correct under the C++ memory model.
template <class T>
class Snapshot {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// The writer only.
  void write(const T& value) {
    std::array<std::uint64_t, kWords> copy{};
    std::memcpy(copy.data(), &value, sizeof(T));
    const std::uint64_t version = version_.load(std::memory_order_relaxed);
    version_.store(version + 1, std::memory_order_relaxed);  // odd: being written
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(copy[i], std::memory_order_release);
    version_.store(version + 2, std::memory_order_release);
  }

  /// Any thread. Returns the last value written; T{} before the first.
  T read() const {
    T value{};
    std::array<std::uint64_t, kWords> copy;
    std::uint64_t version;
    do {
      version = version_.load(std::memory_order_acquire);
      if (version == 0) return value;
      for (std::size_t i = 0; i < kWords; ++i) copy[i] = words_[i].load(std::memory_order_acquire);
    } while (version % 2 != 0 || version_.load(std::memory_order_relaxed) != version);
    std::memcpy(static_cast<void*>(&value), copy.data(), sizeof(T));
    return value;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;

  std::atomic<std::uint64_t> version_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace suture::rt
