#pragma once
// These read JSON that a peer wrote.

#include <suture/codec/json/json.h>

#include <string>
#include <string_view>

namespace suture::cli {

using codec::Json;

/// Returns the text of `key`, or "", because a peer may have written anything.
inline std::string textAt(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Returns what `key` has, or null.
inline const Json& valueAt(const Json& json, const char* key) {
  static const Json kNothing;
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() ? *found : kNothing;
}

/// Returns the list of `key`, or an empty one.
inline const Json& listAt(const Json& json, const char* key) {
  static const Json kNone = Json::array();
  const Json& found = valueAt(json, key);
  return found.is_array() ? found : kNone;
}

/// Returns a JSON text of a peer; discarded if it is none, or nested deeper than anything of ours.
inline Json parsePeers(std::string_view text) {
  constexpr int kDeepest = 64;
  bool tooDeep = false;
  Json json = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, Json&) {
        tooDeep = tooDeep || depth > kDeepest;
        return !tooDeep;
      },
      /*allow_exceptions=*/false);
  return tooDeep ? Json(Json::value_t::discarded) : json;
}

}  // namespace suture::cli
