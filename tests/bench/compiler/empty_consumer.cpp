// This is an empty libTooling consumer: it parses a file with function bodies skipped, and looks at
// nothing. suturec cannot do without that, so it is the yardstick for its time.

#include <clang/AST/ASTConsumer.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendActions.h>
#include <clang/Tooling/CompilationDatabase.h>
#include <clang/Tooling/Tooling.h>

#include <cstdio>

namespace {

class EmptyAction : public clang::ASTFrontendAction {
 protected:
  bool BeginInvocation(clang::CompilerInstance& compiler) override {
    compiler.getFrontendOpts().SkipFunctionBodies = true;
    return true;
  }
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&,
                                                        llvm::StringRef) override {
    return std::make_unique<clang::ASTConsumer>();
  }
};

}  // namespace

int main(int argc, const char** argv) {
  std::string error;
  const auto compilation =
      clang::tooling::FixedCompilationDatabase::loadFromCommandLine(argc, argv, error);
  if (argc != 2 || compilation == nullptr) {
    std::fprintf(stderr, "usage: empty-consumer FILE -- CLANG-ARGUMENTS\n%s\n", error.c_str());
    return 2;
  }
  clang::tooling::ClangTool tool(*compilation, {argv[1]});
  return tool.run(clang::tooling::newFrontendActionFactory<EmptyAction>().get());
}
