#pragma once

#include <suture/base/time.h>

#include <cstdint>
#include <nlohmann/json.hpp>

namespace robots {

/// Returns a stamp of a recording, where it is in ns of the steady clock.
inline suture::Time stampOf(const nlohmann::json& json) {
  return suture::fromNanoseconds(json.get<std::int64_t>());
}

}  // namespace robots
