#include <map>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

/// Reports an annotation of a required interface whose name suturec does not see. By that name the
/// annotation finds its interface when the component is created.
void checkUnseen(const model::Port& port, model::Diagnostics& findings) {
  if (!port.optional && !port.maxAgeNanoseconds) return;
  const std::string said = port.optional ? "optional()" : "max_age()";
  const std::string call = port.optional ? "makeOptional()" : "limitAge()";
  addError(findings, port.source, "interface-name-unseen",
           "'" + port.member + "' is to have " + said +
               ", and the name of the required interface cannot be seen in the header",
           "give the name where it is declared, as a literal or a constant: {*this, "
           "\"Slave\"}; or call its " +
               call + " in the constructor");
}

void checkPorts(const model::Component& component, model::Diagnostics& findings) {
  std::map<std::pair<bool, std::string>, const model::Port*> byName;
  for (const model::Port& port : component.ports) {
    if (port.maxAgeNanoseconds && *port.maxAgeNanoseconds <= 0) {
      addError(findings, port.source, "max-age-range",
               "'" + port.member + "' has a max_age() that is not positive; nothing is that young",
               "give the age from which data is of no use, such as max_age(10ms)");
    }
    if (port.name.empty()) {
      checkUnseen(port, findings);
      continue;
    }
    const auto [first, added] = byName.emplace(std::pair{port.provided, port.name}, &port);
    if (added) continue;
    addError(findings, port.source, "interface-name-clash",
             "component '" + model::unqualified(component.name) + "' has two " +
                 (port.provided ? "provided" : "required") + " interfaces '" + port.name + "'",
             "a deployment tells them apart by name: give each its own")
        .notes.push_back({first->second->source, "the first is here"});
  }
}

}  // namespace

void checkComponents(const model::Header& header, model::Diagnostics& findings) {
  for (const model::Component& component : header.components) checkPorts(component, findings);
}

}  // namespace suture::compiler::check
