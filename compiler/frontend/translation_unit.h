#pragma once
// This is one run of clang, kept open so that its tree and sources can be consulted.

#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>

#include <memory>
#include <string>
#include <vector>

#include "compiler/frontend/ast/annotation_uses.h"
#include "compiler/frontend/ast/includes.h"
#include "compiler/frontend/frontend.h"
#include "compiler/frontend/report/fix_collector.h"
#include "compiler/frontend/report/message_stream.h"

namespace suture::compiler::frontend {

class TranslationUnit {
 public:
  explicit TranslationUnit(const Request& request);
  ~TranslationUnit();

  /// Returns false after any error, which clang has printed.
  bool parse();

  clang::CompilerInstance& compiler() { return compiler_; }

  /// Returns where the unit uses the vocabulary.
  AnnotationUses& annotationUses() { return annotationUses_; }

  const Includes& includes() const { return includes_; }

  FixCollector& fixCollector() { return fixes_; }
  Fixes fixes() { return fixes_.apply(compiler_.getSourceManager(), compiler_.getLangOpts()); }

  /// Returns the absolute paths of what was read.
  std::vector<std::string> dependencies() const;

 private:
  bool configure();

  const Request& request_;
  std::string name_;
  MessageStream messages_;
  FixCollector fixes_;
  AnnotationUses annotationUses_;
  Includes includes_;
  clang::CompilerInstance compiler_;
  std::shared_ptr<clang::DependencyCollector> dependencies_;
  std::unique_ptr<clang::FrontendAction> action_;
  bool begun_ = false;
};

}  // namespace suture::compiler::frontend
