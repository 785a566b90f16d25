#include "compiler/frontend/translation_unit.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/DeclCXX.h>
#include <clang/Frontend/FrontendActions.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <clang/Frontend/Utils.h>
#include <clang/Lex/PreprocessorOptions.h>
#include <llvm/Support/FileSystem.h>

#include <set>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/frontend/ast/empty_body.h"
#include "compiler/frontend/ast/generated_headers.h"
#include "compiler/frontend/ast/include_guard.h"
#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

constexpr unsigned kErrorLimit = 20;

/// Includes system headers, because an upgrade of Eigen must be noticed.
class AllDependencies : public clang::DependencyCollector {
  bool needSystemDependencies() override { return true; }
};

/// Reads no function's body but those of default constructors, which say what members are by
/// default. SUTURE_EXTERNAL_TYPE may name any class later, so of a class without annotation an
/// empty body is read too. It reads none of a component, which may use what is still to be
/// generated.
class Consumer : public clang::ASTConsumer {
  bool shouldSkipFunctionBody(clang::Decl* declaration) override {
    const auto* constructor =
        llvm::dyn_cast_or_null<clang::CXXConstructorDecl>(declaration->getAsFunction());
    if (constructor == nullptr || !constructor->isDefaultConstructor()) return true;
    if (isAnnotated(constructor->getParent(), Kind::Type)) return false;
    return isOfLibrary(constructor) || derivesFromRuntime(constructor->getParent()) ||
           !hasEmptyBody(constructor);
  }

  static bool derivesFromRuntime(const clang::CXXRecordDecl* record) {
    return !record->forallBases([](const clang::CXXRecordDecl* base) {
      return !llvm::StringRef(qualifiedName(base)).starts_with("suture::");
    });
  }

  /// Tells if the class is of one of these two libraries. They are large, and hold nothing that
  /// SUTURE_EXTERNAL_TYPE names.
  static bool isOfLibrary(const clang::CXXConstructorDecl* constructor) {
    const std::string name = qualifiedName(constructor->getParent());
    return name.starts_with("std::") || name.starts_with("Eigen::");
  }
};

class Action : public clang::SyntaxOnlyAction {
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&,
                                                        llvm::StringRef) override {
    return std::make_unique<Consumer>();
  }
};

std::string wrapperText(const std::vector<std::string>& headers) {
  std::string text;
  for (const std::string& header : headers) text += "#include \"" + header + "\"\n";
  return text;
}

std::vector<std::string> commandLine(const Request& request, const std::string& unitName) {
  std::vector<std::string> arguments{"clang++",
                                     "-fsyntax-only",
                                     "-xc++",
                                     "-std=c++20",
                                     "-DSUTUREC",
                                     "-nocudainc",
                                     "-nocudalib",
                                     "-resource-dir=" + request.resourceDirectory,
                                     "-ferror-limit=" + std::to_string(kErrorLimit)};
  arguments.insert(arguments.end(), request.clangArguments.begin(), request.clangArguments.end());
  arguments.insert(arguments.end(), {"--", unitName});
  return arguments;
}

}  // namespace

TranslationUnit::TranslationUnit(const Request& request)
    : request_(request),
      name_("suturec:" + request.targetName),
      messages_(llvm::errs(), name_),
      dependencies_(std::make_shared<AllDependencies>()) {}

TranslationUnit::~TranslationUnit() {
  if (begun_) action_->EndSourceFile();
}

bool TranslationUnit::configure() {
  llvm::IntrusiveRefCntPtr<clang::DiagnosticOptions> options(new clang::DiagnosticOptions());
  llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> files(
      new GeneratedHeaders(llvm::vfs::getRealFileSystem()));
  clang::CreateInvocationOptions creation;
  creation.VFS = files;
  creation.ProbePrecompiled = false;
  creation.Diags = clang::CompilerInstance::createDiagnostics(
      options.get(), new clang::TextDiagnosticPrinter(messages_, options.get()));

  const std::vector<std::string> arguments = commandLine(request_, name_);
  std::vector<const char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  std::shared_ptr<clang::CompilerInvocation> invocation =
      clang::createInvocation(pointers, creation);
  if (!invocation || creation.Diags->hasErrorOccurred()) return false;

  invocation->getFrontendOpts().SkipFunctionBodies = true;
  invocation->getPreprocessorOpts().addRemappedFile(
      name_, llvm::MemoryBuffer::getMemBufferCopy(wrapperText(request_.headers), name_).release());
  compiler_.setInvocation(std::move(invocation));
  fixes_.forwardTo(
      std::make_unique<clang::TextDiagnosticPrinter>(messages_, &compiler_.getDiagnosticOpts()));
  compiler_.createDiagnostics(&fixes_, /*ShouldOwnClient=*/false);
  // Only errors count here, because the user's compiler warns about the user's code.
  compiler_.getDiagnostics().setIgnoreAllWarnings(true);
  compiler_.createFileManager(files);
  compiler_.createSourceManager(compiler_.getFileManager());
  compiler_.addDependencyCollector(dependencies_);
  return compiler_.createTarget();
}

bool TranslationUnit::parse() {
  if (!configure()) return false;
  action_ = std::make_unique<Action>();
  begun_ = action_->BeginSourceFile(compiler_, compiler_.getFrontendOpts().Inputs.front());
  if (!begun_) return false;
  guardIncludes(compiler_.getPreprocessor(), request_.targetName);
  annotationUses_.watch(compiler_.getPreprocessor());
  includes_.watch(compiler_.getPreprocessor());
  if (llvm::Error error = action_->Execute()) {
    llvm::errs() << "suturec: " << llvm::toString(std::move(error)) << "\n";
    return false;
  }
  return !compiler_.getDiagnostics().hasErrorOccurred();
}

std::vector<std::string> TranslationUnit::dependencies() const {
  std::set<std::string> paths;
  for (const std::string& file : dependencies_->getDependencies()) {
    if (file == name_ || llvm::StringRef(file).ends_with(kGeneratedSuffix)) continue;
    // Do not merely drop "..", because clang reaches its headers through symbolic links.
    llvm::SmallString<256> path;
    if (llvm::sys::fs::real_path(file, path)) continue;
    paths.insert(path.str().str());
  }
  return {paths.begin(), paths.end()};
}

}  // namespace suture::compiler::frontend
