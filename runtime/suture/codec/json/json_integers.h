#pragma once
// These are whole numbers in JSON, which has one kind of them.

#include <suture/codec/json/json.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace suture::codec {

/// Returns none for what is no whole number, or one that an Integer cannot hold.
template <class Integer>
std::optional<Integer> integerOf(const Json& json) {
  const auto held = [](auto number) {
    return std::in_range<Integer>(number) ? std::optional(static_cast<Integer>(number))
                                          : std::nullopt;
  };
  if (json.is_number_unsigned()) return held(json.get<std::uint64_t>());
  if (json.is_number_integer()) return held(json.get<std::int64_t>());
  return std::nullopt;
}

}  // namespace suture::codec
