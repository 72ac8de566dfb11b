#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/storage/hdf5.h"
#include "tests/storage/histories.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::numberedHistory;
using test::TestFolder;

TEST(Hdf5, ThreadsTakeTurns) {
  const TestFolder scratch;
  const auto work = [&scratch](int number) {
    for (int i = 0; i < 20; ++i) {
      const auto path = scratch.path(std::to_string(number) + ".h5");
      writeHdf5({numberedHistory(number, 100), {}, {}}, path);
      EXPECT_EQ(readHdf5(path).orThrow().history.at(99, 1), number);
    }
  };
  std::thread first(work, 1);
  std::thread second(work, 2);
  first.join();
  second.join();
}

}  // namespace
}  // namespace vehicle
