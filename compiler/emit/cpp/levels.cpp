#include "compiler/emit/cpp/levels.h"

#include <algorithm>

#include "compiler/model/flat_size.h"

namespace suture::compiler::emit {
namespace {

using model::Type;
using Shape = Type::Shape;

// A slot below this size is copied as a whole, because to find its used part would cost more.
constexpr std::uint64_t kSmall = 256;

/// Finds the levels of which only the used part is copied: those that lie in no other level, no
/// array and no variant. An array has a level for each element, and what a variant holds depends on
/// the value, so both are copied as a whole.
class Levels {
 public:
  Levels(std::string slot, const Context& context) : slot_(std::move(slot)), context_(context) {}

  /// Adds the levels of the value that the members of `path` lead to; "" leads to the slot itself.
  void find(const Type& type, const std::string& path) {
    if (model::flatSize(type, context_.lookup) <= kSmall) return;
    switch (type.shape) {
      case Shape::Text:
      case Shape::List:
      case Shape::Map:
      case Shape::AnyMatrix: return add(type, path);
      case Shape::Struct:
        for (const model::Field& field : context_.lookup.findStruct(type.name)->fields) {
          find(field.type, within(path, field.name));
        }
        return;
      case Shape::Optional: return find(type.element.front(), within(path, "value"));
      case Shape::Tuple: return findItems(type, path);
      default: return;
    }
  }

  const std::vector<std::string>& entries() const { return entries_; }

 private:
  static std::string within(const std::string& path, const std::string& member) {
    return path.empty() ? member : path + "." + member;
  }

  void findItems(const Type& type, std::string path) {
    for (const Type& item : type.element) {
      find(item, within(path, "head"));
      path = within(path, "tail");
    }
  }

  void add(const Type& type, const std::string& path) {
    const std::string place =
        path.empty() ? "0" : std::string("offsetof(") + slot_ + ", " + kBreak + path + ")";
    entries_.push_back("suture::levelAt<" + slotType(type, context_, context_.header.cxxNamespace) +
                       ">(" + kBreak + place + "),");
  }

  const std::string slot_;
  const Context& context_;
  std::vector<std::string> entries_;
};

/// Turns "slot.goal" into "goal", and "slot" into "".
std::string memberPath(const std::string& lvalue) {
  const auto dot = lvalue.find('.');
  return dot == std::string::npos ? "" : lvalue.substr(dot + 1);
}

}  // namespace

std::string emitLevels(Code& code, const std::string& name, const std::string& slot,
                       const std::vector<WireValue>& values, const Context& context) {
  if (!std::all_of(values.begin(), values.end(),
                   [&](const WireValue& value) { return isBounded(value.type, context.lookup); })) {
    return "";
  }
  Levels levels(slot, context);
  for (const WireValue& value : values) levels.find(value.type, memberPath(value.slot));
  if (levels.entries().empty()) return "";
  code.open("constexpr suture::BoundedLevel ", name, "[] = {");
  for (const std::string& entry : levels.entries()) code.line("  ", entry);
  code.close("};").blank();
  return name;
}

}  // namespace suture::compiler::emit
