#include "compiler/frontend/types/container_types.h"

#include "compiler/frontend/ast/copies.h"
#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

using Shape = model::Type::Shape;

constexpr std::uint64_t kLongestArray = 1u << 20;

std::string spelledPlainly(clang::QualType type) {
  clang::LangOptions language;
  language.CPlusPlus = language.Bool = true;
  return type.getAsString(clang::PrintingPolicy(language));
}

/// Returns the argument if it is an instance of the template `name`, else null.
const Specialisation* instanceOf(const char* name, const Specialisation* type, unsigned index) {
  const auto* record = typeArgument(type, index)->getAsCXXRecordDecl();
  const bool isIt = record && qualifiedName(record) == name;
  return isIt ? llvm::dyn_cast<Specialisation>(record) : nullptr;
}

/// Tells if the argument is `name<of>`, which is its default.
bool isDefault(const Specialisation* type, unsigned index, const char* name, clang::QualType of) {
  const Specialisation* const argument = instanceOf(name, type, index);
  return argument && typeArgument(argument, 0) == of;
}

/// Tells if the order is std::less<>, which orders as the default does, and lets a key be found by
/// what only compares with it.
bool isTransparent(const Specialisation* type, unsigned index) {
  const Specialisation* const argument = instanceOf("std::less", type, index);
  return argument && typeArgument(argument, 0)->isVoidType();
}

/// An allocator of anything else is an error of the container itself.
bool isAllocator(const Specialisation* type, unsigned index) {
  return instanceOf("std::allocator", type, index) != nullptr;
}

TypeProblem notDefault(const std::string& what, const std::string& name) {
  return {"unsupported-type", "its " + what + " cannot be rebuilt by a receiver",
          "use " + name + " with the default " + what};
}

std::string templateName(const Specialisation* type) {
  return qualifiedName(type->getSpecializedTemplate());
}

/// Returns the name with its elements, "std::map<std::string, double>", and `more` behind them.
std::string spellingOf(const Specialisation* type, const model::Type& mapped,
                       const std::string& more = "") {
  std::string arguments;
  for (const model::Type& element : mapped.element) {
    arguments += (arguments.empty() ? "" : ", ") + element.spelling;
  }
  return templateName(type) + "<" + arguments + more + ">";
}

MappedType withElements(const Specialisation* type, model::Type outer,
                        const std::vector<clang::QualType>& elements, const NamedTypes& names) {
  for (const clang::QualType element : elements) {
    if (auto problem = addElement(outer, element, names)) return *problem;
  }
  outer.spelling = spellingOf(type, outer);
  return outer;
}

model::Type ofShape(Shape shape) {
  model::Type type;
  type.shape = shape;
  return type;
}

/// Tells if the type can be a key: receivers look keys up, so equal must mean equal.
bool isKey(const model::Type& type) {
  const bool real = type.scalar == model::Scalar::Float32 || type.scalar == model::Scalar::Float64;
  return type.shape == Shape::Text || type.shape == Shape::Enum ||
         (type.shape == Shape::Scalar && !real);
}

bool isPlainChar(clang::QualType type) {
  return type->isSpecificBuiltinType(clang::BuiltinType::Char_S) ||
         type->isSpecificBuiltinType(clang::BuiltinType::Char_U);
}

MappedType withKey(const Specialisation* type, Shape shape,
                   const std::vector<clang::QualType>& elements, const NamedTypes& names) {
  const auto count = static_cast<unsigned>(elements.size());
  const clang::QualType key = elements.front();
  const bool hashed = llvm::StringRef(templateName(type)).starts_with("std::unordered");
  const bool transparent = !hashed && isTransparent(type, count);
  const bool order = hashed ? isDefault(type, count, "std::hash", key) &&
                                  isDefault(type, count + 1, "std::equal_to", key)
                            : transparent || isDefault(type, count, "std::less", key);
  if (!order) return notDefault("order", templateName(type));
  if (!isAllocator(type, count + (hashed ? 2 : 1))) {
    return notDefault("allocator", templateName(type));
  }
  if (isPlainChar(key) && names.isForeign()) {
    return TypeProblem{"map-key", "'char' keys have another order on other machines",
                       "use std::int8_t"};
  }
  MappedType mapped = withElements(type, ofShape(shape), elements, names);
  if (auto* done = std::get_if<model::Type>(&mapped)) {
    done->distinct = shape == Shape::List;
    if (transparent) done->spelling = spellingOf(type, *done, ", std::less<>");
    if (!isKey(done->element.front())) {
      return TypeProblem{
          "map-key", "'" + done->element.front().spelling + "' is no key that is compared exactly",
          "use an integer, an enum or std::string, or a std::vector for the whole"};
    }
  }
  return mapped;
}

bool isMonostate(clang::QualType type) {
  const auto* record = type->getAsCXXRecordDecl();
  return record && qualifiedName(record) == "std::monostate";
}

std::vector<clang::QualType> typesOf(const Specialisation* type) {
  std::vector<clang::QualType> types;
  for (const clang::TemplateArgument& argument : type->getTemplateArgs().asArray()) {
    const bool pack = argument.getKind() == clang::TemplateArgument::Pack;
    const auto all = pack ? argument.pack_elements() : llvm::ArrayRef(argument);
    for (const clang::TemplateArgument& one : all) {
      types.push_back(one.getAsType().getCanonicalType());
    }
  }
  return types;
}

}  // namespace

