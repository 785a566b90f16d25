#pragma once
// These are values as bytes, for another process of the same program.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace conformance {

/// A function may take it along to another process, as it cannot a std::string.
struct Text {
  explicit Text(const std::string& from) {
    if (from.size() >= sizeof text) throw std::length_error("too long to cross: " + from);
    from.copy(text, sizeof text - 1);
  }
  char text[200]{};
};

inline std::string toBytes(const std::string& text) { return text; }
inline std::string toBytes(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}
template <class Value>
std::string toBytes(const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>, "it cannot cross to another process");
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value>
Value fromBytes(const std::string& bytes) {
  if constexpr (std::is_same_v<Value, std::string>) {
    return bytes;
  } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < bytes.size(); at += lines.back().size() + 1) {
      lines.push_back(bytes.substr(at, bytes.find('\n', at) - at));
    }
    return lines;
  } else if constexpr (!std::is_void_v<Value>) {
    static_assert(std::is_trivially_copyable_v<Value>, "it cannot cross to another process");
    alignas(Value) char copy[sizeof(Value)]{};
    std::copy_n(bytes.data(), std::min(bytes.size(), sizeof copy), copy);
    return *reinterpret_cast<Value*>(copy);
  }
}

}  // namespace conformance
