#pragma once
// This takes numbers out of the bytes that a fuzzer is given.

#include <cstddef>
#include <cstdint>

namespace suture::fuzz {

/// Gives the input byte by byte, and zeros behind its end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool ended() const { return at_ >= size_; }
  std::size_t byte() { return ended() ? 0 : data_[at_++]; }
  std::size_t two() {
    const std::size_t high = byte();
    return high * 256 + byte();
  }
  std::uint64_t eight() {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) value = value << 8 | byte();
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

}  // namespace suture::fuzz
