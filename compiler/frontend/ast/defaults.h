#pragma once
// This finds what the default constructor of a struct gives its members.

#include <clang/AST/Decl.h>

#include <string>
#include <vector>

#include "compiler/model/type.h"

namespace suture::compiler::frontend {

/// Says what a member is by default.
struct Default {
  enum class State {
    Nothing,       ///< the type's own default, or one that only a constructor knows (isPreset)
    Constant,      ///< what `json` says
    NotConstant,   ///< a number that is known when the program runs
    NoEnumerator,  ///< a value of an enum that none of its enumerators has
    NotANumber,    ///< NaN or something that holds it, which no contract lets pass
    TooLong,       ///< more bytes or elements than its capacity
    Unseen,        ///< a number that a constructor may set where suturec cannot see it
  };

  State state = State::Nothing;
  /// The value is a number, an enumerator's name or a string; infinity is "inf" or "-inf", and a
  /// duration is its seconds, with as many digits as it takes.
  std::string json{};
  /// A member of several numbers certainly has these among them.
  std::vector<double> numbers{};
};

Default defaultOf(const clang::FieldDecl* field, const model::Type& type);

/// Tells if the default constructor of the field's class may give it another value than its type
/// does.
bool isPreset(const clang::FieldDecl* field);

}  // namespace suture::compiler::frontend
