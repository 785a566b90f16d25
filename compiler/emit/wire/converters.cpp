#include "compiler/emit/wire/converters.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/enum_names.h"
#include "compiler/emit/text/share.h"
#include "compiler/emit/wire/composite_converters.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/lock/schema/composites.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// Returns the enumerators that the schema still has and the header has no more.
std::vector<std::string> removedEnumerators(const Context& context, const model::Enum& type) {
  std::vector<std::string> names;
  const auto lock = context.locks.files.find(lock::lockPath(context.header.path));
  if (lock == context.locks.files.end()) return names;
  for (const lock::Node& node : lock->second.nodes) {
    if (node.name != type.wireName || node.kind != lock::Node::Kind::Enum) continue;
    for (const lock::Member& member : node.members) {
      if (member.removed()) names.push_back(member.name);
    }
  }
  return names;
}

/// Spells an enumerator as capnp's C++ does, or as its number where the user's headers have a macro
/// of that name.
std::string wireConstant(const Context& context, const model::Enum& type,
                         const std::string& wireName) {
  const std::string wire = "wire::" + type.wireName, constant = model::upperSnakeCase(wireName);
  if (!context.model.macros.contains(constant)) return wire + "::" + constant;
  const std::string path = lock::lockPath(context.header.path);
  const auto& members = context.schemas.at(path).named(type.wireName)->members;
  const auto member = std::find_if(members.begin(), members.end(),
                                   [&](const lock::Member& one) { return one.name == wireName; });
  return "static_cast<" + wire + ">(" + std::to_string(member->ordinal) + ")";
}

void emitEnumEncoder(Code& code, const Context& context, const model::Enum& type) {
  const EnumNames names(type, context.header.cxxNamespace);
  code.open(names.wire, " ", enumEncoder(type.name, context), "(", names.slot, " slot) {");
  code.open("switch (", names.subject(), ") {");
  std::set<std::int64_t> values;
  for (const model::Enumerator& one : type.enumerators) {
    if (!values.insert(one.value).second) continue;  // a second name of the same value
    code.line("case ", names.label(one), ": return ", wireConstant(context, type, one.wireName),
              ";");
  }
  code.close("}").line("return ", names.wire, "{};").close("}").blank();
}

void emitEnumDecoder(Code& code, const Context& context, const model::Enum& type) {
  const EnumNames names(type, context.header.cxxNamespace);
  code.open("suture::Errc fromWire(", names.wire, " in, ", names.slot, "& slot) {");
  code.open("switch (in) {");
  for (const model::Enumerator& one : type.enumerators) {
    code.line("case ", wireConstant(context, type, one.wireName), ": return slot = ", kBreakText,
              "static_cast<", names.slot, ">(", names.cxx, "::", one.name, "), suture::Errc{};");
  }
  for (const std::string& removed : removedEnumerators(context, type)) {
    code.line("case ", wireConstant(context, type, removed), ": break;");
  }
  code.close("}");
  const auto fallback = std::find_if(type.enumerators.begin(), type.enumerators.end(),
                                     [](const model::Enumerator& one) { return one.fallback; });
  if (fallback == type.enumerators.end()) {
    code.line("return suture::Errc::Invalid;");
  } else {
    code.line("return slot = ", kBreakText, "static_cast<", names.slot, ">(", names.cxx,
              "::", fallback->name, "), suture::Errc{};");
  }
  code.close("}").blank();
}

/// Returns the parameter's name, or nothing where the body does not use it.
std::string named(const char* name, bool used) { return used ? std::string(" ") + name : ""; }

void emitStruct(Code& code, const Context& context, const model::Struct& type) {
  const std::string slot =
      relative(slotStruct(type.name, context.lookup), context.header.cxxNamespace);
  const std::string wire = "wire::" + type.wireName;
  const std::vector<WireValue> values = fieldValues(type, context);
  const bool any = !values.empty();

  code.open("void toWire(const ", slot, "&", named("slot", any), ", ", wire, "::Builder",
            named("out", any), ") {");
  for (const WireValue& value : values) code.line(encode(value, "out", context), ";");
  code.close("}").blank();

  const bool shift = std::any_of(values.begin(), values.end(),
                                 [](const WireValue& value) { return usesShift(value.type); });
  code.open("suture::Errc fromWire(", wire, "::Reader", named("in", any), ", ", kBreakText, slot,
            "&", named("slot", any), ", ", kBreakText, "suture::Duration", named("shift", shift),
            ") {");
  emitDecodeAndReturn(code, values, "in", "shift", context);
  code.close("}").blank();
}

