#pragma once
// This watches for includes that a user needs to be told of.

#include <clang/Lex/Preprocessor.h>

#include <string>

namespace suture::compiler::frontend {

/// Reports a header that includes its own generated file, and adds help to a missing include.
void guardIncludes(clang::Preprocessor& preprocessor, const std::string& targetName);

}  // namespace suture::compiler::frontend
