#include "compiler/frontend/message_stream.h"

namespace suture::compiler::frontend {

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
  out_ << line;
}

}  // namespace suture::compiler::frontend