/// Finds the declared types that the header's own slots and contracts are made of, in a stable
/// order.
class DirectlyUsed {
 public:
  explicit DirectlyUsed(const Context& context) {
    for (const model::Struct& type : context.header.structs) {
      for (const model::Field& field : type.fields) add(field.type);
    }
    for (const model::Interface& interface : context.header.interfaces) add(interface);
  }

  const std::set<std::string>& names() const { return names_; }

 private:
  void add(const model::Interface& interface) {
    for (const model::Command* const command : ownCommands(interface)) {
      for (const model::Parameter& parameter : command->parameters) add(parameter.type);
      if (command->result) add(*command->result);
    }
    for (const model::Command* const read : readsOf(interface)) add(*read->result);
    for (const model::Event& event : interface.events) {
      for (const model::Type& type : event.payload) add(type);
    }
  }

  void add(const model::Type& type) {
    if (!type.name.empty()) names_.insert(type.name);
    for (const model::Type& element : type.element) add(element);
  }

  std::set<std::string> names_;
};

void declare(Code& code, const Context& context, const std::string& name) {
  const model::Header& home = *context.lookup.headerOf(name);
  if (const model::Struct* const type = context.lookup.findStruct(name)) {
    const std::string slot = relative(slotStruct(name, context.lookup), home.cxxNamespace);
    const std::string wire = "wire::" + type->wireName;
    code.line("void toWire(const ", slot, "& slot, ", wire, "::Builder out);");
    code.line("suture::Errc fromWire(", wire, "::Reader in, ", kBreakText, slot, "& slot, ",
              kBreakText, "suture::Duration shift);");
  } else {
    const model::Enum& one = *context.lookup.findEnum(name);
    const EnumNames names(one, home.cxxNamespace);
    const std::string known = model::unqualified(generatedName(name, context.lookup));
    code.line(names.wire, " wire", known, "(", names.slot, " slot);");
    code.line("suture::Errc fromWire(", names.wire, " in, ", names.slot, "& slot);");
  }
}

}  // namespace

void emitForeignConverters(Code& code, const Context& context) {
  const DirectlyUsed used(context);
  std::map<std::string, std::vector<std::string>> byHeader;
  for (const std::string& name : used.names()) {
    const model::Header& home = *context.lookup.headerOf(name);
    if (!declares(context.header, name)) byHeader[home.path].push_back(name);
  }
  for (const auto& [path, names] : byHeader) {
    const std::string& home = context.lookup.headerOf(names.front())->cxxNamespace;
    const bool isElsewhere = path != context.header.path;
    code.line("// Defined in ", isElsewhere ? "" : "another share of ", model::stemOf(path),
              ".wire.cpp.");
    code.verbatim(openNamespace(home));
    for (const std::string& name : names) declare(code, context, name);
    code.verbatim(closeNamespace(home)).blank();
  }
}

void emitConverters(Code& code, const Context& context) {
  const model::Header& header = context.header;
  Code converters;
  for (const model::Enum& type : header.enums) {
    emitEnumEncoder(converters, context, type);
    emitEnumDecoder(converters, context, type);
  }
  bool any = false;
  for (const model::Struct& type : header.structs) {
    if (!isRecursive(type, context.lookup)) continue;
    any = true;
    declare(converters, context, type.name);
  }
  if (any) converters.blank();
  CompositeConverters composites(context);
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) composites.emit(converters, field.type);
    emitStruct(converters, context, type);
  }
  const auto none = [](const model::Struct&) { return false; };
  lock::forEachComposite(header, none, [&](const model::Type& type, const model::Source&) {
    composites.emit(converters, type);
  });
  if (converters.text().empty()) return;
  code.line("// --- between slots and Cap'n Proto").blank().verbatim(converters.text());
}

}  // namespace suture::compiler::emit
