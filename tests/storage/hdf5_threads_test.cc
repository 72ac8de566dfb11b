#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/storage/hdf5.h"
#include "tests/storage/scratch.h"

namespace vehicle {
namespace {

using test::numberedHistory;
using test::Scratch;

TEST(Hdf5, ThreadsTakeTurns) {
  const Scratch scratch;
  const auto work = [&scratch](int number) {
    for (int i = 0; i < 20; ++i) {
      const auto path = scratch / (std::to_string(number) + ".h5");
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
