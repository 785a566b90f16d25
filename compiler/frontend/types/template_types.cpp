#include "compiler/frontend/types/template_types.h"

#include <map>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/container_types.h"
#include "compiler/frontend/types/eigen_types.h"
#include "compiler/frontend/types/time_types.h"

namespace suture::compiler::frontend {
namespace {

// Explains what users reach for first and cannot have, better than "no wire form" would.
const TypeProblem* knownProblem(const std::string& name) {
  static const std::map<std::string, TypeProblem> kProblems = [] {
    std::map<std::string, TypeProblem> table;
    for (const char* view : {"std::basic_string_view", "std::span"}) {
      table[view] = {"view", "a view would dangle at the receiver",
                     "use an owning type: std::string or std::vector"};
    }
    for (const char* pointer : {"std::shared_ptr", "std::weak_ptr"}) {
      table[pointer] = {"pointer", "who else holds it cannot cross a wire",
                        "store the value itself, a std::unique_ptr or a std::vector of it"};
    }
    for (const char* container :
         {"std::list", "std::forward_list", "std::multimap", "std::multiset",
          "std::unordered_multimap", "std::unordered_multiset"}) {
      table[container] = {"unsupported-type", "this container has no wire form",
                          "use std::vector, of pairs in the place of a multimap"};
    }
    table["std::function"] = {"unsupported-type", "code cannot cross a wire",
                              "declare a command or an event"};
    return table;
  }();
  const auto found = kProblems.find(name);
  return found == kProblems.end() ? nullptr : &found->second;
}

}  // namespace

MappedType mapTemplate(const Specialisation* type, const NamedTypes& names) {
  using Handler = MappedType (*)(const Specialisation*, const NamedTypes&);
  static const std::map<std::string, Handler> kHandlers{
      {"std::basic_string", mapString},
      {"std::vector", mapSequence},
      {"std::deque", mapSequence},
      {"std::array", mapArray},
      {"std::set", mapSet},
      {"std::unordered_set", mapSet},
      {"std::map", mapMap},
      {"std::unordered_map", mapMap},
      {"std::optional", mapOptional},
      {"std::unique_ptr", mapUniquePointer},
      {"std::pair", mapTuple},
      {"std::tuple", mapTuple},
      {"std::variant", mapVariant},
      {"std::chrono::duration", mapDuration},
      {"std::chrono::time_point", mapTimePoint},
      {"Eigen::Matrix", mapMatrix},
      {"Eigen::Quaternion", mapQuaternion},
      {"Eigen::Transform", mapTransform},
  };
  const std::string name = qualifiedName(type->getSpecializedTemplate());
  if (const auto handler = kHandlers.find(name); handler != kHandlers.end()) {
    return handler->second(type, names);
  }
  if (const TypeProblem* problem = knownProblem(name)) return *problem;
  const clang::ClassTemplateDecl* pattern = type->getSpecializedTemplate();
  if (isAnnotated(pattern->getTemplatedDecl(), Kind::Type)) {
    const std::string plain = pattern->getNameAsString();
    return TypeProblem{"template-type", "this instance of '" + plain + "' has no name of its own",
                       "name it for all to see: 'using My" + plain + " = " + plain + "<...>;'"};
  }
  const bool isLibrarys = name.starts_with("std::") || name.starts_with("__gnu_cxx::");
  if (isLibrarys) return noWireForm();
  const std::string alias = "My" + pattern->getNameAsString();
  return TypeProblem{
      "template-type",
      "no SUTURE_EXTERNAL_TYPE lists this instance of '" + pattern->getNameAsString() + "'",
      "write 'using " + alias + " = " + name + "<...>;' and SUTURE_EXTERNAL_TYPE(" + alias +
          "), or specialise suture::Wire",
      pattern};
}

}  // namespace suture::compiler::frontend
