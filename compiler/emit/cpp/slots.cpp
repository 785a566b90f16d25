#include <algorithm>

#include "compiler/emit/cpp/stamps.h"
#include "compiler/emit/cpp/value_checks.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using Shape = model::Type::Shape;

/// Says what the slot's type does not show: the C++ type where its form differs, and the unit.
std::string remark(const model::Field& field, const std::string& home) {
  std::string text;
  std::string unit = field.unit;
  switch (field.type.shape) {
    case Shape::TimePoint:
      text = field.type.clock == model::Clock::Steady ? "suture::Time" : cxxType(field.type, home);
      unit = "ns";
      break;
    case Shape::Duration:
      if (lock::wireScalar(field.type) == model::Scalar::Int64) unit = "ns";
      [[fallthrough]];
    case Shape::Enum:
    case Shape::Matrix:
    case Shape::Quaternion:
    case Shape::Isometry:
    case Shape::Affine:
    case Shape::AnyMatrix: text = cxxType(field.type, home); break;
    case Shape::Scalar:
      if (field.type.scalar == model::Scalar::Bool) text = "bool";
      break;
    case Shape::Struct:
    case Shape::Text:
    case Shape::Array:
    case Shape::List:
    case Shape::Optional:
    case Shape::Map:
    case Shape::Tuple:
    case Shape::Variant:
    case Shape::Nothing: break;
  }
  return text + (text.empty() || unit.empty() ? "" : ", ") + unit;
}

void emitStruct(Code& code, const Context& context, const model::Struct& declaration,
                const std::string& slot) {
  const std::string& home = context.header.cxxNamespace;
  code.doc(declaration.doc.text).open("struct ", slot, " {");
  CommentedLines lines;
  for (const model::Field& field : declaration.fields) {
    lines.add(slotType(field.type, context, home) + " " + field.name + ";", remark(field, home));
  }
  lines.writeTo(code);
  code.close("};").blank();
}

/// If `any` is false the parameters have no names, because the compiler would warn of unused ones.
/// `any` is true if the type has fields.
std::string storeSignature(const std::string& type, const std::string& slot, bool any = true) {
  return "bool store(const " + type + "&" + (any ? " value, " : ", ") + kBreak + slot + "&" +
         (any ? " slot)" : ")");
}

std::string loadSignature(const std::string& type, const std::string& slot, bool any = true) {
  return "void load(const " + slot + "&" + (any ? " slot, " : ", ") + kBreak + type + "&" +
         (any ? " value)" : ")");
}

void emitStore(Code& code, const model::Struct& declaration, const std::string& home,
               const std::string& slot) {
  const bool any = !declaration.fields.empty();
  code.open(storeSignature(relative(declaration.name, home), slot, any), " {");
  if (any) code.line("bool fits = true;");
  for (const model::Field& field : declaration.fields) {
    code.line("fits &= store(", access(declaration, field, "value", true, home), ", ", kBreakText,
              "slot.", field.name, ");");
  }
  code.line(any ? "return fits;" : "return true;").close("}").blank();
}

void emitLoad(Code& code, const model::Struct& declaration, const std::string& home,
              const std::string& slot) {
  const bool any = !declaration.fields.empty();
  code.open(loadSignature(relative(declaration.name, home), slot, any), " {");
  for (const model::Field& field : declaration.fields) {
    code.line(
        changeField(declaration, field, "load(slot." + field.name + ", " + kBreak, ")", home));
  }
  code.close("}").blank();
}

std::string reserveSignature(const std::string& type, const std::string& slot) {
  return "void reserve(const " + slot + "*, " + kBreak + type + "& value)";
}

void emitReserve(Code& code, const model::Struct& declaration, const model::Lookup& lookup,
                 const std::string& home, const std::string& slot) {
  if (!reserves(declaration, lookup)) return;
  code.open(reserveSignature(relative(declaration.name, home), slot), " {");
  for (const model::Field& field : declaration.fields) {
    if (!reserves(field.type, lookup)) continue;
    code.line("suture::reserveFor<decltype(", slot, "::", field.name, ")>(", kBreakText,
              access(declaration, field, "value", false, home), ");");
  }
  code.close("}").blank();
}

/// Calls `emit` for each struct of the header, with the name of its slot.
template <class Emit>
void forEachSlot(const Context& context, const Emit& emit) {
  for (const model::Struct& declaration : context.header.structs) {
    emit(declaration,
         relative(slotStruct(declaration.name, context.lookup), context.header.cxxNamespace));
  }
}

}  // namespace

void emitMembers(Code& code, const Context& context) {
  for (const model::Struct& declaration : context.header.structs) {
    const auto& fields = declaration.fields;
    const auto isHidden = [](const model::Field& field) { return field.isHidden; };
    if (std::none_of(fields.begin(), fields.end(), isHidden)) continue;
    code.line("/// Reaches members that SUTURE_FRIEND() opens to generated code.");
    code.line("template <>")
        .open("struct Members<", rooted(declaration.name, namespaceOf(declaration, context)),
              "> {");
    for (const model::Field& field : fields) {
      if (!field.isHidden) continue;
      code.line("static auto& ", field.name, "(auto&& value) { ", kBreakText, "return value.",
                field.name, "; }");
    }
    code.close("};").blank();
  }
}

void emitSlots(Code& code, const Context& context) {
  bool any = false;
  forEachSlot(context, [&](const model::Struct& declaration, const std::string& slot) {
    if (!isRecursive(declaration, context.lookup)) return;
    any = true;
    code.line("struct ", slot, ";");
  });
  if (any) code.blank();
  forEachSlot(context, [&](const model::Struct& declaration, const std::string& slot) {
    const std::string type = relative(declaration.name, context.header.cxxNamespace);
    emitStruct(code, context, declaration, slot);
    code.line(storeSignature(type, slot), ";").line(loadSignature(type, slot), ";");
    if (reserves(declaration, context.lookup)) code.line(reserveSignature(type, slot), ";");
    declareShift(code, fieldValues(declaration, context), slot, context);
    code.blank();
  });
  declareTypeChecks(code, context);
}

void emitSlotConversions(Code& code, const Context& context) {
  forEachSlot(context, [&](const model::Struct& declaration, const std::string& slot) {
    emitStore(code, declaration, context.header.cxxNamespace, slot);
    emitLoad(code, declaration, context.header.cxxNamespace, slot);
    emitReserve(code, declaration, context.lookup, context.header.cxxNamespace, slot);
    emitShift(code, fieldValues(declaration, context), slot, context);
  });
}

}  // namespace suture::compiler::emit
