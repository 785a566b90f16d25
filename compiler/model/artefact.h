#pragma once
// This is a text that suturec writes, as a value: the driver alone touches files.

#include <string>

namespace suture::compiler::model {

struct Artefact {
  std::string path;  ///< relative to the folder it belongs in: "arm/arm.suture.h", "arm/arm.capnp"
  std::string text;

  bool operator==(const Artefact&) const = default;
};

}  // namespace suture::compiler::model
