#include <cstring>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/ensemble/steady.h"
#include "tests/ensemble/designs.h"

namespace vehicle::test {
namespace {

constexpr std::size_t kCount = 60;
constexpr std::size_t kShare = 7;  // designs a call: no multiple of any register

bool sameBits(const std::vector<ColumnSummary>& a, const std::vector<ColumnSummary>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(ColumnSummary)) == 0;
}

// Nothing is shared between calls, and no lane looks at another: equality is exact.
TEST(EnsembleThreads, GiveTheBitsOfOneThread) {
  const std::vector<EnsembleDesign> designs = asymmetricDesigns(kCount);
  const Input rail = railOf({.end = 0.5, .onset = true});
  const std::vector<const Input*> rails(kCount, &rail);
  const InputSegment harmonic = railOf({}).segment(0);
  const InputSegment* one = &harmonic;
  EnsembleRun run;
  run.columns = {FlatColumn::kCarbodyAz, FlatColumn::kWheel3Load};
  const SteadyRun steady{.columns = run.columns};
  const std::vector<ColumnSummary> shared = runEnsemble(designs, rail, run).summaries;
  const std::vector<ColumnSummary> each = runEnsemble(designs, rails, run).summaries;
  const std::vector<ColumnSummary> closed = steadyEnsemble(designs, {&one, 1}, steady).summaries;

  std::vector<ColumnSummary> of_shared(2 * kCount), of_each(2 * kCount), of_closed(2 * kCount);
  const auto work = [&](std::size_t first, std::size_t stride) {
    for (std::size_t begin = first * kShare; begin < kCount; begin += stride * kShare) {
      const std::size_t count = std::min(kShare, kCount - begin);
      const std::span<const EnsembleDesign> some = std::span(designs).subspan(begin, count);
      const auto put = [&](const std::vector<ColumnSummary>& from, std::vector<ColumnSummary>& to) {
        std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(2 * begin));
      };
      put(runEnsemble(some, rail, run).summaries, of_shared);
      put(runEnsemble(some, std::span(rails).subspan(begin, count), run).summaries, of_each);
      put(steadyEnsemble(some, {&one, 1}, steady).summaries, of_closed);
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 3; ++i) threads.emplace_back(work, i, 3);
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(sameBits(of_shared, shared));
  EXPECT_TRUE(sameBits(of_each, each));
  EXPECT_TRUE(sameBits(of_closed, closed));
}

}  // namespace
}  // namespace vehicle::test
