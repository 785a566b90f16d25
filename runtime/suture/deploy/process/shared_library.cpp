#include <dlfcn.h>
#include <suture/base/errors.h>
#include <suture/deploy/process/shared_library.h>

#include <string>
#include <string_view>

namespace suture {

void SharedLibrary::Close::operator()(void* handle) const { dlclose(handle); }

SharedLibrary::SharedLibrary(const std::filesystem::path& file) {
  const std::string asked = "loading components from '" + file.string() + "'";
  if (!std::filesystem::is_regular_file(file)) {
    throw SetupError(asked, "there is no such file",
                     "Give the path of a shared library, absolute or from the deployment's folder");
  }
  // Keep symbols local: two libraries may contain the same code, and each must use its own.
  handle_.reset(dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL));
  if (handle_ == nullptr) {
    throw SetupError(asked, dlerror(), "Build it for this machine, and install what it needs");
  }
  const auto entry = reinterpret_cast<ComponentsEntry>(dlsym(handle_.get(), kComponentsEntry));
  if (entry == nullptr) {
    throw SetupError(asked, "it has no function " + std::string(kComponentsEntry) + "()",
                     "Build it with suture_generate(TARGET ... LOADABLE HEADERS ...)");
  }
  const ComponentLibrary& library = *entry();
  if (library.version != std::string_view(kVersion)) {
    throw SetupError(asked,
                     "it was built with Suture " + std::string(library.version) +
                         ", this program with " + kVersion,
                     "Build both with the same release");
  }
  classes_ = library.classes;
  library.virtualTime->store(virtualTime());
}

}  // namespace suture
