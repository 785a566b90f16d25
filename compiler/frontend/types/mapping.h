#pragma once
// All mappers of declarations share this: it says where findings go and how parts of a declaration
// are read.

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/frontend/ast/includes.h"
#include "compiler/frontend/report/source_table.h"
#include "compiler/frontend/types/named_types.h"
#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

class Mapping {
 public:
  Mapping(clang::Sema& semantics, const Includes& includes, SourceTable& table,
          model::Diagnostics& findings)
      : context_(semantics.getASTContext()),
        includes_(includes),
        table_(table),
        findings_(findings),
        names_(semantics) {}

  model::Source sourceOf(const clang::NamedDecl* declaration);

  /// Lets findings about this declaration, which the user cannot edit, appear at `place` from now
  /// on. They say that `wantedBy` means it, if that is not null.
  void addForeign(const clang::NamedDecl* declaration, clang::SourceLocation place,
                  const clang::NamedDecl* wantedBy) {
    foreign_[declaration] = {sources().getFileLoc(place), wantedBy};
  }
  bool isForeign(const clang::NamedDecl* declaration) const {
    return foreign_.contains(declaration);
  }
  model::Documentation documentationOf(const clang::Decl* declaration) const;

  /// Appends an error at the declaration's name, and returns it so that the caller can add notes.
  model::Diagnostic& error(const clang::NamedDecl* declaration, std::string slug,
                           std::string message, std::string help);

  /// Appends an error at a place that is no declaration.
  model::Diagnostic& errorAt(clang::SourceLocation place, std::string slug, std::string message,
                             std::string help);
  /// Appends a warning at the declaration's name.
  model::Diagnostic& warn(const clang::NamedDecl* declaration, std::string slug,
                          std::string message, std::string help);

  /// Returns a stretch of text, for fixes.
  model::Source sourceOf(clang::SourceRange range);

  /// Returns a change of the text in the range, for a finding about it.
  model::Fix fix(clang::SourceRange range, model::Fix::Place place, std::string text);

  /// Returns the annotation of that kind, and reports its problems.
  Annotation annotationOf(const clang::NamedDecl* declaration, Kind kind);

  /// Returns one annotation for each time that the macro stands there, and reports their problems.
  std::vector<Annotation> annotationsOf(const clang::NamedDecl* declaration, Kind kind);

  /// Returns the annotation of that kind, and leaves its problems to a later annotationOf().
  static Annotation peek(const clang::NamedDecl* declaration, Kind kind) {
    std::vector<AnnotationProblem> ignored;
    return readAnnotation(declaration, kind, ignored);
  }

  /// Returns a type held by value with its bounds, or none after an error at the declaration.
  /// `subject` begins the message: "field 'p'".
  std::optional<model::Type> typeOf(const clang::NamedDecl* declaration, clang::QualType type,
                                    const std::string& subject, const Annotation& field);

  /// Returns the aliases of template instances and the external types, which are all there before
  /// anything is mapped.
  NamedTypes& names() { return names_; }

  /// Returns true if it is asked of the declaration for the first time.
  bool once(const clang::NamedDecl* declaration) { return seen_.insert(declaration).second; }

  clang::ASTContext& context() { return context_; }
  const Includes& includes() const { return includes_; }
  const clang::SourceManager& sources() const { return context_.getSourceManager(); }

 private:
  model::Diagnostic& add(model::Source source, std::string slug, std::string message,
                         std::string help);
  void report(const clang::NamedDecl* declaration, std::vector<AnnotationProblem> problems);
  void checkNumberArguments(const clang::NamedDecl* declaration, const std::string& subject,
                            const model::Type& type, const Annotation& field);

  clang::ASTContext& context_;
  const Includes& includes_;
  SourceTable& table_;
  model::Diagnostics& findings_;
  NamedTypes names_;
  std::set<const clang::NamedDecl*> seen_;
  struct Foreign {
    clang::SourceLocation place;
    const clang::NamedDecl* wantedBy;
  };
  std::map<const clang::NamedDecl*, Foreign> foreign_;
};

}  // namespace suture::compiler::frontend
