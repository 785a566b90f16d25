#pragma once
// What all mappers of declarations share: where findings go and how parts of a declaration are
// read.

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>

#include <optional>
#include <string>
#include <vector>

#include "compiler/frontend/annotation.h"
#include "compiler/frontend/named_types.h"
#include "compiler/frontend/source_table.h"
#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

class Mapping {
 public:
  Mapping(clang::ASTContext& context, SourceTable& table, model::Diagnostics& findings)
      : context_(context), table_(table), findings_(findings) {}

  model::Source sourceOf(const clang::NamedDecl* declaration);
  model::Documentation documentationOf(const clang::Decl* declaration) const;

  /// Appends a finding at the declaration's name; the result takes notes.
  model::Diagnostic& error(const clang::NamedDecl* declaration, std::string slug,
                           std::string message, std::string help);

  /// The annotation of that kind, its problems reported.
  Annotation annotationOf(const clang::NamedDecl* declaration, Kind kind);

  /// A type held by value with its bounds; none after an error at the declaration. `subject` begins
  /// the message: "field 'p'".
  std::optional<model::Type> typeOf(const clang::NamedDecl* declaration, clang::QualType type,
                                    const std::string& subject, const Annotation& field);

  /// Aliases of template instances and external types; filled before anything is mapped.
  NamedTypes& names() { return names_; }

  clang::ASTContext& context() { return context_; }
  const clang::SourceManager& sources() const { return context_.getSourceManager(); }

 private:
  void checkNumberArguments(const clang::NamedDecl* declaration, const std::string& subject,
                            const model::Type& type, const Annotation& field);

  clang::ASTContext& context_;
  SourceTable& table_;
  model::Diagnostics& findings_;
  NamedTypes names_;
};

}  // namespace suture::compiler::frontend
