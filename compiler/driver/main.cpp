// suturec: from annotated C++ headers to everything that carries them over a wire.

#include <exception>
#include <iostream>

#include "compiler/driver/options.h"
#include "compiler/driver/run.h"

int main(int argc, char** argv) {
  using namespace suture::compiler::driver;
  try {
    const Parsed parsed = parseOptions({argv + 1, argv + argc});
    return parsed.options ? run(*parsed.options) : parsed.exitStatus;
  } catch (const std::exception& error) {
    std::cerr << "suturec: error: " << error.what() << "\n";
    return 1;
  }
}
