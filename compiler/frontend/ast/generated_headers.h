#pragma once
// What clang sees where a header includes generated code.

#include <llvm/Support/VirtualFileSystem.h>

namespace suture::compiler::frontend {

/// Ends the name of every generated header: "arm/arm.suture.h" belongs to "arm/arm.h".
inline constexpr llvm::StringLiteral kGeneratedSuffix = ".suture.h";

/// "arm/arm.suture.h" -> "arm/arm.h". The path must end with kGeneratedSuffix.
std::string sourceHeaderOf(llvm::StringRef generatedHeader);
/// "arm/arm.h" -> "arm/arm.suture.h", whatever the ending.
std::string generatedHeaderOf(llvm::StringRef sourceHeader);

/// The real files, but each X.suture.h reads as an include of the X.h beside which it is looked up
/// and of the templates that it specialises. Files with that name on disk are never read, so there
/// is no header cycle and a stale one does no harm.
class GeneratedHeaders : public llvm::vfs::ProxyFileSystem {
 public:
  explicit GeneratedHeaders(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> real);

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override;
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override;
  bool exists(const llvm::Twine& path) override;

 private:
  // The file system that answers for the path; null where there is no X.h.
  llvm::vfs::FileSystem* owner(const llvm::Twine& path);

  llvm::IntrusiveRefCntPtr<llvm::vfs::InMemoryFileSystem> replaced_;
};

}  // namespace suture::compiler::frontend
