// Written by suturec for target loadable. Do not edit.
#include <suture/component/factory/component_library.h>

#include "loadable/parts.suture.h"

/// A deployment that names this library calls it.
extern "C" const suture::ComponentLibrary* suture_components() {
  static const suture::ComponentClass kClasses[] = {
      suture::componentClass<loadable::Platter>(),
      suture::componentClass<loadable::Hand>(),
      suture::componentClass<loadable::Spindle>(),
  };
  static const suture::ComponentLibrary kLibrary{.version = suture::kVersion, .classes = kClasses};
  return &kLibrary;
}
