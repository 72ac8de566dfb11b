#include "libvehicle/diagnostics/file_bytes.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

TEST(FileBytes, AreAllThatTheFileHasUpToTheMost) {
  const std::string path = testing::TempDir() + "file_bytes_test.bin";
  const std::string text("a\0\r\nb", 5);
  std::ofstream(path, std::ios::binary) << text;
  EXPECT_EQ(readBytes(path, 5).bytes, text);
  EXPECT_FALSE(readBytes(path, 5).error);
  EXPECT_EQ(readBytes(path, 4).error, std::errc::file_too_large);
  EXPECT_EQ(readBytes(path, 4).bytes, "");
}

TEST(FileBytes, OfADeviceWithoutEndEndAtTheMost) {
  EXPECT_EQ(readBytes("/dev/zero", 1 << 20).error, std::errc::file_too_large);
}

TEST(FileBytes, ThatCannotBeReadHaveTheSystemsReason) {
  EXPECT_EQ(readBytes(testing::TempDir() + "no/such/file", 10).error, std::errc::no_such_file_or_directory);
  EXPECT_EQ(readBytes(testing::TempDir(), 10).error, std::errc::is_a_directory);
}

}  // namespace
}  // namespace vehicle
