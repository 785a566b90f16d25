#pragma once
// This says how generated code spells an enum, its values and what holds one of them.

#include <string>

#include "compiler/emit/text/context.h"
#include "compiler/emit/text/contract.h"

namespace suture::compiler::emit {

struct EnumNames {
  EnumNames(const model::Enum& type, const std::string& home)
      : cxx(relative(type.name, home)),
        wire("wire::" + type.wireName),
        slot(type.underlyingType),
        isOpen(type.isOpen) {}

  /// Spells what a switch over a slot compares. Few integers are values of an enum without a
  /// declared type, and whatever has come must not become another.
  std::string subject() const { return isOpen ? "slot" : "static_cast<" + cxx + ">(slot)"; }
  std::string label(const model::Enumerator& one) const {
    const std::string name = cxx + "::" + one.name;
    return isOpen ? "static_cast<" + slot + ">(" + name + ")" : name;
  }

  std::string cxx, wire, slot;
  bool isOpen;
};

}  // namespace suture::compiler::emit
