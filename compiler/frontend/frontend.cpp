#include "compiler/frontend/frontend.h"

#include <clang/Lex/HeaderSearch.h>
#include <clang/Sema/Sema.h>

#include "compiler/frontend/ast/header_table.h"
#include "compiler/frontend/report/reporter.h"
#include "compiler/frontend/translation_unit.h"
#include "compiler/frontend/unit_mapper.h"

namespace suture::compiler::frontend {

class Frontend::Implementation {
 public:
  explicit Implementation(Request request) : request_(std::move(request)), unit_(request_) {}

  bool run() {
    if (!unit_.parse()) return false;
    clang::CompilerInstance& compiler = unit_.compiler();
    HeaderTable headers(compiler.getSourceManager(),
                        compiler.getPreprocessor().getHeaderSearchInfo(), unit_.includes(),
                        request_.baseDirectory, request_.hasLock);
    for (const std::string& header : request_.headers) headers.addOwn(header);
    model::Diagnostics findings;
    model_ = mapUnit(compiler.getSema(), unit_.includes(), headers, table_, unit_.annotationUses(),
                     findings);
    return report(findings);
  }

  bool report(const model::Diagnostics& findings) {
    clang::DiagnosticsEngine& engine = unit_.compiler().getDiagnostics();
    engine.setIgnoreAllWarnings(false);
    return Reporter(engine, unit_.compiler().getLangOpts(), table_, request_.fatalWarnings,
                    unit_.fixCollector())
        .report(findings);
  }

  Fixes fixes() { return unit_.fixes(); }

  const model::Model& model() const { return model_; }
  std::vector<std::string> dependencies() const { return unit_.dependencies(); }

 private:
  Request request_;
  TranslationUnit unit_;
  SourceTable table_;
  model::Model model_;
};

Frontend::Frontend(Request request)
    : implementation_(std::make_unique<Implementation>(std::move(request))) {}
Frontend::~Frontend() = default;

bool Frontend::run() { return implementation_->run(); }
const model::Model& Frontend::model() const { return implementation_->model(); }
bool Frontend::report(const model::Diagnostics& findings) {
  return implementation_->report(findings);
}
Fixes Frontend::fixes() { return implementation_->fixes(); }
std::vector<std::string> Frontend::dependencies() const { return implementation_->dependencies(); }

}  // namespace suture::compiler::frontend
