#pragma once
// This prints clang's messages as the user should see them.

#include <llvm/Support/raw_ostream.h>

#include <string>

namespace suture::compiler::frontend {

/// Forwards whole lines, less what only suturec itself causes: the include stack through the
/// in-memory translation unit, the "./" that clang puts before a header named relative to it,
/// blanks at the end, how the SUTURE_ macros are made, and what follows from the use of a
/// member that is still to be generated.
class MessageStream : public llvm::raw_ostream {
 public:
  MessageStream(llvm::raw_ostream& out, std::string unitName);
  ~MessageStream() override;

 private:
  void write_impl(const char* text, std::size_t size) override;
  std::uint64_t current_pos() const override { return 0; }
  void forward(llvm::StringRef line);
  void forwardUnknown(llvm::StringRef place, llvm::StringRef rest);

  llvm::raw_ostream& out_;
  std::string includeLine_;
  std::string pending_;
  std::string advice_;              // follows the excerpt of the source
  bool saidGenerated_ = false;      // true once a member that is still to be generated was used
  bool withinConsequence_ = false;  // true in an error that follows from that
  bool withinVocabulary_ = false;   // true in the excerpt of a SUTURE_ macro's definition
};

}  // namespace suture::compiler::frontend
