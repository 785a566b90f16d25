#pragma once
// These are bytes that are numbers, little-endian, one behind the other.

#include <suture/codec/json/json.h>

#include <cstdint>
#include <span>
#include <vector>

namespace suture::codec {

/// Returns a list of numbers of the kind `bulk` ("Float64"), or of bytes if we know no such kind.
Json numbersIn(std::span<const std::uint8_t> bytes, const std::string& bulk);
/// Does the reverse. Throws for what is no list, or has what is no number of the kind: nothing is
/// cut to fit.
std::vector<std::uint8_t> bytesOf(const Json& numbers, const std::string& bulk);

}  // namespace suture::codec
