#pragma once
// This is what clang sees if a header includes generated code.

#include <llvm/Support/VirtualFileSystem.h>

namespace suture::compiler::frontend {

/// Ends the name of every generated header: "arm/arm.suture.h" belongs to "arm/arm.h".
inline constexpr llvm::StringLiteral kGeneratedSuffix = ".suture.h";

/// Returns "arm/arm.h" for "arm/arm.suture.h". The path must end with kGeneratedSuffix.
std::string sourceHeaderOf(llvm::StringRef generatedHeader);
/// Returns "arm/arm.suture.h" for "arm/arm.h", and likewise for any other ending.
std::string generatedHeaderOf(llvm::StringRef sourceHeader);

/// Shows the real files, but each X.suture.h reads as an include of the X.h beside which it is
/// looked up and of the templates that it specialises. Files with that name on disk are never read,
/// so there is no header cycle and a stale one does no harm.
class GeneratedHeaders : public llvm::vfs::ProxyFileSystem {
 public:
  explicit GeneratedHeaders(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> real);

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override;
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override;
  bool exists(const llvm::Twine& path) override;

 private:
  // Returns the file system that answers for the path, or null if it ends with kGeneratedSuffix and
  // there is no X.h.
  llvm::vfs::FileSystem* owner(const llvm::Twine& path);

  llvm::IntrusiveRefCntPtr<llvm::vfs::InMemoryFileSystem> replaced_;
};

}  // namespace suture::compiler::frontend
