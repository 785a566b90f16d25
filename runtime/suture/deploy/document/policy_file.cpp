#include <suture/base/nearest.h>
#include <suture/deploy/document/document_problems.h>
#include <suture/deploy/document/policy_file.h>
#include <suture/deploy/document/schema_check.h>

#include <map>
#include <string>
#include <vector>

namespace suture {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;
using Roles = std::map<std::string, Role>;

Roles readRoles(const JsonDocument& document, DocumentProblems& problems) {
  Roles roles;
  const json& given = document.value().at("roles");
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string name = given[i].at("name");
    Role role{.full = given[i].value("full", Names{}), .read = given[i].value("read", Names{})};
    if (roles.emplace(name, std::move(role)).second) continue;
    problems.report("/roles/" + std::to_string(i) + "/name",
                    "there is another role '" + name + "'; give each its own name");
  }
  return roles;
}

Rule readRule(const JsonDocument& document, std::size_t index, const Roles& roles,
              DocumentProblems& problems) {
  const json& given = document.value().at("rules").at(index);
  const std::string name = given.at("role");
  const auto found = roles.find(name);
  if (found != roles.end()) return {given.at("who"), found->second};
  Names known;
  for (const auto& [role, unused] : roles) known.push_back(role);
  const std::string nearest = nearestName(name, known);
  problems.report(
      "/rules/" + std::to_string(index) + "/role",
      "no role '" + name + "' here; there are " + listNames(known) +
          (nearest.empty() ? "; add it to 'roles'" : "; did you mean '" + nearest + "'?"));
  return {};
}

}  // namespace

Policy readPolicy(const std::filesystem::path& file) {
  return readPolicy(JsonDocument::read(file));
}

Policy readPolicy(const JsonDocument& document) {
  requireSchema(document, policySchema());
  DocumentProblems problems(document);
  const Roles roles = readRoles(document, problems);
  std::vector<Rule> rules;
  for (std::size_t i = 0; i < document.value().at("rules").size(); ++i) {
    rules.push_back(readRule(document, i, roles, problems));
  }
  problems.throwIfAny();
  return Policy(std::move(rules));
}

}  // namespace suture
