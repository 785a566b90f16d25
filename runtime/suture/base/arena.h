#pragma once
// Where a queue has its memory: its own, or a part of a block that another process maps too.

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
  /// Each piece is memory of its own, touched by now.
  Arena() = default;

  /// Measures how large a block would have to be: only used() counts. It makes nothing in the
  /// pieces and touches no page of them.
  static Arena measuring();

  /// What lies in a block at first.
  enum class Content {
    Zeros,  ///< what is made in it has to be made ready for use
    Made,   ///< the other process has done that
  };
  /// Pieces of `block`, which lives as long as one of them does. Throws SetupError when it is used
  /// up.
  Arena(std::shared_ptr<MemoryBlock> block, Content content);

  std::shared_ptr<std::byte> take(std::size_t size);
  /// `count` values of type T: new ones if fresh().
  template <class T>
  std::shared_ptr<T> make(std::size_t count = 1);

  /// True if what is in the memory still has to be made ready.
  bool fresh() const { return isMaker_; }
  /// True if another process can write there: it may write anything at any time.
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
