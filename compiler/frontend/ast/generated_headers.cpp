#include "compiler/frontend/ast/generated_headers.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Path.h>

namespace suture::compiler::frontend {
namespace {

std::string textFor(llvm::StringRef sourceHeader) {
  std::string text = "#include \"" + llvm::sys::path::filename(sourceHeader).str() + "\"\n";
  for (const char* header : {"suture/component/provided.h", "suture/component/required.h"}) {
    text += std::string("#if __has_include(<") + header + ">)\n#include <" + header + ">\n#endif\n";
  }
  return text;
}

}  // namespace

std::string sourceHeaderOf(llvm::StringRef generatedHeader) {
  return generatedHeader.drop_back(kGeneratedSuffix.size()).str() + ".h";
}

std::string generatedHeaderOf(llvm::StringRef sourceHeader) {
  llvm::SmallString<128> path = sourceHeader;
  llvm::sys::path::replace_extension(path, "");
  return (path + kGeneratedSuffix).str();
}

GeneratedHeaders::GeneratedHeaders(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> real)
    : ProxyFileSystem(real), replaced_(new llvm::vfs::InMemoryFileSystem()) {
  if (auto directory = real->getCurrentWorkingDirectory()) {
    (void)replaced_->setCurrentWorkingDirectory(*directory);  // one in memory takes any directory
  }
}

llvm::vfs::FileSystem* GeneratedHeaders::owner(const llvm::Twine& path) {
  const std::string name = path.str();
  if (!llvm::StringRef(name).ends_with(kGeneratedSuffix)) return &getUnderlyingFS();
  if (replaced_->exists(name)) return replaced_.get();
  const std::string source = sourceHeaderOf(name);
  const auto found = getUnderlyingFS().status(source);
  if (!found || !found->isRegularFile()) return nullptr;
  replaced_->addFile(name, 0, llvm::MemoryBuffer::getMemBufferCopy(textFor(source), name));
  return replaced_.get();
}

llvm::ErrorOr<llvm::vfs::Status> GeneratedHeaders::status(const llvm::Twine& path) {
  llvm::vfs::FileSystem* files = owner(path);
  return files ? files->status(path) : std::make_error_code(std::errc::no_such_file_or_directory);
}

llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> GeneratedHeaders::openFileForRead(
    const llvm::Twine& path) {
  llvm::vfs::FileSystem* files = owner(path);
  if (!files) return std::make_error_code(std::errc::no_such_file_or_directory);
  return files->openFileForRead(path);
}

bool GeneratedHeaders::exists(const llvm::Twine& path) {
  llvm::vfs::FileSystem* files = owner(path);
  return files && files->exists(path);
}

}  // namespace suture::compiler::frontend
