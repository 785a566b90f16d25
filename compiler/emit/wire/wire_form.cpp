#include "compiler/emit/wire/wire_form.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>

#include "compiler/emit/text/contract.h"
#include "compiler/lock/schema/composites.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

bool isSequence(const Type& type) {
  return type.shape == Shape::List || type.shape == Shape::Array || type.shape == Shape::Map;
}

/// Returns true if the type travels as a capnp struct of its own.
bool isRecord(const Type& type) {
  const bool composite = lock::isComposite(type) && type.shape != Shape::Map;
  return type.shape == Shape::Struct || composite || !lock::namedEigenType(type).empty();
}

/// Returns true if generated code has a fromWire() for the type, which takes the shift.
bool isGenerated(const Type& type) {
  return type.shape == Shape::Struct || type.shape == Shape::Optional ||
         type.shape == Shape::Tuple || type.shape == Shape::Variant;
}

/// Returns true if the type travels as one number.
bool isNumber(const Type& type) {
  return type.shape == Shape::Scalar || type.shape == Shape::Duration ||
         type.shape == Shape::TimePoint;
}

bool isSteady(const Type& type) {
  return type.shape == Shape::TimePoint && type.clock == model::Clock::Steady;
}

/// Returns true for a sequence that one overload of the runtime's toWire() converts as a whole.
bool isPlainSequence(const Type& type) {
  if (type.shape == Shape::Map) return false;
  const Type& element = type.element.front();
  return isNumber(element) || (type.shape == Shape::List && element.shape == Shape::Text);
}

/// Returns the type of a lambda's parameter; that of a composite is long, and its place says what
/// it is.
std::string elementSlot(const Type& type, const Context& context) {
  const bool composite = type.shape == Shape::Map || lock::isComposite(type.element.front());
  return composite ? "auto" : elementSlot(type, context, context.header.cxxNamespace);
}

/// Returns the number of elements of its wire list or text.
std::string lengthOf(const Type& type, const std::string& slot) {
  switch (type.shape) {
    case Shape::Array: return std::to_string(type.rows);
    case Shape::Matrix: return std::to_string(type.rows * type.columns);
    case Shape::Quaternion: return "4";
    case Shape::Isometry: return "12";
    default: break;
  }
  const std::string size = "sizeOf(" + slot + ")";  // the bytes of a slot may be wrong
  if (!lock::isFlatList(type)) return size;
  return size + " * " + std::to_string(type.element.front().rows);
}

/// Returns how many bytes a number has where the wire has them as one block; "" elsewhere.
std::string bulkFactor(const Type& type) {
  const model::Scalar scalar = type.element.empty() ? type.scalar : type.element[0].scalar;
  const bool bytes = scalar == model::Scalar::UInt8 || scalar == model::Scalar::Int8;
  return type.bulk && !bytes ? " * sizeof(" + cxxScalar(scalar) + ")" : "";
}

/// A Target is where a value goes: a field of a struct builder, or element i of a list builder.
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
                       const Context& context, unsigned depth);

/// Returns what turns one element of a sequence into its wire form.
std::string encodeElement(const Type& type, const std::string& slot, const Target& target,
                          const Context& context, unsigned depth) {
  if (type.shape == Shape::Map) return "toWire(" + slot + ", " + kBreak + target.record() + ")";
  return encodeInto(type.element.front(), slot, target, context, depth);
}

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
  if (type.shape == Shape::Nothing) return target.set("");
  const std::string list = target.init(lengthOf(type, slot) + bulkFactor(type));
  if (lock::isFlatList(type))
    return "suture::codec::toWireFlat(" + slot + ", " + kBreak + list + ")";
  if (!isSequence(type) || isPlainSequence(type)) {
    return "toWire(" + slot + ", " + kBreak + list + ")";
  }
  const std::string item = "element" + depthSuffix(depth);
  const std::string inner = "list" + depthSuffix(depth);
  const std::string index = "i" + depthSuffix(depth);
  const std::string statement =
      encodeElement(type, item, Target::element(inner, index), context, depth + 1);
  return "suture::codec::toWireList(" + slot + ", " + kBreak + list + ", " + kBreak + "[](const " +
         elementSlot(type, context) + "& " + item + ", auto " + inner + ", std::uint32_t " + index +
         ") {" + lambdaBody(statement + ";") + "})";
}

