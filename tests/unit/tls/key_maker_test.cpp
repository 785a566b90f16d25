#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "support/contains.h"
#include "support/refusal.h"
#include "support/small_files.h"
#include "support/temporary_directory.h"

namespace suture::tls {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

mode_t modeOf(const fs::path& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 0777 : 0;
}

std::string contentOf(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

class KeyMaker : public testing::Test {
 protected:
  std::string refusedUse(const std::string& process) const {
    return refusal([&] { Keys(folder_, process); });
  }

  const TemporaryDirectory directory_;
  const fs::path folder_ = directory_.path() / "keys";
};

TEST_F(KeyMaker, MakesWhatAProcessCanUse) {
  const auto made = makeKeys(folder_, {"left", "right", kManagerName});
  EXPECT_EQ(made.size(), 8u);
  EXPECT_EQ(Keys(folder_, "left").process(), "left");
  EXPECT_EQ(Keys(folder_, kManagerName).process(), kManagerName);
}

TEST_F(KeyMaker, KeysBelongToTheOwnerOnly) {
  const mode_t before = umask(0);
  const auto made = makeKeys(folder_, {"left"});
  umask(before);
  EXPECT_EQ(modeOf(folder_), 0700u);
  for (const fs::path& file : made) {
    EXPECT_EQ(modeOf(file), file.extension() == ".key" ? 0600u : 0644u) << file;
  }
}

TEST_F(KeyMaker, AddsToAnExistingCa) {
  makeKeys(folder_, {"left"});
  const std::string ca = contentOf(folder_ / "ca.crt"), left = contentOf(folder_ / "left.crt");
  EXPECT_EQ(makeKeys(folder_, {"right"}).size(), 2u);
  EXPECT_EQ(contentOf(folder_ / "ca.crt"), ca);
  EXPECT_EQ(contentOf(folder_ / "left.crt"), left);
  EXPECT_EQ(Keys(folder_, "right").process(), "right");
}

TEST_F(KeyMaker, OverwritesNothingAndThenMakesNothing) {
  makeKeys(folder_, {"left"});
  const std::string left = contentOf(folder_ / "left.key");
  const std::string error = refusal([&] { makeKeys(folder_, {"right", "left"}); });
  EXPECT_TRUE(contains(error, "left.crt exists, and nothing is overwritten")) << error;
  EXPECT_EQ(contentOf(folder_ / "left.key"), left);
  EXPECT_FALSE(fs::exists(folder_ / "right.key"));
}

TEST_F(KeyMaker, AFailedWriteLeavesNothingBehind) {
  fs::create_directory(folder_);
  fs::permissions(folder_, fs::perms::owner_all);
  fs::create_symlink("/nonexistent/x", folder_ / "ca.crt");
  const std::string error = refusal([&] { makeKeys(folder_, {"left"}); });
  EXPECT_TRUE(contains(error, "write " + (folder_ / "ca.crt").string())) << error;
  EXPECT_FALSE(fs::exists(folder_ / "ca.key"));
}

TEST_F(KeyMaker, TellsWhyTheDiskTookNotAll) {
  std::string error;
  {
    const SmallFiles limit(16);
    error = refusal([&] { makeKeys(folder_, {"left"}); });
  }
  EXPECT_EQ(error,
            "write " + (folder_ / "ca.key").string() + ": File too large. Give another folder.");
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(KeyMaker, ACaWithoutItsKeyIsRefused) {
  makeKeys(folder_, {"left"});
  fs::remove(folder_ / "ca.key");
  const std::string error = refusal([&] { makeKeys(folder_, {"right"}); });
  EXPECT_TRUE(contains(error, "there is a CA (ca.crt) without its key")) << error;
}

TEST_F(KeyMaker, AFolderOthersEnterIsRefused) {
  fs::create_directory(folder_);
  fs::permissions(folder_, fs::perms::owner_all | fs::perms::group_exec);
  const std::string error = refusal([&] { makeKeys(folder_, {"left"}); });
  EXPECT_EQ(error, "keep keys in " + folder_.string() +
                       ": other users of this machine can enter it. Keep it to its owner: chmod "
                       "700 " +
                       folder_.string());
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(KeyMaker, AFileIsNoFolderForKeys) {
  std::ofstream(folder_) << "no folder";
  EXPECT_EQ(refusal([&] { makeKeys(folder_, {"left"}); }),
            "keep keys in " + folder_.string() + ": it is no folder of yours. Give another.");
  EXPECT_EQ(contentOf(folder_), "no folder");
}

TEST_F(KeyMaker, NamesThatAreNoFilesAreRefused) {
  for (const char* name : {"", "ca", "../left", "a/b", ".left", "left,DNS:right", "l\nt"}) {
    const std::string error = refusal([&] { makeKeys(folder_, {name}); });
    EXPECT_TRUE(contains(error, "its name has to have")) << "'" << name << "': " << error;
  }
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(KeyMaker, AKeyOthersReadIsRefused) {
  makeKeys(folder_, {"left"});
  fs::permissions(folder_ / "left.key", fs::perms::group_read, fs::perm_options::add);
  const std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, "other users of this machine can read it. Make new keys")) << error;
  EXPECT_TRUE(contains(error, "chmod 600 " + (folder_ / "left.key").string())) << error;
}

TEST_F(KeyMaker, AMissingOrBadKeyIsNamed) {
  makeKeys(folder_, {"left", "right"});
  std::string error = refusedUse("middle");
  EXPECT_EQ(error,
            "read " + (folder_ / "middle.crt").string() +
                ": No such file or directory. Make it and its key with `suture keys --process "
                "middle --out " +
                folder_.string() + "`");
  fs::remove(folder_ / "right.key");
  error = refusedUse("right");
  EXPECT_TRUE(contains(error,
                       "right.key: No such file or directory. Remove the certificate beside "
                       "it, and make both with `suture keys --process right --out "))
      << error;
  std::ofstream(folder_ / "left.key") << "no key";
  error = refusedUse("left");
  EXPECT_TRUE(contains(error, "read the key in " + (folder_ / "left.key").string())) << error;
  fs::copy_file(folder_ / "ca.key", folder_ / "right.key", fs::copy_options::overwrite_existing);
  error = refusedUse("right");
  EXPECT_TRUE(contains(error, "not that of the certificate beside it")) << error;
}

TEST_F(KeyMaker, AnotherProcesssCertificateIsNotUsed) {
  makeKeys(folder_, {"left", "right"});
  fs::copy_file(folder_ / "right.crt", folder_ / "left.crt", fs::copy_options::overwrite_existing);
  const std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, "it is that of process 'right'")) << error;
}

TEST_F(KeyMaker, ANamelessCertificateIsNotUsed) {
  makeKeys(folder_, {"left"});
  fs::copy_file(folder_ / "ca.crt", folder_ / "left.crt", fs::copy_options::overwrite_existing);
  std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, ": it names no process. Make one for 'left' with")) << error;
  std::ofstream(folder_ / "left.crt") << "no certificate";
  error = refusedUse("left");
  EXPECT_TRUE(contains(error, "read the certificate in " + (folder_ / "left.crt").string()))
      << error;
}

