#include "compiler/frontend/ast/empty_body.h"

#include <clang/AST/ASTContext.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

namespace suture::compiler::frontend {
namespace {

bool isOpening(const clang::Token& token) {
  return token.isOneOf(clang::tok::l_paren, clang::tok::l_brace, clang::tok::l_square);
}

bool isClosing(const clang::Token& token) {
  return token.isOneOf(clang::tok::r_paren, clang::tok::r_brace, clang::tok::r_square);
}

/// Lexes from the end of a declaration. Clang has not read this text yet, and its macros have not
/// been expanded, so it must be judged by its tokens alone.
class BodyFinder {
 public:
  explicit BodyFinder(clang::Lexer& lexer) : lexer_(lexer) {}

  /// Moves behind the brace that opens the body. Returns false if there is none.
  bool find() {
    clang::tok::TokenKind before = next();  // this is the end of the declaration
    bool listed = false;
    for (clang::tok::TokenKind kind = next(); kind != clang::tok::eof; kind = next()) {
      // In a list of initialisers, a brace that follows a name is the member's.
      const bool ofMember =
          listed && before != clang::tok::r_paren && before != clang::tok::r_brace;
      if (kind == clang::tok::l_brace && !ofMember) return true;
      if (kind == clang::tok::hash || kind == clang::tok::semi) return false;
      listed = listed || kind == clang::tok::colon;
      if (isOpening(token_) && !skipGroup()) return false;
      before = token_.getKind();
    }
    return false;
  }

  bool isClosedNext() { return next() == clang::tok::r_brace; }

 private:
  clang::tok::TokenKind next() {
    lexer_.LexFromRawLexer(token_);
    return token_.getKind();
  }

  /// Moves to what closes the group that the present token opens. Returns false if nothing does.
  bool skipGroup() {
    for (unsigned depth = 1; depth != 0;) {
      if (next() == clang::tok::eof) return false;
      if (isOpening(token_)) ++depth;
      if (isClosing(token_)) --depth;
    }
    return true;
  }

  clang::Lexer& lexer_;
  clang::Token token_;
};

}  // namespace

bool hasEmptyBody(const clang::CXXConstructorDecl* constructor) {
  const clang::SourceLocation end = constructor->getEndLoc();
  if (!end.isFileID()) return false;
  const clang::ASTContext& context = constructor->getASTContext();
  const clang::SourceManager& sources = context.getSourceManager();
  const auto [file, offset] = sources.getDecomposedLoc(end);
  const llvm::StringRef text = sources.getBufferData(file);
  clang::Lexer lexer(sources.getLocForStartOfFile(file), context.getLangOpts(), text.begin(),
                     text.begin() + offset, text.end());
  BodyFinder finder(lexer);
  return finder.find() && finder.isClosedNext();
}

}  // namespace suture::compiler::frontend
