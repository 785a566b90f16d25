#include <suture/wiring/description.h>

#include <cstddef>

namespace suture {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongest = 1u << 20;
constexpr int kMostLevels = 32;

/// Counts the brackets outside of texts. A callback of the parser could, but for each object that
/// ends the parser then looks at all that are beside it.
bool isTooDeep(std::string_view json) {
  int levels = 0;
  bool inText = false;
  for (std::size_t i = 0; i < json.size() && levels <= kMostLevels; ++i) {
    const char one = json[i];
    if (one == '"') {
      inText = !inText;
    } else if (inText) {
      if (one == '\\') ++i;  // what it quotes
    } else if (one == '[' || one == '{') {
      ++levels;
    } else if (one == ']' || one == '}') {
      --levels;
    }
  }
  return levels > kMostLevels;
}

}  // namespace

Json readDescription(std::string_view text) {
  if (text.size() > kLongest || isTooDeep(text)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, /*allow_exceptions=*/false);
}

}  // namespace suture
