#include "compiler/check/rules.h"
#include "compiler/check/type_tree.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

constexpr std::uint64_t kLargestSlot = 16u << 20;

/// One type that a contract carries, and where.
class Carried {
 public:
  Carried(std::string subject, const model::Source& source, const model::Lookup& lookup,
          model::Diagnostics& findings)
      : subject_(std::move(subject)), source_(source), lookup_(lookup), findings_(findings) {}

  void check(const model::Type& type) {
    bool bounded = true;
    walk(type, lookup_, [&](const Place& place) {
      if (place.recursive) {
        reportRecursive(place);
      } else if (isOpen(place.type)) {
        reportOpen(type, place);
      } else {
        return true;
      }
      return bounded = false;
    });
    if (bounded && flatSize(type, lookup_) > kLargestSlot) {
      addError(
          findings_, source_, "slot-size",
          subject_ + " needs more than " + std::to_string(kLargestSlot) + " bytes at its bounds",
          "lower its capacity(); every place in a queue has room for the largest value");
    }
  }

 private:
  void reportRecursive(const Place& place) {
    addError(findings_, source_, "recursive-type",
             subject_ + " has no bound: '" + place.field->name + "' leads back to '" +
                 model::unqualified(place.type.name) + "'",
             "in a contract, keep a flat list of nodes that refer to each other by index")
        .notes.push_back({place.field->source, "the field is here"});
  }

  void reportOpen(const model::Type& type, const Place& place) {
    const std::string name = type.name.empty() ? type.spelling : model::unqualified(type.name);
    const std::string path = place.path.empty() ? "" : ": " + name + "." + place.path;
    model::Diagnostic& finding = addError(
        findings_, source_, "unbounded-contract",
        subject_ + " has no bound" + path + " is a " + place.type.spelling + " without capacity()",
        place.field
            ? "add SUTURE_FIELD(capacity(n)) to the field, one number for each string or list"
            : "add SUTURE_FIELD(capacity(n)) to it, one number for each string or list");
    if (path.empty()) {
      finding.message = subject_ + " has no bound: " + place.type.spelling + " without capacity()";
    }
    if (place.field) finding.notes.push_back({place.field->source, "the field is here"});
  }

  std::string subject_;
  const model::Source& source_;
  const model::Lookup& lookup_;
  model::Diagnostics& findings_;
};

}  // namespace

void checkBounds(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings) {
  for (const model::Interface& interface : header.interfaces) {
    for (const model::Command& command : interface.commands) {
      for (const model::Parameter& parameter : command.parameters) {
        Carried("parameter '" + parameter.name + "' of command '" + command.name + "'",
                parameter.source, lookup, findings)
            .check(parameter.type);
      }
      if (!command.result) continue;
      Carried("the result of command '" + command.name + "'", command.source, lookup, findings)
          .check(*command.result);
    }
    for (const model::Event& event : interface.events) {
      for (const model::Type& payload : event.payload) {
        Carried("the payload of event '" + event.name + "'", event.source, lookup, findings)
            .check(payload);
      }
    }
  }
}

}  // namespace suture::compiler::check
