#include <suture/wiring/compatibility.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace suture {
namespace {

using Json = nlohmann::json;

// What a peer wrote may be anything.
std::string textOf(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

long numberOf(const Json& json, const char* key, long otherwise) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_number_integer() ? found->get<long>() : otherwise;
}

const Json& listOf(const Json& json, const char* key) {
  static const Json kNone = Json::array();
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_array() ? *found : kNone;
}

template <class IsSame>
const Json* findIn(const Json& list, const IsSame& isSame) {
  const auto found = std::find_if(list.begin(), list.end(), isSame);
  return found == list.end() ? nullptr : &*found;
}

class Comparison {
 public:
  Comparison(const Json& here, const Json& there) : here_(here), there_(there) {}

  Compatibility run() && {
    if (listOf(here_, "wire").empty() || listOf(there_, "wire").empty()) {
      found_.comparable = false;
      broken("description: it says nothing of the wire");
    } else if (textOf(here_["wire"][0], "id") != textOf(there_["wire"][0], "id")) {
      broken("contract: " + textOf(here_, "name") + " here, " + textOf(there_, "name") + " there");
    } else {
      compareNodes();
      found_.commands = compareNumbers("commands");
      compareNumbers("events");
    }
    return std::move(found_);
  }

 private:
  void broken(std::string text) { found_.breaks.push_back(std::move(text)); }

  // A type that one end alone has is in nothing that both know.
  void compareNodes() {
    for (const Json& node : listOf(here_, "wire")) {
      const std::string id = textOf(node, "id");
      const Json* const other =
          findIn(listOf(there_, "wire"), [&](const Json& one) { return textOf(one, "id") == id; });
      if (other != nullptr) compareNode(node, *other);
    }
  }

  void compareNode(const Json& node, const Json& other) {
    const std::string title = textOf(node, "kind") + " " + textOf(node, "name");
    if (textOf(node, "kind") != textOf(other, "kind")) {
      return broken(title + ": " + textOf(other, "kind") + " there");
    }
    const long major = numberOf(node, "major", 1), otherMajor = numberOf(other, "major", 1);
    if (major != otherMajor) {
      broken(title + ": major " + std::to_string(major) + " here, " + std::to_string(otherMajor) +
             " there");
    }
    // Who says version(n) says that other versions mean something else by the same names.
    const long version = numberOf(node, "version", 1), otherVersion = numberOf(other, "version", 1);
    if (version != otherVersion) {
      broken(title + ": version(" + std::to_string(version) + ") here, version(" +
             std::to_string(otherVersion) + ") there");
    }
    compareMembers(listOf(node, "members"), listOf(other, "members"), title);
  }

  void compareMembers(const Json& members, const Json& others, const std::string& owner) {
    for (const Json& member : members) {
      const long place = numberOf(member, "at", -1);
      const Json* const other =
          findIn(others, [&](const Json& one) { return numberOf(one, "at", -1) == place; });
      if (other != nullptr) compareMember(member, *other, owner);
    }
  }

  void compareMember(const Json& member, const Json& other, const std::string& owner) {
    const std::string title = "'" + textOf(member, "name") + "' of " + owner;
    const std::string ours = textOf(member, "is"), theirs = textOf(other, "is");
    if (ours != theirs) {
      broken(title + ": " + (ours.empty() ? "nothing" : ours) + " here, " +
             (theirs.empty() ? "nothing" : theirs) + " there");
    }
    compareMembers(listOf(member, "parameters"), listOf(other, "parameters"), title);
    compareMembers(listOf(member, "results"), listOf(other, "results"), title);
  }

  /// Who has more has it behind the others: else the two ends number them differently.
  std::size_t compareNumbers(const char* kind) {
    const Json &ours = listOf(here_, kind), &theirs = listOf(there_, kind);
    const std::size_t common = std::min(ours.size(), theirs.size());
    for (std::size_t i = 0; i < common; ++i) {
      const bool same = numberOf(ours[i], "ordinal", -1) == numberOf(theirs[i], "ordinal", -2) &&
                        textOf(ours[i], "from") == textOf(theirs[i], "from");
      if (same) continue;
      broken(std::string(kind) + ": number " + std::to_string(i + 1) + " is '" +
             textOf(ours[i], "name") + "' here, '" + textOf(theirs[i], "name") + "' there");
      return i;
    }
    return common;
  }

  const Json &here_, &there_;
  Compatibility found_;
};

}  // namespace

Compatibility compatibility(std::string_view here, std::string_view there) {
  const Json ours = Json::parse(here, nullptr, /*allow_exceptions=*/false);
  const Json theirs = Json::parse(there, nullptr, /*allow_exceptions=*/false);
  return Comparison(ours, theirs).run();
}

}  // namespace suture