clang::QualType typeArgument(const Specialisation* type, unsigned index) {
  return type->getTemplateArgs()[index].getAsType().getCanonicalType();
}

std::optional<TypeProblem> addElement(model::Type& outer, clang::QualType element,
                                      const NamedTypes& names) {
  MappedType mapped = mapType(element, names);
  if (auto* problem = std::get_if<TypeProblem>(&mapped)) {
    problem->reason = "element of type '" + spelledPlainly(element) + "': " + problem->reason;
    return *problem;
  }
  outer.element.push_back(std::get<model::Type>(std::move(mapped)));
  return std::nullopt;
}

MappedType mapFixedArray(clang::QualType element, std::uint64_t length, const NamedTypes& names) {
  if (length == 0 || length > kLongestArray) {
    return TypeProblem{"array-length",
                       "its length " + std::to_string(length) + " is not between 1 and " +
                           std::to_string(kLongestArray),
                       "use std::vector with capacity() for what may be empty"};
  }
  model::Type array = ofShape(Shape::Array);
  array.rows = static_cast<unsigned>(length);
  if (auto problem = addElement(array, element, names)) return *problem;
  return array;
}

MappedType mapString(const Specialisation* type, const NamedTypes&) {
  const clang::QualType character = typeArgument(type, 0);
  if (!character->isSpecificBuiltinType(clang::BuiltinType::Char_S) ||
      !isDefault(type, 1, "std::char_traits", character) || !isAllocator(type, 2)) {
    return TypeProblem{"unsupported-type", "only std::string has a wire form", "use std::string"};
  }
  model::Type mapped = ofShape(Shape::Text);
  mapped.spelling = "std::string";
  return mapped;
}

MappedType mapSequence(const Specialisation* type, const NamedTypes& names) {
  if (!isAllocator(type, 1)) return notDefault("allocator", templateName(type));
  MappedType mapped = withElements(type, ofShape(Shape::List), {typeArgument(type, 0)}, names);
  if (std::holds_alternative<TypeProblem>(mapped)) return mapped;
  if (templateName(type) == "std::vector" &&
      !canBeMoved(typeArgument(type, 0), names.semantics())) {
    return TypeProblem{"uncopyable", "its elements can be neither copied nor moved",
                       "let them be copied, or use std::deque"};
  }
  return mapped;
}

MappedType mapArray(const Specialisation* type, const NamedTypes& names) {
  const std::uint64_t length = type->getTemplateArgs()[1].getAsIntegral().getZExtValue();
  MappedType mapped = mapFixedArray(typeArgument(type, 0), length, names);
  if (auto* done = std::get_if<model::Type>(&mapped)) {
    done->spelling =
        "std::array<" + done->element.front().spelling + ", " + std::to_string(length) + ">";
  }
  return mapped;
}

MappedType mapSet(const Specialisation* type, const NamedTypes& names) {
  return withKey(type, Shape::List, {typeArgument(type, 0)}, names);
}

MappedType mapMap(const Specialisation* type, const NamedTypes& names) {
  return withKey(type, Shape::Map, {typeArgument(type, 0), typeArgument(type, 1)}, names);
}

MappedType mapOptional(const Specialisation* type, const NamedTypes& names) {
  return withElements(type, ofShape(Shape::Optional), {typeArgument(type, 0)}, names);
}

MappedType mapUniquePointer(const Specialisation* type, const NamedTypes& names) {
  const clang::QualType held = typeArgument(type, 0);
  if (!isDefault(type, 1, "std::default_delete", held)) {
    return notDefault("deleter", "std::unique_ptr");
  }
  const auto* record = held->getAsCXXRecordDecl();
  if (record && record->hasDefinition() && record->isPolymorphic()) {
    return TypeProblem{"polymorphic", "what a base pointer points to would be cut to the base",
                       "use std::variant of the types that it may be"};
  }
  return withElements(type, ofShape(Shape::Optional), {held}, names);
}

MappedType mapTuple(const Specialisation* type, const NamedTypes& names) {
  const std::vector<clang::QualType> types = typesOf(type);
  if (types.empty()) {
    return TypeProblem{"unsupported-type", "a tuple of nothing has no wire form", "drop it"};
  }
  return withElements(type, ofShape(Shape::Tuple), types, names);
}

MappedType mapVariant(const Specialisation* type, const NamedTypes& names) {
  const std::vector<clang::QualType> types = typesOf(type);
  if (types.size() < 2) {
    return TypeProblem{"variant-size", "a variant of one alternative is no choice",
                       "use the alternative itself"};
  }
  model::Type variant = ofShape(Shape::Variant);
  for (const clang::QualType alternative : types) {
    if (isMonostate(alternative)) {
      variant.element.push_back(ofShape(Shape::Nothing));
      variant.element.back().spelling = "std::monostate";
    } else if (auto problem = addElement(variant, alternative, names)) {
      return *problem;
    }
  }
  variant.spelling = spellingOf(type, variant);
  return variant;
}

}  // namespace suture::compiler::frontend