TEST_F(KeyMaker, AnotherCasCertificateIsNotUsed) {
  makeKeys(folder_, {"left"});
  makeKeys(directory_.path() / "others", {"left"});
  fs::copy_file(directory_.path() / "others/ca.crt", folder_ / "ca.crt",
                fs::copy_options::overwrite_existing);
  const std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, "is not signed by this system's CA")) << error;
}

TEST_F(KeyMaker, AnUntimelyCertificateIsNotUsed) {
  makeKeys(folder_, {"left"}, {.from = -48h, .lasts = std::chrono::days(1)});
  std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, "expired at 2")) << error;
  makeKeys(folder_, {"right"}, {.from = 24h, .lasts = std::chrono::days(1)});
  error = refusedUse("right");
  EXPECT_TRUE(contains(error, "Set the clocks of both machines")) << error;
}

class EndedCa : public KeyMaker {
 protected:
  EndedCa() { makeKeys(folder_, {"left"}, {}, {.from = -48h, .lasts = std::chrono::days(1)}); }
};

TEST_F(EndedCa, IsNamedAndNotACertificate) {
  const std::string error = refusedUse("left");
  EXPECT_TRUE(contains(error, "it is of a CA (ca.crt) that expired at 2")) << error;
  EXPECT_TRUE(contains(error, "make the keys of all processes anew")) << error;
}

TEST_F(EndedCa, MakesNoKeys) {
  const std::string error = refusal([&] { makeKeys(folder_, {"right"}); });
  EXPECT_TRUE(contains(error, "its CA (ca.crt) expired at 2")) << error;
  EXPECT_FALSE(fs::exists(folder_ / "right.crt"));
}

TEST_F(KeyMaker, ACertificateEndsWithItsCa) {
  makeKeys(folder_, {"left"}, {.lasts = std::chrono::days(100)}, {.lasts = std::chrono::days(10)});
  const auto end = [&](const char* file) { return endOf(readCertificate(folder_ / file).get()); };
  EXPECT_EQ(end("left.crt"), end("ca.crt"));
  makeKeys(folder_, {"right"}, {.lasts = std::chrono::days(5)});
  EXPECT_LT(end("right.crt"), end("ca.crt"));
}

TEST_F(KeyMaker, AnEndingCertificateSaysSo) {
  makeKeys(folder_, {"left"});
  EXPECT_EQ(Keys(folder_, "left").warning(), "");
  makeKeys(folder_, {"right"}, {.lasts = std::chrono::days(29)});
  const std::string warning = Keys(folder_, "right").warning();
  const std::string file = (folder_ / "right.crt").string();
  EXPECT_TRUE(warning.starts_with("the certificate " + file + " ends at 2")) << warning;
  EXPECT_TRUE(contains(warning, "Before that, remove the certificate and its key")) << warning;
}

TEST_F(KeyMaker, AnEndingCaSaysSo) {
  makeKeys(folder_, {"left"}, {}, {.lasts = std::chrono::days(29)});
  const std::string warning = Keys(folder_, "left").warning();
  const std::string file = (folder_ / "ca.crt").string();
  EXPECT_TRUE(warning.starts_with("the CA " + file + " ends at 2")) << warning;
  EXPECT_TRUE(contains(warning, "make the keys of all processes anew")) << warning;
}

}  // namespace
}  // namespace suture::tls
