#include "program_hash.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <suture/base/errors.h>

#include <array>
#include <fstream>
#include <memory>

namespace demo {
namespace {

struct FreeContext {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

suture::SetupError failure(const std::filesystem::path& file, const char* why) {
  return {"taking the SHA-256 of " + file.string(), why,
          "Give this user the right to read the program"};
}

}  // namespace

ProgramHash hashProgram(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::unique_ptr<EVP_MD_CTX, FreeContext> context(EVP_MD_CTX_new());
  if (!stream) throw failure(file, "the file cannot be read");
  bool sound = context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  std::array<char, 65536> piece;
  while (sound && stream) {
    stream.read(piece.data(), piece.size());
    sound = EVP_DigestUpdate(context.get(), piece.data(),
                             static_cast<std::size_t>(stream.gcount())) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (!sound || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1) {
    throw failure(file, "OpenSSL refuses");
  }
  ProgramHash hash{std::filesystem::canonical(file).filename(), ""};
  for (unsigned i = 0; i < length; ++i) hash.sha256 += fmt::format("{:02x}", digest[i]);
  return hash;
}

}  // namespace demo
