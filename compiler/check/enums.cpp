#include <map>

#include "compiler/check/rules.h"

namespace suture::compiler::check {
namespace {

constexpr std::size_t kMostEnumerators = 65535;

void checkValues(const model::Enum& type, model::Diagnostics& findings) {
  std::map<std::int64_t, const model::Enumerator*> byValue;
  for (const model::Enumerator& enumerator : type.enumerators) {
    const auto [first, added] = byValue.emplace(enumerator.value, &enumerator);
    if (added) continue;
    addError(findings, enumerator.source, "duplicate-value",
             "enumerators '" + first->second->name + "' and '" + enumerator.name +
                 "' have the same value " + std::to_string(enumerator.value),
             "a receiver could not tell them apart; drop one")
        .notes.push_back({first->second->source, "the first is here"});
  }
}

void checkFallback(const model::Enum& type, model::Diagnostics& findings) {
  const model::Enumerator* first = nullptr;
  for (const model::Enumerator& enumerator : type.enumerators) {
    if (!enumerator.fallback) continue;
    if (first) {
      addError(
          findings, enumerator.source, "second-fallback",
          "enumerators '" + first->name + "' and '" + enumerator.name + "' are both the fallback",
          "keep fallback() on the one that stands for all that a receiver does not know")
          .notes.push_back({first->source, "the first is here"});
    }
    first = &enumerator;
  }
}

}  // namespace

void checkEnums(const model::Header& header, model::Diagnostics& findings) {
  for (const model::Enum& type : header.enums) {
    if (type.enumerators.empty()) {
      addError(findings, type.source, "empty-enum", "enum '" + type.name + "' has no enumerators",
               "give it at least one; the first is what an unset field reads as");
    } else if (type.enumerators.size() > kMostEnumerators) {
      addError(findings, type.source, "enum-size",
               "enum '" + type.name + "' has more than 65535 enumerators",
               "use an integer for what is not a set of names");
    }
    checkValues(type, findings);
    checkFallback(type, findings);
  }
}

}  // namespace suture::compiler::check
