#include <vector>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

/// Holds a declaration and the name that it had before.
struct Named {
  std::string subject;
  std::optional<std::string> was;  ///< as written
  model::Source source;
  // These are spelled alike, because was() may say a name in more than one way.
  std::string name;
  std::string formerName;
};

const Named* find(const std::vector<Named>& all, const std::string& name) {
  for (const Named& one : all) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

/// Returns true if `first` was renamed in a circle: its was() names another declaration, whose
/// was() names a third, and so on until one names `first`.
bool isExchanged(const Named& first, const std::vector<Named>& all) {
  const Named* one = &first;
  for (std::size_t steps = 0; one != nullptr && one->was && steps < all.size(); ++steps) {
    one = find(all, one->formerName);
    if (one == &first) return steps > 0;
  }
  return false;
}

void checkExchanges(const std::vector<Named>& all, model::Diagnostics& findings) {
  for (const Named& one : all) {
    if (!isExchanged(one, all)) continue;
    addError(findings, one.source, "exchanged-names",
             one.subject + " says was(\"" + *one.was +
                 "\"), and what has that name now was renamed in turn, back to the name of " +
                 one.subject + "; a lock cannot tell whether the names are exchanged already",
             "rename one of them to a new name first, and update the lock in between");
  }
}

/// Returns the names of types or contracts; was() may say them with or without their namespace.
template <class Declarations>
std::vector<Named> typesOf(const std::string& what, const Declarations& declarations) {
  std::vector<Named> all;
  for (const auto& one : declarations) {
    all.push_back({what + " '" + model::unqualified(one.name) + "'", one.was, one.source, one.name,
                   model::formerName(one.name, one.was).value_or("")});
  }
  return all;
}

/// Returns the names of members; was() may say them as C++ or as the wire spells them.
template <class Members>
std::vector<Named> membersOf(const std::string& what, const Members& members) {
  std::vector<Named> all;
  for (const auto& one : members) {
    all.push_back({what + " '" + one.name + "'", one.was, one.source, model::camelCase(one.name),
                   model::camelCase(one.was.value_or(""))});
  }
  return all;
}

}  // namespace

void checkExchanges(const model::Header& header, model::Diagnostics& findings) {
  checkExchanges(typesOf("type", header.enums), findings);
  checkExchanges(typesOf("type", header.structs), findings);
  checkExchanges(typesOf("contract", header.interfaces), findings);
  for (const model::Enum& type : header.enums) {
    checkExchanges(membersOf("enumerator", type.enumerators), findings);
  }
  for (const model::Struct& type : header.structs) {
    checkExchanges(membersOf("field", type.fields), findings);
  }
  for (const model::Interface& interface : header.interfaces) {
    checkExchanges(membersOf("command", interface.commands), findings);
    checkExchanges(membersOf("event", interface.events), findings);
  }
}

}  // namespace suture::compiler::check
