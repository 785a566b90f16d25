#pragma once
// This is JSON in the order in which it was written.

#include <nlohmann/json.hpp>

namespace suture::codec {

using Json = nlohmann::ordered_json;

}  // namespace suture::codec