/// A Reading is an assignment, which cannot fail, or an expression of type Errc: either reads a
/// value.
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
  const bool map = type.shape == Shape::Map;
  const Type& element = type.element.front();
  const Reading each = map ? Reading{true, "fromWire(" + item + ", " + target + ", " + shift + ")"}
                           : decodeFrom(element, item, target, shift, context, depth + 1);
  const std::string capture = map || usesShift(element) ? "[&]" : "[]";
  const std::string function =
      map || type.distinct ? "suture::codec::fromWireDistinct(" : "suture::codec::fromWireList(";
  return {true, function + in + ", " + kBreak + slot + ", " + kBreak + capture + "(auto " + item +
                    ", " + elementSlot(type, context) + "& " + target + ") {" +
                    lambdaBody("return " + each.text + (each.canFail ? ";" : ", suture::Errc{};")) +
                    "})"};
}

Reading decodeFrom(const Type& type, const std::string& in, const std::string& slot,
                   const std::string& shift, const Context& context, unsigned depth) {
  const std::string both = "fromWire(" + in + ", " + slot;
  if (isSteady(type)) return {false, slot + " = suture::codec::shifted(" + in + ", " + shift + ")"};
  if (isNumber(type)) return {false, slot + " = " + in};
  if (isGenerated(type)) return {true, both + ", " + shift + ")"};
  if (lock::isFlatList(type))
    return {true, "suture::codec::fromWireFlat(" + in + ", " + slot + ")"};
  if (type.shape == Shape::Affine) {
    return {true, "suture::codec::fromWireAffine(" + in + ", " + slot + ")"};
  }
  if (type.shape == Shape::Enum) return {true, qualifier(type.name, context) + both + ")"};
  const bool whole = !isSequence(type) ||
                     (isPlainSequence(type) && !type.distinct && !isSteady(type.element.front()));
  return whole ? Reading{true, both + ")"} : decodeSequence(type, in, slot, shift, context, depth);
}

/// Returns true if an older sender leaves its wire form out; for one number the schema has the
/// default.
bool canBeMissing(const Type& type) {
  return !isNumber(type) && type.shape != Shape::Enum && type.shape != Shape::Nothing;
}

/// Returns true if it reads as a value although nothing was sent.
bool wouldBeMadeUp(const Type& type) {
  if (type.shape == Shape::Array || type.shape == Shape::Matrix) return true;
  return isRecord(type) && type.shape != Shape::Optional && type.shape != Shape::AnyMatrix;
}

/// Asks if the value was sent, or was not. No array is empty, so an empty list says nothing.
std::string whether(bool sent, const WireValue& value, const std::string& in) {
  const bool isList = value.type.shape == Shape::Array ||
                      (value.type.shape == Shape::Matrix && !isRecord(value.type));
  const std::string name = model::titleCase(value.wireName);
  if (isList) return in + ".get" + name + "().size() " + (sent ? "!=" : "==") + " 0";
  return (sent ? "" : "!") + in + ".has" + name + "()";
}

/// Reads it by `expression` where it was sent.
std::string ifSent(const WireValue& value, const std::string& in, const std::string& expression) {
  const std::string sent = whether(true, value, in);
  const auto choice = [](const std::string& asked, const std::string& yes, const std::string& no) {
    return asked + " " + kBreak + "? " + yes + " " + kBreak + ": " + no;
  };
  if (value.isNeeded && wouldBeMadeUp(value.type))
    return choice(sent, expression, "suture::Errc::Invalid");
  if (value.preset.empty()) return expression;
  const std::string preset = "suture::codec::fromDefault(" + value.preset + ", " + value.slot + ")";
  const bool isLong = expression.find(kBody) != std::string::npos;
  return isLong ? choice(whether(false, value, in), preset, expression)
                : choice(sent, expression, preset);
}

}  // namespace

std::string depthSuffix(unsigned depth) { return depth == 0 ? "" : std::to_string(depth + 1); }

std::string lambdaBody(const std::string& statements) {
  return std::string(1, kBody) + statements + kBodyEnd;
}

std::string enumEncoder(const std::string& enumName, const Context& context) {
  return qualifier(enumName, context) + "wire" +
         model::unqualified(generatedName(enumName, context.lookup));
}

