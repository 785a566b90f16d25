#include "compiler/frontend/types/field_fixes.h"

#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

#include "compiler/frontend/ast/default_content.h"

namespace suture::compiler::frontend {
namespace {

using clang::SourceLocation;
using clang::SourceRange;
using Place = model::Fix::Place;

/// A FieldText is the text of one field, which is declared alone and without a macro.
class FieldText {
 public:
  FieldText(const clang::FieldDecl* field, Mapping& mapping)
      : field_(field), mapping_(mapping), sources_(mapping.sources()) {
    for (SourceLocation at = field->getBeginLoc(); at != field->getLocation();) {
      tokens_.push_back(at);
      const auto next = clang::Lexer::findNextToken(at, sources_, language());
      if (!next || !sources_.isBeforeInTranslationUnit(at, field->getLocation())) break;
      at = next->getLocation();
    }
  }

  static bool isPlain(const clang::FieldDecl* field) {
    const bool macro = field->getBeginLoc().isMacroID() || field->getLocation().isMacroID();
    for (const clang::FieldDecl* other : field->getParent()->fields()) {
      if (other != field && other->getBeginLoc() == field->getBeginLoc()) return false;
    }
    return !macro && field->getBeginLoc() != field->getLocation();
  }

  /// Replaces the first word with that spelling by `text`.
  std::vector<model::Fix> replaceWord(llvm::StringRef word, std::string text) {
    for (const SourceLocation token : tokens_) {
      if (clang::Lexer::getSpelling(token, buffer_, sources_, language()) == word) {
        return {mapping_.fix(token, Place::Instead, std::move(text))};
      }
    }
    return {};
  }

  /// Replaces all before the name by `type`.
  model::Fix replaceType(std::string type) {
    const SourceLocation last = tokens_.back();
    const SourceLocation end = clang::Lexer::getLocForEndOfToken(last, 0, sources_, language());
    if (end == field_->getLocation()) type += ' ';
    return mapping_.fix(SourceRange(tokens_.front(), last), Place::Instead, std::move(type));
  }

  /// Drops the initialiser, if there is one.
  std::vector<model::Fix> dropInitialiser() {
    const clang::Expr* initialiser = field_->getInClassInitializer();
    if (!initialiser) return {};
    return {mapping_.fix(SourceRange(field_->getLocation(), initialiser->getEndLoc()),
                         Place::Instead, field_->getNameAsString())};
  }

  /// Adds the include before the first one of the file, unless it is there already.
  std::vector<model::Fix> include(const std::string& header) {
    const clang::FileID file = sources_.getFileID(field_->getLocation());
    const llvm::StringRef text = sources_.getBufferData(file);
    const std::string line = "#include <" + header + ">\n";
    const std::size_t first = text.find("\n#include");
    if (text.contains(line) || first == llvm::StringRef::npos) return {};
    const SourceLocation place =
        sources_.getLocForStartOfFile(file).getLocWithOffset(static_cast<int>(first) + 1);
    return {mapping_.fix(place, Place::Before, line)};
  }

 private:
  const clang::LangOptions& language() const { return mapping_.context().getLangOpts(); }

  const clang::FieldDecl* field_;
  Mapping& mapping_;
  const clang::SourceManager& sources_;
  std::vector<SourceLocation> tokens_;  // those before the name
  llvm::SmallString<32> buffer_;
};

void append(std::vector<model::Fix>& all, std::vector<model::Fix> more) {
  for (model::Fix& fix : more) all.push_back(std::move(fix));
}

/// Replaces a pointer to text by a std::string, which a literal initialises as well.
std::vector<model::Fix> textInstead(const clang::FieldDecl* field, Mapping& mapping) {
  FieldText text(field, mapping);
  const clang::Expr* const initialiser = field->getInClassInitializer();
  std::vector<model::Fix> fixes{text.replaceType("std::string")};
  if (initialiser && !literalIn(initialiser)) append(fixes, text.dropInitialiser());
  append(fixes, text.include("string"));
  return fixes;
}

/// Tells if suturec takes an optional of the type there, or knows what is to be done for it.
bool mayBeOptional(clang::QualType value, const clang::FieldDecl* field, Mapping& mapping) {
  if (value->getAsTagDecl() == field->getParent()) return false;  // it is not complete yet
  const MappedType mapped = mapType(value, mapping.names());
  const auto* problem = std::get_if<TypeProblem>(&mapped);
  return !problem || problem->slug == "unannotated-type";
}

std::vector<model::Fix> ownedInstead(const clang::FieldDecl* field, Mapping& mapping) {
  const clang::QualType value = field->getType()->getPointeeType().getUnqualifiedType();
  if (isText(field->getType())) return textInstead(field, mapping);
  if (!mayBeOptional(value, field, mapping)) return {};
  FieldText text(field, mapping);
  std::vector<model::Fix> fixes{
      text.replaceType("std::optional<" + spelled(value, mapping.context()) + ">")};
  append(fixes, text.dropInitialiser());
  append(fixes, text.include("optional"));
  return fixes;
}

std::vector<model::Fix> fixesOf(const clang::FieldDecl* field, const std::string& slug,
                                Mapping& mapping) {
  const clang::QualType type = field->getType();
  if (slug == "const-member" && type.isLocalConstQualified()) {
    return FieldText(field, mapping).replaceWord("const", "");
  }
  if (slug == "volatile" && type.isLocalVolatileQualified()) {
    return FieldText(field, mapping).replaceWord("volatile", "");
  }
  if (slug == "pointer" && type->isObjectType() && llvm::isa<clang::PointerType>(type) &&
      type->getPointeeType()->isObjectType() && !type->getPointeeType()->isPointerType()) {
    return ownedInstead(field, mapping);
  }
  if (slug == "char" && llvm::isa<clang::BuiltinType>(type)) {
    return {FieldText(field, mapping).replaceType("std::int8_t")};
  }
  if (slug == "long-long" && llvm::isa<clang::BuiltinType>(type)) {
    const bool negative = type->isSignedIntegerType();
    return {FieldText(field, mapping).replaceType(negative ? "std::int64_t" : "std::uint64_t")};
  }
  return {};
}

}  // namespace

std::vector<model::Fix> fixesFor(const clang::NamedDecl* declaration, const TypeProblem& problem,
                                 Mapping& mapping) {
  if (problem.slug == "unannotated-type" && problem.culprit) {
    const auto* type = llvm::cast<clang::NamedDecl>(problem.culprit);
    if (mapping.sources().isInSystemHeader(type->getLocation())) return {};
    return {mapping.fix(type->getLocation(), Place::Before, "SUTURE_TYPE() ")};
  }
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(declaration);
  if (!field || mapping.isForeign(field) || !FieldText::isPlain(field)) return {};
  return fixesOf(field, problem.slug, mapping);
}

}  // namespace suture::compiler::frontend
