#include "compiler/emit/cpp/stamps.h"

#include <algorithm>
#include <set>

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

bool isStamp(const Type& type) {
  return type.shape == Shape::TimePoint && type.clock == model::Clock::Steady;
}

/// Looks for stamps in whatever a type holds, in each struct once.
class Stamps {
 public:
  explicit Stamps(const model::Lookup& lookup) : lookup_(lookup) {}

  bool areIn(const Type& type) {
    if (isStamp(type)) return true;
    if (type.shape == Shape::Struct) return areInStruct(type.name);
    return std::any_of(type.element.begin(), type.element.end(),
                       [this](const Type& element) { return areIn(element); });
  }

 private:
  bool areInStruct(const std::string& name) {
    if (!seen_.insert(name).second) return false;  // a first one would have ended the search
    const auto& fields = lookup_.findStruct(name)->fields;
    return std::any_of(fields.begin(), fields.end(),
                       [this](const model::Field& field) { return areIn(field.type); });
  }

  const model::Lookup& lookup_;
  std::set<std::string> seen_;
};

/// Spells the signature for a source, which says "using suture::Duration".
std::string signature(const std::string& function, const std::string& slot) {
  return "void " + function + "(" + slot + "& slot, " + kBreak + "suture::Duration shift)";
}

bool needsOneStatement(const Type& type) {
  return type.shape == Shape::TimePoint || type.shape == Shape::Struct;
}

std::string statement(const Type& type, const std::string& slot) {
  if (isStamp(type)) return slot + " = suture::codec::shifted(" + slot + ", shift);";
  return "shiftStamps(" + slot + ", shift);";
}

class ShiftEmitter {
 public:
  ShiftEmitter(Code& code, const Context& context) : code_(code), context_(context) {}

  void emit(const Type& type, const std::string& slot, unsigned depth = 0) {
    if (!hasStamps(type, context_.lookup)) return;
    switch (type.shape) {
      case Shape::TimePoint:
      case Shape::Struct: code_.line(statement(type, slot)); break;
      case Shape::Array: emitEach(type, slot, depth); break;
      case Shape::List:
      case Shape::Map: emitEach(type, "suture::elementsIn(" + slot + ")", depth); break;
      case Shape::Optional:
        code_.open("if (", slot, ".present != 0) {");
        emit(type.element.front(), slot + ".value", depth);
        code_.close("}");
        break;
      case Shape::Tuple:
        for (std::size_t i = 0; i < type.element.size(); ++i) {
          emit(type.element[i], "suture::item<" + std::to_string(i) + ">(" + slot + ")", depth);
        }
        break;
      case Shape::Variant: emitAlternatives(type, slot, depth); break;
      default: break;  // numbers and texts hold no stamp
    }
  }

 private:
  void emitEach(const Type& type, const std::string& range, unsigned depth) {
    const std::string element = "element" + depthSuffix(depth);
    code_.open("for (auto& ", element, " : ", range, ") {");
    if (type.shape == Shape::Map) {
      emit(type.element.front(), element + ".key", depth + 1);
      emit(type.element.back(), element + ".value", depth + 1);
    } else {
      emit(type.element.front(), element, depth + 1);
    }
    code_.close("}");
  }

  void emitAlternatives(const Type& type, const std::string& slot, unsigned depth) {
    for (std::size_t i = 0; i < type.element.size(); ++i) {
      if (!hasStamps(type.element[i], context_.lookup)) continue;
      const std::string index = std::to_string(i);
      code_.open("if (", slot, ".index == ", index, ") {");
      emit(type.element[i], "suture::alternative<" + index + ">(" + slot + ")", depth);
      code_.close("}");
    }
  }

  Code& code_;
  const Context& context_;
};

/// Emits the function; `stamped` are the values that have stamps.
void emitFunction(Code& code, const std::string& signature, const std::vector<WireValue>& stamped,
                  const Context& context) {
  const WireValue& first = stamped.front();
  if (stamped.size() == 1 && needsOneStatement(first.type)) {
    code.function(signature, statement(first.type, first.slot)).blank();
    return;
  }
  code.open(signature, " {");
  for (const WireValue& one : stamped) ShiftEmitter(code, context).emit(one.type, one.slot);
  code.close("}").blank();
}

}  // namespace

bool hasStamps(const Type& type, const model::Lookup& lookup) {
  return isBounded(type, lookup) && Stamps(lookup).areIn(type);
}

bool hasStamps(const std::vector<WireValue>& values, const model::Lookup& lookup) {
  const bool bounded = std::all_of(values.begin(), values.end(), [&](const WireValue& value) {
    return isBounded(value.type, lookup);
  });
  return bounded && std::any_of(values.begin(), values.end(), [&](const WireValue& value) {
           return Stamps(lookup).areIn(value.type);
         });
}

void declareShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
                  const Context& context) {
  if (!hasStamps(values, context.lookup)) return;
  code.line("void shiftStamps(", slot, "& slot, ", std::string(1, kBreak),
            "suture::Duration shift);");
}

void emitShift(Code& code, const std::vector<WireValue>& values, const std::string& slot,
               const Context& context) {
  if (!hasStamps(values, context.lookup)) return;
  std::vector<WireValue> stamped;
  for (const WireValue& value : values) {
    if (hasStamps(value.type, context.lookup)) stamped.push_back(value);
  }
  emitFunction(code, signature("shiftStamps", slot), stamped, context);
}

std::string shiftOf(const std::string& slot, const std::vector<WireValue>& values,
                    const Context& context) {
  return hasStamps(values, context.lookup) ? "suture::shiftSlot<" + slot + ">" : "";
}

std::string emitShiftOf(Code& code, const Type& type, const std::string& name,
                        const Context& context) {
  if (!hasStamps(type, context.lookup)) return "";
  const std::string slot = slotType(type, context, context.header.cxxNamespace);
  if (type.shape == Shape::Struct) return "suture::shiftSlot<" + slot + ">";
  emitFunction(code, signature(name, slot), {{type, "", "slot", {}}}, context);
  return "suture::shiftSlot<" + slot + ", " + name + ">";
}

}  // namespace suture::compiler::emit
