#include "rt/stress/payload.h"

#include <cstring>

namespace stress {
namespace {

std::uint64_t wordAt(std::span<const std::byte> memory, std::size_t index) {
  std::uint64_t word;
  std::memcpy(&word, memory.data() + 8 * index, 8);
  return word;
}

void setWord(std::span<std::byte> memory, std::size_t index, std::uint64_t word) {
  std::memcpy(memory.data() + 8 * index, &word, 8);
}

// Returns one word after another of a sequence that `state` begins, by SplitMix64 (Steele, Lea,
// Flood 2014).
std::uint64_t mixed(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t word = state;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
  word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
  return word ^ (word >> 31);
}

}  // namespace

void fill(std::span<std::byte> memory, std::uint64_t serial) {
  const std::size_t words = memory.size() / 8;
  std::uint64_t state = serial, sum = serial;
  setWord(memory, 0, serial);
  for (std::size_t i = 1; i + 1 < words; ++i) {
    const std::uint64_t word = mixed(state);
    setWord(memory, i, word);
    sum += word;
  }
  setWord(memory, words - 1, ~sum);
}

std::uint64_t serialOf(std::span<const std::byte> memory) {
  const std::size_t words = memory.size() / 8;
  const std::uint64_t serial = wordAt(memory, 0);
  std::uint64_t state = serial, sum = serial;
  for (std::size_t i = 1; i + 1 < words; ++i) {
    const std::uint64_t word = wordAt(memory, i);
    if (word != mixed(state)) return 0;
    sum += word;
  }
  return wordAt(memory, words - 1) == ~sum ? serial : 0;
}

}  // namespace stress
