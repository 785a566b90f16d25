#include "compiler/frontend/ast/annotation_uses.h"

#include <clang/AST/Attr.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/PPCallbacks.h>

#include <iterator>

#include "compiler/frontend/ast/annotation.h"

namespace suture::compiler::frontend {

class AnnotationUses::Watcher : public clang::PPCallbacks {
 public:
  explicit Watcher(AnnotationUses& uses) : uses_(uses) {}

  void MacroExpands(const clang::Token& name, const clang::MacroDefinition&, clang::SourceRange,
                    const clang::MacroArgs*) override {
    const llvm::StringRef macro = name.getIdentifierInfo()->getName();
    if (!isVocabulary(macro)) return;
    uses_.open_.emplace(uses_.sources_->getExpansionLoc(name.getLocation()), macro.str());
  }

 private:
  AnnotationUses& uses_;
};

void AnnotationUses::watch(clang::Preprocessor& preprocessor) {
  sources_ = &preprocessor.getSourceManager();
  preprocessor.addPPCallbacks(std::make_unique<Watcher>(*this));
}

void AnnotationUses::claim(const clang::Decl* declaration) {
  for (const auto* attribute : declaration->specific_attrs<clang::AnnotateAttr>()) {
    open_.erase(sources_->getExpansionLoc(attribute->getLocation()));
  }
}

void AnnotationUses::claimBefore(const clang::RecordDecl* anonymous) {
  const clang::SourceLocation begin = sources_->getExpansionLoc(anonymous->getBeginLoc());
  const auto next = open_.lower_bound(begin);
  if (next == open_.begin()) return;
  const auto last = std::prev(next);
  const clang::LangOptions& language = anonymous->getLangOpts();
  const auto between = clang::CharSourceRange::getCharRange(last->first, begin);
  const llvm::StringRef text = clang::Lexer::getSourceText(between, *sources_, language);
  if (!text.empty() && text.find_first_of(";{}") == llvm::StringRef::npos) open_.erase(last);
}

}  // namespace suture::compiler::frontend
