// This is suturec: it makes of annotated C++ headers everything that carries them over a wire.

#include <exception>
#include <iostream>

#include "compiler/driver/diff.h"
#include "compiler/driver/options.h"
#include "compiler/driver/run.h"

int main(int argc, char** argv) {
  using namespace suture::compiler::driver;
  try {
    const std::vector<std::string> arguments{argv + 1, argv + argc};
    if (!arguments.empty() && arguments.front() == "diff") {
      return diff({arguments.begin() + 1, arguments.end()});
    }
    const Parsed parsed = parseOptions(arguments);
    return parsed.options ? run(*parsed.options) : parsed.exitStatus;
  } catch (const std::exception& error) {
    std::cerr << "suturec: error: " << error.what() << "\n";
    return 1;
  }
}
