#include "compiler/emit/text/member_names.h"

#include <algorithm>
#include <cctype>

namespace suture::compiler::emit {

MemberNames::MemberNames(const model::Interface& interface) {
  for (const model::Command& command : interface.commands) names_.insert(command.name);
  for (const model::Event& event : interface.events) names_.insert(event.name);
}

std::string MemberNames::spell(const std::string& name) const {
  const auto isPart = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  const auto end = std::find_if_not(name.begin(), name.end(), isPart);
  const std::string first(name.begin(), end);
  // C++ does not take a member for a namespace.
  const bool qualified = name.substr(first.size()).starts_with("::");
  return (!qualified && names_.contains(first) ? "suture::" : "") + name;
}

}  // namespace suture::compiler::emit
