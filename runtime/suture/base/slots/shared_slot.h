#pragma once
// This says where the slot of a record lies. A slot that is trivially copyable is part of the
// record. One that owns memory lies on the heap, and the record holds a counted pointer to it,
// which is released with the record. Only devices have such slots, and no real-time thread touches
// them.

#include <suture/base/field_path.h>
#include <suture/base/slots/scratch.h>
#include <suture/base/time.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace suture {

/// A SharedSlot is a slot on the heap, without its type. Any thread may retain and release it.
class SharedSlot {
 public:
  virtual ~SharedSlot() = default;
  SharedSlot(const SharedSlot&) = delete;
  SharedSlot& operator=(const SharedSlot&) = delete;

  void retain() { references_.fetch_add(1, std::memory_order_relaxed); }
  void release() {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
  }

 protected:
  SharedSlot() = default;

 private:
  std::atomic<std::uint32_t> references_{1};
};

template <class Slot>
class HeapSlot final : public SharedSlot {
 public:
  HeapSlot() = default;
  explicit HeapSlot(Slot&& from) : value(std::move(from)) {}

  Slot value{};
};

template <class Slot>
inline constexpr bool ownsMemory = !std::is_trivially_copyable_v<Slot>;

/// A slot takes up this many bytes in a record.
template <class Slot>
inline constexpr std::uint32_t slotSize = ownsMemory<Slot> ? sizeof(SharedSlot*) : sizeof(Slot);

// --- a record's memory that holds a counted pointer

inline SharedSlot* sharedSlotIn(const std::byte* memory) {
  SharedSlot* slot;
  std::memcpy(&slot, memory, sizeof(slot));
  return slot;
}
inline void putSharedSlot(std::byte* memory, SharedSlot* slot) {
  std::memcpy(memory, &slot, sizeof(slot));
}
/// Releases the slot that `memory` holds, if it holds one.
inline void releaseSharedSlot(std::byte* memory) {
  if (SharedSlot* const slot = sharedSlotIn(memory)) slot->release();
  putSharedSlot(memory, nullptr);
}

// --- a record's memory that holds a slot of either kind

/// Returns the slot to fill, in memory that holds none.
template <class Slot>
Slot& newSlot(std::byte* memory) {
  if constexpr (ownsMemory<Slot>) {
    auto* const slot = new HeapSlot<Slot>;
    putSharedSlot(memory, slot);
    return slot->value;
  } else {
    return *reinterpret_cast<Slot*>(memory);
  }
}

/// Returns the slot that `memory` holds.
template <class Slot>
const Slot& slotIn(const std::byte* memory) {
  if constexpr (ownsMemory<Slot>) {
    return static_cast<const HeapSlot<Slot>*>(sharedSlotIn(memory))->value;
  } else {
    return *reinterpret_cast<const Slot*>(memory);
  }
}

/// Tells if the slot in a record passes `check`.
template <class Slot, bool (*check)(const Slot&, FieldPath*)>
bool checkSlot(const std::byte* memory, FieldPath* path) {
  return check(slotIn<Slot>(memory), path);
}

/// Shifts the stamps of a slot in a record, by its shiftStamps() or by `turn`. The slot is of a
/// type that owns no memory, and may have any bytes.
template <class Slot>
void shiftSlot(std::byte* memory, Duration shift) {
  shiftStamps(*reinterpret_cast<Slot*>(memory), shift);
}
template <class Slot, void (*turn)(Slot&, Duration)>
void shiftSlot(std::byte* memory, Duration shift) {
  turn(*reinterpret_cast<Slot*>(memory), shift);
}

/// Holds one thread's slot outside any record; memory() has what its record would hold.
template <class Slot>
class LooseSlot {
 public:
  LooseSlot() = default;
  LooseSlot(const LooseSlot&) = delete;
  LooseSlot& operator=(const LooseSlot&) = delete;

  Slot& value() { return slot_; }
  /// Sets the slot to zero and returns it.
  Slot& zero() { return slot_ = Slot{}; }
  /// Returns what to copy to a record, or from one.
  std::byte* memory() { return reinterpret_cast<std::byte*>(&slot_); }

 private:
  Slot slot_;
};

/// Keeps a large slot in the thread's scratch memory, since a stack may be too small for it.
template <class Slot>
requires(!ownsMemory<Slot> && sizeof(Slot) > kLargestOnStack) class LooseSlot<Slot> {
 public:
  static_assert(alignof(Slot) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  Slot& value() { return *reinterpret_cast<Slot*>(memory()); }
  Slot& zero() { return *new (memory()) Slot{}; }
  std::byte* memory() { return scratch_.memory(); }

 private:
  ScratchMemory scratch_{sizeof(Slot)};
};

template <class Slot>
requires ownsMemory<Slot>
class LooseSlot<Slot> {
 public:
  LooseSlot() = default;
  LooseSlot(const LooseSlot&) = delete;
  LooseSlot& operator=(const LooseSlot&) = delete;
  ~LooseSlot() { releaseSharedSlot(memory()); }

  /// Makes a new slot at the first call, unless memory() has been given one.
  Slot& value() {
    if (slot_ == nullptr) slot_ = new HeapSlot<Slot>;
    return static_cast<HeapSlot<Slot>*>(slot_)->value;
  }
  Slot& zero() {
    releaseSharedSlot(memory());
    return value();
  }
  std::byte* memory() { return reinterpret_cast<std::byte*>(&slot_); }

 private:
  SharedSlot* slot_ = nullptr;
};

}  // namespace suture
