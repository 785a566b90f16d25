#include <suture/wiring/differences.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

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

// A peer may send any depth; no real description is as deep.
constexpr int kMostLevels = 32;

void flatten(const nlohmann::json& json, const std::string& path, Leaves& leaves, int level = 0) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (level == kMostLevels) {
    leaves[path] = "too deep";
  } else if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      if (!std::ranges::count(kLeftOut, key)) flatten(value, prefix + key, leaves, level + 1);
    }
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      flatten(json[i], prefix + keyOf(json[i], i), leaves, level + 1);
    }
  } else {
    leaves[path] = json.is_string() ? "'" + json.get<std::string>() + "'" : json.dump();
  }
}

Leaves leavesOf(std::string_view text) {
  Leaves leaves;
  const auto json = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) {
    leaves["description"] = "unreadable";
  } else {
    flatten(json, "", leaves);
  }
  return leaves;
}

}  // namespace

std::vector<std::string> differences(std::string_view here, std::string_view there) {
  const Leaves ours = leavesOf(here), theirs = leavesOf(there);
  std::vector<std::string> lines;
  for (const auto& [path, value] : ours) {
    const auto other = theirs.find(path);
    if (other == theirs.end()) {
      lines.push_back(path + ": " + value + " here, missing there");
    } else if (other->second != value) {
      lines.push_back(path + ": " + value + " here, " + other->second + " there");
    }
  }
  for (const auto& [path, value] : theirs) {
    if (!ours.contains(path)) lines.push_back(path + ": missing here, " + value + " there");
  }
  return lines;
}

}  // namespace suture
