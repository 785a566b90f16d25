#include "compiler/frontend/template_types.h"

#include <array>
#include <map>

#include "compiler/frontend/annotation.h"
#include "compiler/frontend/eigen_types.h"
#include "compiler/frontend/names.h"
#include "compiler/frontend/time_types.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;
using Shape = model::Type::Shape;

clang::QualType typeArgument(const Specialisation* type, unsigned index) {
  return type->getTemplateArgs()[index].getAsType().getCanonicalType();
}

bool hasStandardAllocator(const Specialisation* type, unsigned index) {
  const auto* allocator = typeArgument(type, index)->getAsCXXRecordDecl();
  return allocator && qualifiedName(allocator) == "std::allocator";
}

MappedType mapString(const Specialisation* type) {
  if (!typeArgument(type, 0)->isSpecificBuiltinType(clang::BuiltinType::Char_S) ||
      !hasStandardAllocator(type, 2)) {
    return TypeProblem{"unsupported-type", "only std::string has a wire form", "use std::string"};
  }
  model::Type mapped;
  mapped.shape = Shape::Text;
  mapped.spelling = "std::string";
  return mapped;
}

MappedType withElement(model::Type outer, clang::QualType elementType,
                       const clang::ASTContext& context) {
  MappedType element = mapType(elementType);
  if (auto* problem = std::get_if<TypeProblem>(&element)) {
    problem->reason = "element of type '" + spelled(elementType, context) + "': " + problem->reason;
    return element;
  }
  outer.element.push_back(std::get<model::Type>(std::move(element)));
  return outer;
}

MappedType mapVector(const Specialisation* type) {
  if (!hasStandardAllocator(type, 1)) {
    return TypeProblem{"unsupported-type", "its allocator cannot be rebuilt by a receiver",
                       "use std::vector with the default allocator"};
  }
  model::Type list;
  list.shape = Shape::List;
  MappedType mapped = withElement(list, typeArgument(type, 0), type->getASTContext());
  if (auto* done = std::get_if<model::Type>(&mapped)) {
    done->spelling = "std::vector<" + done->element.front().spelling + ">";
  }
  return mapped;
}

constexpr std::uint64_t kLongestArray = 1u << 20;

MappedType mapArray(const Specialisation* type) {
  const std::uint64_t length = type->getTemplateArgs()[1].getAsIntegral().getZExtValue();
  if (length == 0 || length > kLongestArray) {
    return TypeProblem{"array-length",
                       "its length " + std::to_string(length) + " is not between 1 and " +
                           std::to_string(kLongestArray),
                       "use std::vector with capacity() for what may be empty"};
  }
  model::Type array;
  array.shape = Shape::Array;
  array.rows = static_cast<unsigned>(length);
  MappedType mapped = withElement(array, typeArgument(type, 0), type->getASTContext());
  if (auto* done = std::get_if<model::Type>(&mapped)) {
    done->spelling =
        "std::array<" + done->element.front().spelling + ", " + std::to_string(length) + ">";
  }
  return mapped;
}

// What users reach for first and why it cannot be: better than "no wire form".
const TypeProblem* knownProblem(const std::string& name) {
  static const std::map<std::string, TypeProblem> kProblems = [] {
    std::map<std::string, TypeProblem> table;
    for (const char* view : {"std::basic_string_view", "std::span"}) {
      table[view] = {"view", "a view would dangle at the receiver",
                     "use an owning type: std::string or std::vector"};
    }
    for (const char* pointer : {"std::shared_ptr", "std::unique_ptr", "std::weak_ptr"}) {
      table[pointer] = {"pointer", "ownership of a pointer cannot cross a wire",
                        "store the value itself, or a std::vector of it"};
    }
    for (const char* container : {"std::map", "std::unordered_map", "std::set", "std::deque",
                                  "std::list", "std::unordered_set"}) {
      table[container] = {"unsupported-type", "this container is not supported yet",
                          "use std::vector, of a struct with key and value for a map"};
    }
    table["std::optional"] = {"unsupported-type", "std::optional is not supported yet",
                              "add a bool field that says whether the value counts"};
    table["std::variant"] = {"unsupported-type", "std::variant is not supported yet",
                             "use an enum class beside one field per alternative"};
    table["std::function"] = {"unsupported-type", "code cannot cross a wire",
                              "declare a command or an event"};
    return table;
  }();
  const auto found = kProblems.find(name);
  return found == kProblems.end() ? nullptr : &found->second;
}

}  // namespace

MappedType mapTemplate(const Specialisation* type) {
  using Handler = MappedType (*)(const Specialisation*);
  static const std::map<std::string, Handler> kHandlers{
      {"std::basic_string", mapString},
      {"std::vector", mapVector},
      {"std::array", mapArray},
      {"std::chrono::duration", mapDuration},
      {"std::chrono::time_point", mapTimePoint},
      {"Eigen::Matrix", mapMatrix},
      {"Eigen::Quaternion", mapQuaternion},
      {"Eigen::Transform", mapTransform},
  };
  const std::string name = qualifiedName(type->getSpecializedTemplate());
  if (const auto handler = kHandlers.find(name); handler != kHandlers.end()) {
    return handler->second(type);
  }
  if (const TypeProblem* problem = knownProblem(name)) return *problem;
  if (isAnnotated(type->getSpecializedTemplate()->getTemplatedDecl(), Kind::Type)) {
    return TypeProblem{"template-type", "instances of an annotated template are not supported yet",
                       "write the struct out", type->getSpecializedTemplate()};
  }
  return noWireForm();
}

}  // namespace suture::compiler::frontend
