#include "compiler/driver/list_outputs.h"

#include <iostream>
#include <vector>

#include "compiler/emit/emit.h"

namespace suture::compiler::driver {

int listOutputs() {
  std::vector<emit::Output> all = emit::outputs();
  all.push_back(emit::kPart);
  for (const emit::Output& output : all) std::cout << output.use << " " << output.suffix << "\n";
  std::cout << "schema capnp\n";  // wireSchema() writes this one
  return 0;
}

}  // namespace suture::compiler::driver
