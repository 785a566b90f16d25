#include "compiler/emit/wire_form.h"

#include <algorithm>
#include <iterator>

#include "compiler/emit/contract.h"
#include "compiler/lock/wanted.h"
#include "compiler/lock/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

bool isSequence(const Type& type) {
  return type.shape == Shape::List || type.shape == Shape::Array;
}

/// Travels as a capnp struct of its own.
bool isRecord(const Type& type) {
  return type.shape == Shape::Struct || !lock::namedEigenType(type).empty();
}

/// Travels as one number.
bool isNumber(const Type& type) {
  return type.shape == Shape::Scalar || type.shape == Shape::Duration ||
         type.shape == Shape::TimePoint;
}

bool isSteady(const Type& type) {
  return type.shape == Shape::TimePoint && type.clock == model::Clock::Steady;
}

/// A sequence that one overload of the runtime's toWire() converts as a whole.
bool isPlainSequence(const Type& type) {
  const Type& element = type.element.front();
  return isNumber(element) || (type.shape == Shape::List && element.shape == Shape::Text);
}

std::string elementSlot(const Type& type, const Context& context) {
  return slotType(type.element.front(), context, context.header.cxxNamespace);
}

/// "robots::types::" in front of a function for a type of another namespace than the header's.
std::string qualifier(const std::string& declared, const Context& context) {
  const model::Header* const header = context.lookup.headerOf(declared);
  const bool here = header == nullptr || header->cxxNamespace == context.header.cxxNamespace;
  return here ? "" : header->cxxNamespace + "::";
}

/// Number of elements of its wire list or text.
std::string lengthOf(const Type& type, const std::string& slot) {
  switch (type.shape) {
    case Shape::Array: return std::to_string(type.rows);
    case Shape::Matrix: return std::to_string(type.rows * type.columns);
    case Shape::Quaternion: return "4";
    case Shape::Isometry: return "12";
    default: return slot + ".size";
  }
}

/// Where a value goes: a field of a struct builder, or element i of a list builder.
class Target {
 public:
  static Target field(const std::string& out, const std::string& wireName) {
    const std::string title = model::titleCase(wireName);
    return {out + ".set" + title + "(", out + ".init" + title + "(", out + ".init" + title + "()"};
  }
  static Target element(const std::string& list, const std::string& i) {
    return {list + ".set(" + i + ", ", list + ".init(" + i + ", ", list + "[" + i + "]"};
  }

  std::string set(const std::string& value) const { return set_ + value + ")"; }
  std::string init(const std::string& size) const { return init_ + size + ")"; }
  const std::string& record() const { return record_; }

 private:
  Target(std::string set, std::string init, std::string record)
      : set_(std::move(set)), init_(std::move(init)), record_(std::move(record)) {}

  std::string set_, init_, record_;
};

std::string encodeInto(const Type& type, const std::string& slot, const Target& target,
                       const Context& context, unsigned depth) {
  if (isRecord(type)) return "toWire(" + slot + ", " + kBreak + target.record() + ")";
  if (type.shape == Shape::Enum) {
    return target.set(enumEncoder(type.name, context) + "(" + slot + ")");
  }
  if (isNumber(type)) {
    const bool isBool = type.shape == Shape::Scalar && type.scalar == model::Scalar::Bool;
    return target.set(isBool ? slot + " != 0" : slot);
  }
  const std::string list = target.init(lengthOf(type, slot));
  if (!isSequence(type) || isPlainSequence(type)) {
    return "toWire(" + slot + ", " + kBreak + list + ")";
  }
  const std::string item = "element" + depthSuffix(depth);
  const std::string inner = "list" + depthSuffix(depth);
  const std::string index = "i" + depthSuffix(depth);
  const std::string statement =
      encodeInto(type.element.front(), item, Target::element(inner, index), context, depth + 1);
  return "toWireList(" + slot + ", " + kBreak + list + ", " + kBreak + "[](const " +
         elementSlot(type, context) + "& " + item + ", auto " + inner + ", std::uint32_t " + index +
         ") {" + lambdaBody(statement + ";") + "})";
}

/// A value is read by an assignment, which cannot fail, or by an expression of type Errc.
struct Reading {
  bool canFail;
  std::string text;
};

Reading decodeFrom(const Type& type, const std::string& in, const std::string& slot,
                   const std::string& shift, const Context& context, unsigned depth);

