#pragma once
// These emit the functions between slots and Cap'n Proto for what travels as a struct that no
// header declares.

#include <set>
#include <string>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Writes each pair of functions into a generated source only once.
class CompositeConverters {
 public:
  explicit CompositeConverters(const Context& context) : context_(context) {}

  /// Emits toWire() and fromWire() of every composite in the type, parts before wholes.
  void emit(Code& code, const model::Type& type);

 private:
  void emitOne(Code& code, const model::Type& type);

  const Context& context_;
  std::set<std::string> done_;
};

}  // namespace suture::compiler::emit
