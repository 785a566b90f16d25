// This is a library as an earlier release of Suture would have left it.
#include <suture/component/factory/component_library.h>

extern "C" const suture::ComponentLibrary* suture_components() {
  static const suture::ComponentLibrary kLibrary{.version = "0.0.9", .classes = {}};
  return &kLibrary;
}
