#pragma once
// Finds what the default constructor of a struct gives its members.

#include <clang/AST/Decl.h>

#include <string>

#include "compiler/model/type.h"

namespace suture::compiler::frontend {

/// Says what a member is by default.
struct Default {
  enum class State {
    Nothing,      ///< what its type's own default is, or what only a constructor knows (isPreset)
    Constant,     ///< `json`
    NotConstant,  ///< a number that is known when the program runs
    NotANumber,   ///< NaN or something that holds it, which no contract lets pass
    TooLong,      ///< more bytes or elements than its capacity
    Unseen,       ///< a number that a constructor may set where suturec cannot see it
  };

  State state = State::Nothing;
  /// A number, an enumerator's name, a string; "inf" and "-inf"; of a duration its seconds, with
  /// as many digits as it takes.
  std::string json{};
};

Default defaultOf(const clang::FieldDecl* field, const model::Type& type);

/// Whether the default constructor of the field's class may give it another value than its type
/// does.
bool isPreset(const clang::FieldDecl* field);

}  // namespace suture::compiler::frontend
