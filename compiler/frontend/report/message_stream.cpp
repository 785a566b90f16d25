#include "compiler/frontend/report/message_stream.h"

#include <utility>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/model/nearest.h"

namespace suture::compiler::frontend {
namespace {

constexpr llvm::StringLiteral kUnknownArgument = "error: no member named '";

}  // namespace

MessageStream::MessageStream(llvm::raw_ostream& out, std::string unitName)
    : raw_ostream(/*unbuffered=*/true),
      out_(out),
      includeLine_("In file included from " + std::move(unitName) + ":") {}

MessageStream::~MessageStream() {
  if (!pending_.empty()) out_ << pending_;
}

void MessageStream::write_impl(const char* text, std::size_t size) {
  pending_.append(text, size);
  std::size_t start = 0;
  for (std::size_t end; (end = pending_.find('\n', start)) != std::string::npos; start = end + 1) {
    forward(llvm::StringRef(pending_).slice(start, end + 1));
  }
  pending_.erase(0, start);
}

void MessageStream::forward(llvm::StringRef line) {
  if (line.starts_with(includeLine_)) return;
  line.consume_front("./");
  line = line.rtrim();
  const bool excerpt = line.ltrim(" 0123456789").starts_with("|");
  if (excerpt && withinVocabulary_) return;
  withinVocabulary_ = line.contains(": note: expanded from macro 'SUTURE_");
  if (withinVocabulary_) return;
  const std::size_t unknown = line.find(kUnknownArgument);
  if (unknown == llvm::StringRef::npos) {
    out_ << line << '\n';
    if (excerpt && line.contains('^')) out_ << std::exchange(advice_, "");
  } else {
    forwardUnknown(line.take_front(unknown), line.drop_front(unknown + kUnknownArgument.size()));
  }
}

// Explains a misspelt argument, which clang takes for a missing member of a namespace that no user
// has heard of.
void MessageStream::forwardUnknown(llvm::StringRef place, llvm::StringRef rest) {
  const auto [name, where] = rest.split('\'');
  if (!where.starts_with(" in namespace 'suture::dsl'")) {
    out_ << place << kUnknownArgument << rest << '\n';
    return;
  }
  out_ << place << "error: no annotation has an argument '" << name
       << "' [suture-unknown-argument]\n";
  const auto meant = model::nearest({name.data(), name.size()}, annotationArguments());
  advice_ = place.str() + "note: " +
            (meant ? "did you mean '" + std::string(*meant) + "'?"
                   : "docs/annotations.md lists the arguments of each annotation") +
            "\n";
}

}  // namespace suture::compiler::frontend
