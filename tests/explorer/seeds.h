#pragma once
// This is how a run of the explorer divides the seeds that it is asked for.

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace explorer {

/// Returns the number that the environment gives as `text`, at least `least`. Throws
/// std::invalid_argument if it is none, because a run of no seed would find nothing and pass.
inline std::uint64_t numberIn(std::string_view variable, std::string_view text,
                              std::uint64_t least) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && stopped == end && number >= least) return number;
  throw std::invalid_argument(std::string(variable) + " is \"" + std::string(text) +
                              "\": give a number of at least " + std::to_string(least));
}

/// Holds neighbouring seeds.
struct Seeds {
  std::uint64_t first, count;
};

/// Returns into how many blocks so many seeds are divided, so that none is empty.
inline std::uint64_t blocksOf(std::uint64_t count) { return std::min(count, std::uint64_t{8}); }

/// Returns those of one block. Each seed is in one block.
inline Seeds seedsOf(std::uint64_t block, const Seeds& all) {
  const std::uint64_t blocks = blocksOf(all.count);
  const std::uint64_t begin = all.count * block / blocks;
  return {all.first + begin, all.count * (block + 1) / blocks - begin};
}

}  // namespace explorer
