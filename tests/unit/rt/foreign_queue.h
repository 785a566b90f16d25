#pragma once
// This is a queue between two processes, whose other end may write anything at any time.

#include <gtest/gtest.h>
#include <suture/base/arena.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <random>
#include <span>

namespace suture::rt::foreign_memory {

inline constexpr std::size_t kBytes = 1u << 16;

/// Holds one block, and what each of two processes makes of it.
template <class Queue>
class Shared {
 public:
  template <class... Arguments>
  explicit Shared(const Arguments&... arguments) {
    Arena here(block, Arena::Content::Zeros), there(block, Arena::Content::Made);
    producer = std::make_unique<Queue>(arguments..., here);
    consumer = std::make_unique<Queue>(arguments..., there);
    used = here.used();
  }

  std::span<std::byte> bytes() { return {block->data(), used}; }

  std::shared_ptr<MemoryBlock> block = std::make_shared<MemoryBlock>("test", kBytes);
  std::unique_ptr<Queue> producer, consumer;
  std::size_t used = 0;
};

// Whatever lies there: each read stays within the copy and every loop ends.
template <class Queue, class Use, class... Arguments>
void survivesAnything(const Use& use, const Arguments&... arguments) {
  std::mt19937_64 random(20260722);
  for (int round = 0; round < 2000; ++round) {
    Shared<Queue> queue(arguments...);
    use(queue, [&] {
      const auto bytes = queue.bytes();
      const int writes = 1 + static_cast<int>(random() % 8);
      for (int i = 0; i < writes; ++i) {
        const std::uint64_t values[] = {0,          1,          0xff,     ~std::uint64_t{0},
                                        1ull << 63, 0xdeadbeef, random(), random() % 512};
        const std::uint64_t value = values[random() % std::size(values)];
        const std::size_t at = random() % (bytes.size() / 8) * 8;
        std::memcpy(bytes.data() + (random() % 3 == 0 ? at % 256 : at), &value, 8);
      }
    });
  }
}

}  // namespace suture::rt::foreign_memory
