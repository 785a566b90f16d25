#pragma once
// The sources of runtime/rt that are to be explored include this before everything else: their
// std::atomic, std::atomic_flag and std::memcpy are then those below. The sources themselves are
// not changed.

// These are all headers of the standard library that they use, so that it keeps its own atomics.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "rt/model/explorer.h"

namespace std {

/// Does as std::atomic does, and every access is a moment at which the other threads may come
/// first. It is exactly a T in memory. It never fails a compare_exchange for no reason.
template <class T>
class explored_atomic {
 public:
  static constexpr bool is_always_lock_free = true;  // as every atomic of the runtime is

  explored_atomic() noexcept : value_() {}
  // Both conversions are those of std::atomic.
  explored_atomic(T value) noexcept : value_(value) {}  // NOLINT(google-explicit-constructor)
  explored_atomic(const explored_atomic&) = delete;
  explored_atomic& operator=(const explored_atomic&) = delete;

  T load(memory_order order = memory_order_seq_cst) const noexcept {
    model::access(this, false);
    return fromBits(
        model::load(this, toBits(value_), acquires(order), order == memory_order_seq_cst));
  }
  void store(T value, memory_order order = memory_order_seq_cst) noexcept {
    model::access(this, true);
    replace(value, order, false);
  }
  T exchange(T value, memory_order order = memory_order_seq_cst) noexcept {
    return modify(order, [value](T) { return value; });
  }
  T fetch_add(T value, memory_order order = memory_order_seq_cst) noexcept {
    return modify(order, [value](T old) { return static_cast<T>(old + value); });
  }
  T fetch_sub(T value, memory_order order = memory_order_seq_cst) noexcept {
    return modify(order, [value](T old) { return static_cast<T>(old - value); });
  }
  T fetch_or(T value, memory_order order = memory_order_seq_cst) noexcept {
    return modify(order, [value](T old) { return static_cast<T>(old | value); });
  }
  bool compare_exchange_weak(T& expected, T value,
                             memory_order order = memory_order_seq_cst) noexcept {
    model::access(this, true);
    const T old = newest(order);
    if (old != expected) {
      expected = old;
      return false;
    }
    replace(value, order, true);
    return true;
  }
  bool compare_exchange_strong(T& expected, T value,
                               memory_order order = memory_order_seq_cst) noexcept {
    return compare_exchange_weak(expected, value, order);
  }
  operator T() const noexcept { return load(); }  // NOLINT(google-explicit-constructor)

 private:
  static bool acquires(memory_order order) {
    return order == memory_order_acquire || order == memory_order_acq_rel ||
           order == memory_order_seq_cst;
  }
  static bool releases(memory_order order) {
    return order == memory_order_release || order == memory_order_acq_rel ||
           order == memory_order_seq_cst;
  }
  static uint64_t toBits(T value) {
    uint64_t bits = 0;
    memcpy(&bits, &value, sizeof(value));
    return bits;
  }
  static T fromBits(uint64_t bits) {
    T value;
    memcpy(&value, &bits, sizeof(value));
    return value;
  }
  // A read-modify-write reads the last store.
  T newest(memory_order order) const {
    return fromBits(model::load(this, toBits(value_), acquires(order), true));
  }
  void replace(T value, memory_order order, bool readModifyWrite) {
    model::store(this, toBits(value_), toBits(value), releases(order), readModifyWrite);
    value_ = value;
  }
  template <class Change>
  T modify(memory_order order, const Change& change) noexcept {
    model::access(this, true);
    const T old = newest(order);
    replace(change(old), order, true);
    return old;
  }

  T value_;  // the last one stored
};

class explored_atomic_flag {
 public:
  bool test_and_set(memory_order order = memory_order_seq_cst) noexcept {
    return value_.exchange(1, order) != 0;
  }
  void clear(memory_order order = memory_order_seq_cst) noexcept { value_.store(0, order); }

 private:
  explored_atomic<unsigned char> value_;
};

inline void* explored_memcpy(void* to, const void* from, size_t size) {
  model::copy(static_cast<byte*>(to), static_cast<const byte*>(from), size);
  return to;
}

}  // namespace std

#define memcpy explored_memcpy
#define atomic explored_atomic
#define atomic_flag explored_atomic_flag
#undef ATOMIC_FLAG_INIT
#define ATOMIC_FLAG_INIT \
  {}