namespace {

/// Admits infinity where that is the default, since it then says something.
std::optional<std::pair<double, double>> admitted(const model::Field& field) {
  const bool infinite = field.defaultJson == "\"inf\"" || field.defaultJson == "\"-inf\"";
  if (field.range || !infinite || !isNumber(field.type)) return field.range;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return std::pair{-kInfinity, kInfinity};
}

/// Tells if an enum has a zero that is not the one on the wire, the enumerator which the lock has
/// first.
bool hasOtherZero(const model::Enum& type, const Context& context) {
  const auto zero = std::find_if(type.enumerators.begin(), type.enumerators.end(),
                                 [](const model::Enumerator& one) { return one.value == 0; });
  if (zero == type.enumerators.end()) return false;
  const std::string path = lock::lockPath(context.lookup.headerOf(type.name)->path);
  const lock::Node* const node = context.schemas.at(path).ofContract("cxx", type.name);
  return node->members.front().name != zero->wireName;
}

/// Tells if C++ makes of nothing another value than a message in which nothing was sent.
bool readsOtherwise(const Type& type, const Context& context) {
  const auto reads = [&](const Type& element) { return readsOtherwise(element, context); };
  switch (type.shape) {
    case Shape::Enum: return hasOtherZero(*context.lookup.findEnum(type.name), context);
    case Shape::Array:
    case Shape::Tuple: return std::any_of(type.element.begin(), type.element.end(), reads);
    case Shape::Variant: return reads(type.element.front());
    default: return false;
  }
}

}  // namespace

std::vector<WireValue> fieldValues(const model::Struct& type, const Context& context) {
  const std::string& home = context.header.cxxNamespace;
  const std::string fresh = relative(type.name, home) + "()";
  std::vector<WireValue> values;
  for (const model::Field& field : type.fields) {
    const bool preset =
        canBeMissing(field.type) && (field.isPreset || readsOtherwise(field.type, context));
    values.push_back({.type = field.type,
                      .wireName = field.wireName,
                      .slot = "slot." + field.name,
                      .range = admitted(field),
                      .preset = preset ? access(type, field, fresh, true, home) : "",
                      .member = field.isBase ? "" : field.name});
  }
  return values;
}

std::vector<WireValue> argumentValues(const model::Command& command) {
  std::vector<WireValue> values;
  for (const model::Parameter& one : command.parameters) {
    values.push_back({.type = one.type,
                      .wireName = one.wireName,
                      .slot = "slot." + one.name,
                      .range = one.range,
                      .member = one.name});
  }
  return values;
}

std::vector<WireValue> resultValues(const model::Command& command) {
  return {{.type = *command.result,
           .wireName = "value",
           .slot = "slot",
           .range = command.resultRange,
           .isNeeded = true}};
}

std::vector<WireValue> payloadValues(const model::Event& event) {
  std::vector<WireValue> values;
  const bool several = event.payload.size() > 1;
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const auto range = i < event.limits.size() ? event.limits[i].range : std::nullopt;
    values.push_back({.type = event.payload[i],
                      .wireName = lock::payloadName(i),
                      .slot = payloadMember(event, "slot", i),
                      .range = range,
                      .isNeeded = true,
                      .member = several ? lock::payloadName(i) : ""});
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
    if (value.type.shape == Shape::Nothing) continue;
    const std::string source = in + ".get" + model::titleCase(value.wireName) + "()";
    const Reading reading = decodeFrom(value.type, source, value.slot, shift, context, 0);
    if (reading.canFail) {
      checks.push_back(ifSent(value, in, reading.text));
    } else {
      code.line(reading.text, ";");
    }
  }
  return checks;
}

void emitChecks(Code& code, const char* beginning, const std::vector<std::string>& checks) {
  if (checks.empty()) {
    code.line(beginning, "suture::Errc{};");
  } else if (checks.size() == 1) {
    code.line(beginning, checks.front(), ";");
  } else {
    code.line(beginning, "suture::codec::firstError({");
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
  if (checks.empty()) return "suture::Errc{}";
  if (checks.size() == 1) return checks.front();
  emitChecks(code, "const suture::Errc error = ", checks);
  return "error";
}

void emitError(Code& code, const std::string& outcome) {
  if (outcome == "error") return;
  if (outcome.find(kBody) != std::string::npos) {
    code.line("const suture::Errc error = ", outcome, ";");
    return;
  }
  std::string whole;
  std::copy_if(outcome.begin(), outcome.end(), std::back_inserter(whole),
               [](char c) { return c != kBreak; });
  code.line("const suture::Errc error = ", kBreakText, whole, ";");
}

bool usesShift(const Type& type) {
  if (isGenerated(type) || type.shape == Shape::Map || isSteady(type)) return true;
  return !type.element.empty() && usesShift(type.element.front());
}

}  // namespace suture::compiler::emit
