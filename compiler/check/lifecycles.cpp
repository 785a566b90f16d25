#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

class LifecycleRule {
 public:
  LifecycleRule(const model::Lookup& lookup, model::Diagnostics& findings)
      : lookup_(lookup), findings_(findings) {}

  void checkSince(const std::string& subject, const model::Lifecycle& lifecycle,
                  const model::Source& source) {
    if (lifecycle.since != 0u) return;
    addError(findings_, source, "since-version", subject + " is there since(0)",
             "versions count from 1");
  }

  /// Warns of a deprecated type, unless its user is deprecated too.
  void checkUse(const std::string& subject, const model::Lifecycle& user, const model::Type& type,
                const model::Source& source) {
    if (!user.deprecated.empty()) return;
    for (const model::Type& element : type.element) checkUse(subject, user, element, source);
    const std::string why = deprecationOf(type.name);
    if (why.empty()) return;
    addError(findings_, source, "deprecated-type",
             subject + " is of type '" + type.name + "', which is deprecated: " + why,
             "use another type, or say deprecated() here as well")
        .severity = model::Diagnostic::Severity::Warning;
  }

 private:
  std::string deprecationOf(const std::string& name) const {
    if (const model::Struct* const one = lookup_.findStruct(name)) return one->lifecycle.deprecated;
    if (const model::Enum* const one = lookup_.findEnum(name)) return one->lifecycle.deprecated;
    return "";
  }

  const model::Lookup& lookup_;
  model::Diagnostics& findings_;
};

void checkStruct(const model::Struct& type, LifecycleRule& rule) {
  rule.checkSince("type '" + model::unqualified(type.name) + "'", type.lifecycle, type.source);
  for (const model::Field& field : type.fields) {
    const std::string subject = "field '" + field.name + "'";
    rule.checkSince(subject, field.lifecycle, field.source);
    const bool old = !type.lifecycle.deprecated.empty();
    rule.checkUse(subject, old ? type.lifecycle : field.lifecycle, field.type, field.source);
  }
}

void checkEnum(const model::Enum& type, LifecycleRule& rule) {
  rule.checkSince("type '" + model::unqualified(type.name) + "'", type.lifecycle, type.source);
  for (const model::Enumerator& one : type.enumerators) {
    rule.checkSince("enumerator '" + one.name + "'", one.lifecycle, one.source);
  }
}

void checkLifecyclesOf(const model::Interface& interface, LifecycleRule& rule) {
  rule.checkSince("contract '" + model::unqualified(interface.name) + "'", interface.lifecycle,
                  interface.source);
  for (const model::Command& command : interface.commands) {
    rule.checkSince("command '" + command.name + "'", command.lifecycle, command.source);
    for (const model::Parameter& parameter : command.parameters) {
      rule.checkUse("parameter '" + parameter.name + "'", command.lifecycle, parameter.type,
                    parameter.source);
    }
    if (!command.result) continue;
    rule.checkUse("the result of command '" + command.name + "'", command.lifecycle,
                  *command.result, command.source);
  }
  for (const model::Event& event : interface.events) {
    rule.checkSince("event '" + event.name + "'", event.lifecycle, event.source);
    for (const model::Type& type : event.payload) {
      rule.checkUse("the payload of event '" + event.name + "'", event.lifecycle, type,
                    event.source);
    }
  }
}

}  // namespace

void checkLifecycles(const model::Header& header, const model::Lookup& lookup,
                     model::Diagnostics& findings) {
  LifecycleRule rule(lookup, findings);
  for (const model::Struct& type : header.structs) checkStruct(type, rule);
  for (const model::Enum& type : header.enums) checkEnum(type, rule);
  for (const model::Interface& interface : header.interfaces) checkLifecyclesOf(interface, rule);
}

}  // namespace suture::compiler::check
