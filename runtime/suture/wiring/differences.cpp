#include <suture/wiring/description.h>
#include <suture/wiring/differences.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace suture {
namespace {

using Leaves = std::map<std::string, std::string>;

// These are for people, or other entries say the same in words of the header.
constexpr std::string_view kLeftOut[] = {"doc", "hash", "core", "ordinal", "wire"};

// Identifies elements of a list by their name if they have one, so that an inserted one is one
// difference.
std::string keyOf(const nlohmann::json& element, std::size_t index) {
  if (element.is_object() && element.contains("name") && element["name"].is_string()) {
    return element["name"].get<std::string>();
  }
  return std::to_string(index);
}

/// A Flattening is made of a description. Each path repeats the keys above it, so a long key with
/// much below it would take far more memory than the description itself: then the rest is left out.
class Flattening {
 public:
  void add(const nlohmann::json& json, const std::string& path) {
    bytes_ += path.size() + 1;
    const std::string prefix = path.empty() ? "" : path + ".";
    if (json.is_object()) {
      for (const auto& [key, value] : json.items()) {
        if (!std::ranges::count(kLeftOut, key)) addBelow(value, prefix, key);
      }
    } else if (json.is_array()) {
      for (std::size_t i = 0; i < json.size(); ++i) addBelow(json[i], prefix, keyOf(json[i], i));
    } else {
      leaves_[path] = json.is_string() ? "'" + json.get<std::string>() + "'" : json.dump();
    }
  }
  Leaves take() && {
    if (isFull()) leaves_["description"] = "longer than can be told";
    return std::move(leaves_);
  }

 private:
  bool isFull() const {
    constexpr std::size_t kMost = 4u << 20;
    return bytes_ > kMost;
  }
  void addBelow(const nlohmann::json& json, const std::string& prefix, const std::string& key) {
    if (!isFull()) add(json, prefix + key);
  }

  Leaves leaves_;
  std::size_t bytes_ = 0;  // how long all paths are together
};

Leaves leavesOf(std::string_view text) {
  const nlohmann::json json = readDescription(text);
  if (json.is_discarded()) return {{"description", "unreadable"}};
  Flattening flattening;
  flattening.add(json, "");
  return std::move(flattening).take();
}

}  // namespace

std::vector<std::string> differences(std::string_view required, std::string_view provided) {
  const Leaves ours = leavesOf(required), theirs = leavesOf(provided);
  std::vector<std::string> lines;
  for (const auto& [path, value] : ours) {
    const auto other = theirs.find(path);
    if (other == theirs.end()) {
      lines.push_back(path + ": " + value + " required, not provided");
    } else if (other->second != value) {
      lines.push_back(path + ": " + value + " required, " + other->second + " provided");
    }
  }
  for (const auto& [path, value] : theirs) {
    if (!ours.contains(path)) lines.push_back(path + ": not required, " + value + " provided");
  }
  return lines;
}

}  // namespace suture
