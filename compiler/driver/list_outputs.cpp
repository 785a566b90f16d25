#include "compiler/driver/list_outputs.h"

#include <iostream>

#include "compiler/emit/emit.h"

namespace suture::compiler::driver {

int listOutputs() {
  for (const emit::Output& output : emit::outputs()) {
    std::cout << output.use << " " << output.suffix << "\n";
  }
  std::cout << "schema capnp\n";  // wire_schema.h
  return 0;
}

}  // namespace suture::compiler::driver