Reading decodeSequence(const Type& type, const std::string& in, const std::string& slot,
                       const std::string& shift, const Context& context, unsigned depth) {
  const std::string item = "item" + depthSuffix(depth);
  const std::string target = "target" + depthSuffix(depth);
  const Type& element = type.element.front();
  const Reading each = decodeFrom(element, item, target, shift, context, depth + 1);
  const std::string capture = usesShift(element) ? "[&]" : "[]";
  return {true, "fromWireList(" + in + ", " + kBreak + slot + ", " + kBreak + capture + "(auto " +
                    item + ", " + elementSlot(type, context) + "& " + target + ") {" +
                    lambdaBody("return " + each.text + (each.canFail ? ";" : ", Errc{};")) + "})"};
}

Reading decodeFrom(const Type& type, const std::string& in, const std::string& slot,
                   const std::string& shift, const Context& context, unsigned depth) {
  const std::string both = "fromWire(" + in + ", " + slot;
  if (isSteady(type)) return {false, slot + " = suture::rpc::shifted(" + in + ", " + shift + ")"};
  if (isNumber(type)) return {false, slot + " = " + in};
  if (type.shape == Shape::Struct) return {true, both + ", " + shift + ")"};
  if (type.shape == Shape::Enum) return {true, qualifier(type.name, context) + both + ")"};
  const bool whole =
      !isSequence(type) || (isPlainSequence(type) && !isSteady(type.element.front()));
  return whole ? Reading{true, both + ")"} : decodeSequence(type, in, slot, shift, context, depth);
}

/// A missing struct reads as zeros, which is no pose: it must be there.
std::string guarded(const WireValue& value, const std::string& in, const std::string& expression) {
  if (!isRecord(value.type)) return expression;
  return in + ".has" + model::titleCase(value.wireName) + "() " + kBreak + "? " + expression + " " +
         kBreak + ": Errc::Invalid";
}

}  // namespace

std::string depthSuffix(unsigned depth) { return depth == 0 ? "" : std::to_string(depth + 1); }

std::string lambdaBody(const std::string& statements) {
  return std::string(1, kBody) + statements + kBodyEnd;
}

std::string enumEncoder(const std::string& enumName, const Context& context) {
  return qualifier(enumName, context) + "wire" + model::unqualified(enumName);
}

std::vector<WireValue> payloadValues(const model::Event& event) {
  std::vector<WireValue> values;
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    values.push_back(
        {event.payload[i], lock::payloadName(i), payloadMember(event, "slot", i), std::nullopt});
  }
  return values;
}

std::string encode(const WireValue& value, const std::string& out, const Context& context) {
  return encodeInto(value.type, value.slot, Target::field(out, value.wireName), context, 0);
}

namespace {

/// Writes the assignments; returns the expressions that may fail.
std::vector<std::string> emitAssignments(Code& code, const std::vector<WireValue>& values,
                                         const std::string& in, const std::string& shift,
                                         const Context& context) {
  std::vector<std::string> checks;
  for (const WireValue& value : values) {
    const std::string source = in + ".get" + model::titleCase(value.wireName) + "()";
    const Reading reading = decodeFrom(value.type, source, value.slot, shift, context, 0);
    if (reading.canFail) {
      checks.push_back(guarded(value, in, reading.text));
    } else {
      code.line(reading.text, ";");
    }
  }
  return checks;
}

void emitChecks(Code& code, const char* beginning, const std::vector<std::string>& checks) {
  if (checks.empty()) {
    code.line(beginning, "Errc{};");
  } else if (checks.size() == 1) {
    code.line(beginning, checks.front(), ";");
  } else {
    code.line(beginning, "firstError({");
    for (const std::string& check : checks) code.line("    ", check, ",");
    code.line("});");
  }
}

}  // namespace

void emitDecodeAndReturn(Code& code, const std::vector<WireValue>& values, const std::string& in,
                         const std::string& shift, const Context& context) {
  emitChecks(code, "return ", emitAssignments(code, values, in, shift, context));
}

std::string emitDecode(Code& code, const std::vector<WireValue>& values, const std::string& in,
                       const std::string& shift, const Context& context) {
  const std::vector<std::string> checks = emitAssignments(code, values, in, shift, context);
  if (checks.empty()) return "Errc{}";
  if (checks.size() == 1) return checks.front();
  emitChecks(code, "const Errc error = ", checks);
  return "error";
}

void emitError(Code& code, const std::string& outcome) {
  if (outcome == "error") return;
  if (outcome.find(kBody) != std::string::npos) {
    code.line("const Errc error = ", outcome, ";");
    return;
  }
  std::string whole;
  std::copy_if(outcome.begin(), outcome.end(), std::back_inserter(whole),
               [](char c) { return c != kBreak; });
  code.line("const Errc error = ", kBreakText, whole, ";");
}

bool usesShift(const Type& type) {
  if (type.shape == Shape::Struct || isSteady(type)) return true;
  return !type.element.empty() && usesShift(type.element.front());
}

}  // namespace suture::compiler::emit
