// write_seeds FOLDER: some messages of each type, to start fuzzing from.

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/random_message.h"

int main(int, char** argv) {
  using namespace suture::fuzz;
  constexpr int kEach = 8;
  Random random(1);
  std::filesystem::create_directories(argv[1]);
  for (std::size_t type = 0; type < decoders().size(); ++type) {
    for (int i = 0; i < kEach; ++i) {
      const auto frame = randomFrame(decoders()[type], random);
      const std::string name = std::to_string(type) + "_" + std::to_string(i);
      std::ofstream out(std::filesystem::path(argv[1]) / name, std::ios::binary);
      out.put(static_cast<char>(type));
      out.write(reinterpret_cast<const char*>(frame.data()),
                static_cast<std::streamsize>(frame.size()));
    }
  }
  return 0;
}
