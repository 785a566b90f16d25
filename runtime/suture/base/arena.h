#pragma once
// This decides where a queue has its memory: its own, or a part of a block that another process
// maps too.

#include <suture/base/memory_block.h>

#include <cstddef>
#include <memory>
#include <new>

namespace suture {

/// Set-up code of one thread: hands out zero-filled memory, each piece on cache lines of its own.
/// Two processes that make the same structures in the same order get the same pieces of a block,
/// and so agree on it.
class Arena {
 public:
  /// Each piece is memory of its own, and its pages are touched already.
  Arena() = default;

  /// Returns an arena that measures how large a block would have to be: only used() counts. It
  /// writes nothing to the pieces and touches no page of them.
  static Arena measuring();

  /// Says what lies in a block at first.
  enum class Content {
    Zeros,  ///< the caller has to initialise what it makes in it
    Made,   ///< the other process has initialised it
  };
  /// Hands out pieces of `block`, which lives as long as one of them does. Throws SetupError when
  /// the block is used up.
  Arena(std::shared_ptr<MemoryBlock> block, Content content);

  std::shared_ptr<std::byte> take(std::size_t size);
  /// Returns `count` values of type T, which are constructed here if fresh().
  template <class T>
  std::shared_ptr<T> make(std::size_t count = 1);

  /// Returns true if the caller has to initialise the memory.
  bool fresh() const { return isMaker_; }
  /// Returns true if another process can write to the memory: it may write any bytes at any time.
  bool foreign() const { return block_ != nullptr; }
  std::size_t used() const { return used_; }

 private:
  bool isMaker_ = true;
  bool measures_ = false;
  std::size_t used_ = 0;
  std::shared_ptr<MemoryBlock> block_;
};

template <class T>
std::shared_ptr<T> Arena::make(std::size_t count) {
  const std::shared_ptr<std::byte> memory = take(sizeof(T) * count);
  T* const values = reinterpret_cast<T*>(memory.get());
  for (std::size_t i = 0; fresh() && i < count; ++i) new (values + i) T();
  return {memory, values};
}

}  // namespace suture
