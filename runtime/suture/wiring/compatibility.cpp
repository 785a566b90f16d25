#include <suture/wiring/compatibility.h>
#include <suture/wiring/description.h>

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace suture {
namespace {

using Json = nlohmann::json;

// Takes only text, since a peer may have written anything.
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

/// Returns the elements of a list by `keyOf(element)`, the first of each key. It is a map, because
/// a peer may choose keys that fall on one place of a hash table.
template <class KeyOf>
auto indexOf(const Json& list, const KeyOf& keyOf) {
  std::map<decltype(keyOf(list)), const Json*> index;
  for (const Json& one : list) index.emplace(keyOf(one), &one);
  return index;
}

/// Says how a command is called on the wire: the id of the interface that declares it, and its
/// ordinal.
using Method = std::pair<std::string, long>;

/// Returns the commands of a contract, in time proportional to its length, however long the peer
/// made it.
std::vector<Method> methodsOf(const Json& contract) {
  std::map<std::string, std::string> ids;
  for (const Json& node : listOf(contract, "wire")) {
    if (ids.empty()) ids.emplace("", textOf(node, "id"));  // the first is the contract itself
    ids.emplace(textOf(node, "cxx"), textOf(node, "id"));
  }
  std::vector<Method> methods;
  for (const Json& command : listOf(contract, "commands")) {
    const std::string home = textOf(command, "from");
    const auto id = ids.find(home);
    methods.emplace_back(id == ids.end() ? home : id->second, numberOf(command, "ordinal", -1));
  }
  return methods;
}

class Comparison {
 public:
  Comparison(const Json& required, const Json& provided)
      : required_(required), provided_(provided) {}

  Compatibility run() && {
    if (listOf(required_, "wire").empty() || listOf(provided_, "wire").empty()) {
      found_.comparable = false;
      broken("description: it says nothing of the wire");
    } else if (textOf(required_["wire"][0], "id") != textOf(provided_["wire"][0], "id")) {
      broken("contract: " + textOf(required_, "name") + " required, " + textOf(provided_, "name") +
             " provided");
    } else {
      compareNodes();
      listLacking();
    }
    return std::move(found_);
  }

 private:
  void broken(std::string text) { found_.breaks.push_back(std::move(text)); }

  // Skips a type that only one end has, because it is in nothing that both know.
  void compareNodes() {
    const auto idOf = [](const Json& node) { return textOf(node, "id"); };
    const auto others = indexOf(listOf(provided_, "wire"), idOf);
    for (const Json& node : listOf(required_, "wire")) {
      const auto other = others.find(idOf(node));
      if (other != others.end()) compareNode(node, *other->second);
    }
  }

  void compareNode(const Json& node, const Json& other) {
    const std::string title = textOf(node, "kind") + " " + textOf(node, "name");
    if (textOf(node, "kind") != textOf(other, "kind")) {
      return broken(title + ": " + textOf(other, "kind") + " provided");
    }
    const long major = numberOf(node, "major", 1), otherMajor = numberOf(other, "major", 1);
    if (major != otherMajor) {
      broken(title + ": major " + std::to_string(major) + " required, " +
             std::to_string(otherMajor) + " provided");
    }
    // version(n) says that other versions mean something else by the same names.
    const long version = numberOf(node, "version", 1), otherVersion = numberOf(other, "version", 1);
    if (version != otherVersion) {
      broken(title + ": version(" + std::to_string(version) + ") required, version(" +
             std::to_string(otherVersion) + ") provided");
    }
    compareMembers(listOf(node, "members"), listOf(other, "members"), title);
  }

  void compareMembers(const Json& members, const Json& others, const std::string& owner) {
    const auto placeOf = [](const Json& member) { return numberOf(member, "at", -1); };
    const auto theirs = indexOf(others, placeOf);
    for (const Json& member : members) {
      const auto other = theirs.find(placeOf(member));
      if (other != theirs.end()) compareMember(member, *other->second, owner);
    }
  }

  void compareMember(const Json& member, const Json& other, const std::string& owner) {
    const std::string title = "'" + textOf(member, "name") + "' of " + owner;
    const std::string ours = textOf(member, "is"), theirs = textOf(other, "is");
    if (ours != theirs) {
      broken(title + ": " + (ours.empty() ? "nothing" : ours) + " required, " +
             (theirs.empty() ? "nothing" : theirs) + " provided");
    }
    compareMembers(listOf(member, "parameters"), listOf(other, "parameters"), title);
    compareMembers(listOf(member, "results"), listOf(other, "results"), title);
  }

  void listLacking() {
    const std::vector<Method> ours = methodsOf(required_), theirs = methodsOf(provided_);
    const std::set<Method> known(theirs.begin(), theirs.end());
    for (std::size_t i = 0; i < ours.size() && i <= UINT16_MAX; ++i) {
      if (!known.contains(ours[i])) found_.lacking.push_back(static_cast<std::uint16_t>(i));
    }
  }

  const Json &required_, &provided_;
  Compatibility found_;
};

}  // namespace

Compatibility compatibility(std::string_view required, std::string_view provided) {
  const Json ours = readDescription(required), theirs = readDescription(provided);
  return Comparison(ours, theirs).run();
}

}  // namespace suture
