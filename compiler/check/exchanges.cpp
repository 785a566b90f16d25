#include <vector>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

/// Is something that may have been called otherwise.
struct Named {
  std::string subject;
  std::string name;
  std::optional<std::string> was;
  model::Source source;
};

const Named* find(const std::vector<Named>& all, const std::string& name) {
  for (const Named& one : all) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

/// Tells if one was() after the other leads from `first` back to it.
bool isExchanged(const Named& first, const std::vector<Named>& all) {
  const Named* one = &first;
  for (std::size_t steps = 0; one != nullptr && one->was && steps < all.size(); ++steps) {
    one = find(all, *one->was);
    if (one == &first) return steps > 0;
  }
  return false;
}

void checkExchanges(const std::vector<Named>& all, model::Diagnostics& findings) {
  for (const Named& one : all) {
    if (!isExchanged(one, all)) continue;
    addError(findings, one.source, "exchanged-names",
             one.subject + " says was(\"" + *one.was +
                 "\"), and the names lead back to it; a lock cannot tell whether that was done",
             "rename one of them to a new name first, and update the lock in between");
  }
}

template <class Declarations>
std::vector<Named> namesOf(const std::string& what, const Declarations& declarations) {
  std::vector<Named> all;
  for (const auto& one : declarations) {
    const std::string name = model::unqualified(one.name);
    all.push_back({what + " '" + name + "'", name, one.was, one.source});
  }
  return all;
}

}  // namespace

void checkExchanges(const model::Header& header, model::Diagnostics& findings) {
  checkExchanges(namesOf("type", header.enums), findings);
  checkExchanges(namesOf("type", header.structs), findings);
  checkExchanges(namesOf("contract", header.interfaces), findings);
  for (const model::Enum& type : header.enums) {
    checkExchanges(namesOf("enumerator", type.enumerators), findings);
  }
  for (const model::Struct& type : header.structs) {
    checkExchanges(namesOf("field", type.fields), findings);
  }
  for (const model::Interface& interface : header.interfaces) {
    checkExchanges(namesOf("command", interface.commands), findings);
    checkExchanges(namesOf("event", interface.events), findings);
  }
}

}  // namespace suture::compiler::check
