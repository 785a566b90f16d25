#include "compiler/frontend/ast/include_guard.h"

#include <clang/Basic/SourceManager.h>
#include <clang/Lex/PPCallbacks.h>

#include "compiler/frontend/ast/generated_headers.h"

namespace suture::compiler::frontend {
namespace {

using Level = clang::DiagnosticsEngine::Level;

class Guard : public clang::PPCallbacks {
 public:
  Guard(clang::Preprocessor& preprocessor, std::string targetName)
      : preprocessor_(preprocessor), targetName_(std::move(targetName)) {}

  void InclusionDirective(clang::SourceLocation hash, const clang::Token&, llvm::StringRef name,
                          bool, clang::CharSourceRange range, clang::OptionalFileEntryRef file,
                          llvm::StringRef, llvm::StringRef, const clang::Module*, bool,
                          clang::SrcMgr::CharacteristicKind) override {
    if (!file) return missing(range.getBegin());
    if (!name.ends_with(kGeneratedSuffix)) return;
    const clang::SourceManager& sources = preprocessor_.getSourceManager();
    const auto source =
        sources.getFileManager().getOptionalFileRef(sourceHeaderOf(file->getName()));
    const auto includer = sources.getFileEntryRefForID(sources.getFileID(hash));
    if (source && includer && *source == *includer) includesItself(hash, range, name);
  }

 private:
  void includesItself(clang::SourceLocation hash, clang::CharSourceRange range,
                      llvm::StringRef name) {
    report(Level::Error, range,
           "the header includes the file that is generated from it [suture-own-generated-include]",
           clang::FixItHint::CreateRemoval(
               clang::CharSourceRange::getCharRange(hash, range.getEnd())));
    report(Level::Note, range,
           "remove the include of '" + name.str() + "'; users of the header include it instead");
  }

  void missing(clang::SourceLocation location) {
    report(Level::Note, clang::CharSourceRange::getCharRange(location, location),
           "it was looked for in the include directories of target '" + targetName_ + "'");
  }

  void report(Level level, clang::CharSourceRange range, const std::string& text,
              const clang::FixItHint& fix = {}) {
    clang::DiagnosticsEngine& engine = preprocessor_.getDiagnostics();
    const unsigned id = engine.getDiagnosticIDs()->getCustomDiagID(
        static_cast<clang::DiagnosticIDs::Level>(level), "%0");
    engine.Report(range.getBegin(), id) << text << range << fix;
  }

  clang::Preprocessor& preprocessor_;
  std::string targetName_;
};

}  // namespace

void guardIncludes(clang::Preprocessor& preprocessor, const std::string& targetName) {
  preprocessor.addPPCallbacks(std::make_unique<Guard>(preprocessor, targetName));
}

}  // namespace suture::compiler::frontend
