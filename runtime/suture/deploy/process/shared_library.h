#pragma once
// This is a shared library of components, loaded while this exists.

#include <suture/component/factory/component_library.h>

#include <filesystem>
#include <memory>
#include <span>

namespace suture {

/// Set-up code only. Outlives every component that its classes have created.
class SharedLibrary {
 public:
  /// Throws SetupError if there is no such file, it cannot be loaded, it has no entry point, or it
  /// was built with another release of Suture.
  explicit SharedLibrary(const std::filesystem::path& file);

  std::span<const ComponentClass> classes() const { return classes_; }

 private:
  struct Close {
    void operator()(void* handle) const;
  };

  std::unique_ptr<void, Close> handle_;
  std::span<const ComponentClass> classes_;
};

}  // namespace suture
