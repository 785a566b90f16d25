#include "compiler/model/generated_names.h"

#include "compiler/model/naming.h"

namespace suture::compiler::model {
namespace {

template <class Member>
std::string memberStruct(const Interface& interface, const Member& member, const char* ending,
                         const Lookup& lookup) {
  const std::string& owner = member.inheritedFrom.empty() ? interface.name : member.inheritedFrom;
  return generatedName(owner, lookup) + pascalCase(member.name) + ending;
}

}  // namespace

std::string generatedName(const std::string& declared, const Lookup& lookup) {
  const Header* const header = lookup.headerOf(declared);
  const bool hasHome = header != nullptr && !header->cxxNamespace.empty();
  const std::string home = hasHome ? header->cxxNamespace + "::" : "";
  std::string flat = declared.starts_with(home) ? declared.substr(home.size()) : declared;
  for (std::size_t at; (at = flat.find("::")) != std::string::npos;) flat.erase(at, 2);
  return home + flat;
}

std::string pascalCase(const std::string& cxxName) { return titleCase(camelCase(cxxName)); }

std::string argumentsStruct(const Interface& interface, const Command& command,
                            const Lookup& lookup) {
  return memberStruct(interface, command, "Arguments", lookup);
}

std::string payloadStruct(const Interface& interface, const Event& event, const Lookup& lookup) {
  return memberStruct(interface, event, "Payload", lookup);
}

}  // namespace suture::compiler::model
