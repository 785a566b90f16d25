#pragma once
// This rounds sizes to whole words of eight bytes.

#include <cstddef>

namespace suture {

/// Returns `size`, rounded up to whole words.
constexpr std::size_t wordBytes(std::size_t size) { return (size + 7) & ~std::size_t{7}; }

/// Returns how many words have room for `size` bytes.
constexpr std::size_t wordsFor(std::size_t size) { return wordBytes(size) / 8; }

/// Returns `place`, rounded down to where its word begins.
constexpr std::size_t wordBefore(std::size_t place) { return place & ~std::size_t{7}; }

}  // namespace suture
