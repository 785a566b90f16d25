#include <suture/wiring/description.h>
#include <suture/wiring/differences.h>
#include <suture/wiring/optional_commands.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

namespace suture {
namespace {

using Json = nlohmann::json;

/// Returns a text member; "" if the description, which a peer wrote, has none.
std::string memberText(const Json& contract, const char* key) {
  const auto found = contract.find(key);
  return found != contract.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Returns the hash of what is not optional.
std::string coreOf(const Json& contract) {
  const std::string core = memberText(contract, "core");
  return core.empty() ? memberText(contract, "hash") : core;
}

Json commandsOf(const Json& contract) {
  const auto found = contract.find("commands");
  return found != contract.end() && found->is_array() ? *found : Json::array();
}

bool allOptional(const Json& commands, std::size_t from) {
  for (std::size_t i = from; i < commands.size(); ++i) {
    if (!commands[i].is_object() || !commands[i].contains("optional")) return false;
  }
  return true;
}

}  // namespace

std::optional<std::vector<std::uint16_t>> lackingOptional(std::string_view here,
                                                          std::string_view there) {
  const Json ours = readDescription(here), theirs = readDescription(there);
  if (!ours.is_object() || !theirs.is_object()) return std::nullopt;
  if (coreOf(ours).empty() || coreOf(ours) != coreOf(theirs)) return std::nullopt;
  const Json ourCommands = commandsOf(ours), theirCommands = commandsOf(theirs);
  std::size_t common = 0;
  while (common < ourCommands.size() && common < theirCommands.size() &&
         differences(ourCommands[common].dump(), theirCommands[common].dump()).empty()) {
    ++common;
  }
  if (!allOptional(ourCommands, common) || !allOptional(theirCommands, common)) return std::nullopt;
  std::vector<std::uint16_t> lacking(ourCommands.size() - common);
  std::iota(lacking.begin(), lacking.end(), static_cast<std::uint16_t>(common));
  return lacking;
}

}  // namespace suture
