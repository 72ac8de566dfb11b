#include "tests/architecture/measured.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/architecture/results.h"
#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"

namespace vehicle::test {
namespace {

std::string lines(const Violations& violations) {
  std::string text;
  for (const std::string& line : violations) text += line + '\n';
  return text;
}

// ---- this tree

// VEHICLE_CORRECT_PAGES=1 writes the numbers of the results into the pages, after a new measurement.
TEST(MeasuredNumbers, OfThePagesAreThoseOfTheResults) {
  const bool correct = std::getenv("VEHICLE_CORRECT_PAGES") != nullptr;
  EXPECT_EQ(lines(wrongNumbers(sourcePath(), correct ? Pages::kCorrect : Pages::kJudge)), "");
}

TEST(MeasuredNumbers, AreOfCommitsThatCanBeMeasuredAgain) { EXPECT_EQ(lines(untraceableResults(sourcePath())), ""); }

// ---- the judges themselves

class MadeUpPages : public ::testing::Test {
 protected:
  MadeUpPages() {
    folder_.file("benchmarks/results/vm/bench_step.csv",
                 "problem,solver,median_ns,commit\nrk4,ours,64.066,1a2b3c4\nrk4,theirs,180.4,1a2b3c4\n"
                 "run,ours,1816300,1a2b3c4\n");
    folder_.file("benchmarks/results/vm/bench_study.csv",
                 "designs,threads,seconds,commit\n1000,2,3.248,1a2b3c4\n1000,2,3.665,1a2b3c4\n");
    page(
        "## Fast\n\n| what | ours | theirs | ratio |\n|---|---|---|---|\n| a step | 64 ns | 180 ns | 0.36 |\n\n## "
        "Slow\n");
    numbers(
        "  covers ## Fast\n  | a step | {step:rk4:ours} ns | {step:rk4:theirs} ns | "
        "{step:rk4:ours / step:rk4:theirs} |\n");
  }
  void page(const std::string& text) const { folder_.file("README.md", text); }
  void numbers(const std::string& text) const {
    folder_.file("benchmarks/results/printed_numbers.txt", "# where numbers come from\nmachine vm\nREADME.md\n" + text);
  }
  std::string wrong(Pages pages = Pages::kJudge) const { return lines(wrongNumbers(folder_.root(), pages)); }
  std::string pageNow() const { return textOf(folder_.path("README.md")); }

  TestFolder folder_;
};

TEST_F(MadeUpPages, ThatPrintTheResultsAreRight) { EXPECT_EQ(wrong(), ""); }

TEST_F(MadeUpPages, ANumberThatIsNotThatOfTheResultsIsNamedWithItsLineAndSource) {
  page("## Fast\n\n| what | ours | theirs | ratio |\n|---|---|---|---|\n| a step | 66 ns | 180 ns | 0.36 |\n");
  EXPECT_EQ(wrong(), "README.md:5: prints 66, step:rk4:ours is 64\n");
}

TEST_F(MadeUpPages, NumbersAreCorrectedInPlaceAndInTheirStyle) {
  page("## Fast\n\n| what | ours | theirs | ratio |\n|---|---|---|---|\n| a step | 66 ns | 2 180 ns | 0.99 |\n");
  EXPECT_NE(wrong(Pages::kCorrect), "");
  EXPECT_EQ(wrong(), "");
  EXPECT_EQ(pageNow(),
            "## Fast\n\n| what | ours | theirs | ratio |\n|---|---|---|---|\n| a step | 64 ns | 180 ns | 0.36 |\n");
}

TEST_F(MadeUpPages, TextMayBeWrappedAnywhere) {
  page("## Fast\n\nA step takes\n64 ns, a\nrun 1.82 ms and\nstudies 3.2 to 3.7 s.\n");
  numbers(
      "  A step takes {step:rk4:ours} ns, a run {step:run:ours ms} ms and studies {study:1000:2#1@seconds} to "
      "{study:1000:2#2@seconds} s.\n");
  EXPECT_EQ(wrong(), "");
}

TEST_F(MadeUpPages, ARowWithoutASourceIsFound) {
  page(
      "## Fast\n\n| what | ours |\n|---|---|\n| a step | 64 ns | 180 ns | 0.36 |\n| a flight | 1 ns |\n\n## Slow\n\n"
      "| what | ours |\n|---|---|\n| a walk | 5 s |\n");
  EXPECT_EQ(wrong(), "README.md:6: this row has no source in benchmarks/results/printed_numbers.txt\n");
}

TEST_F(MadeUpPages, WordsThatAreGoneAndRowsThatAreNotThereAreNamed) {
  numbers(
      "  | a stride | {step:rk4:ours} ns |\n  covers ## Fast\n  | a step | {step:rk4:mine} ns | {study:1000:2@seconds} "
      "ns |\n"
      "  covers ## Quick\n");
  EXPECT_EQ(
      wrong(),
      "benchmarks/results/printed_numbers.txt:4: README.md has no such words\n"
      "benchmarks/results/printed_numbers.txt:6: the results have no step:rk4:mine: there is no such row\n"
      "benchmarks/results/printed_numbers.txt:6: the results have no study:1000:2@seconds: several rows begin so; "
      "write #1, #2, ...\n"
      "benchmarks/results/printed_numbers.txt: README.md has no heading ## Quick\n");
}

TEST_F(MadeUpPages, ResultsOfAModifiedTreeOrOfNoneAreNamedByTheirFile) {
  EXPECT_EQ(lines(untraceableResults(folder_.root())), "");
  folder_.file("benchmarks/results/vm/bench_a.csv",
               "problem,ns,commit\na,1,1a2b3c4\nb,2,9f8e7d6-dirty\nc,3,9f8e7d6-dirty\nd,4,\n");
  folder_.file("benchmarks/results/vm/bench_b.csv", "problem,ns\na,1\n");
  EXPECT_EQ(
      lines(untraceableResults(folder_.root())),
      "benchmarks/results/vm/bench_a.csv:5: 1 rows are of no commit; measure them again from a clean one\n"
      "benchmarks/results/vm/bench_a.csv:3: 2 rows are of the modified tree 9f8e7d6-dirty; measure them again from a "
      "clean one\n"
      "benchmarks/results/vm/bench_b.csv:1: no column says of which commit these results are\n");
}

TEST(PrintedNumber, KnowsWhatItsLastDigitStandsFor) {
  const auto half = [](const char* text) { return printedNumber(text).half_unit; };
  EXPECT_EQ(printedNumber("8 017").value, 8017.0);
  EXPECT_EQ(half("8 017"), 0.5);
  EXPECT_EQ(half("15 210"), 5.0);
  EXPECT_EQ(half("125 000"), 500.0);
  EXPECT_EQ(half("100"), 0.5);
  EXPECT_DOUBLE_EQ(half("0.27"), 0.005);
  EXPECT_DOUBLE_EQ(half("1.0"), 0.05);
}

TEST(PrintedNumber, IsWrittenAnewWithAsManyDigits) {
  EXPECT_EQ(printedLike("66", 64.066), "64");
  EXPECT_EQ(printedLike("0.99", 0.3551), "0.36");
  EXPECT_EQ(printedLike("1.24", 0.03551), "0.0355");
  EXPECT_EQ(printedLike("15 210", 9876.54), "9 877");
  EXPECT_EQ(printedLike("9 877", 15208.35), "15 210");
  EXPECT_EQ(printedLike("309 000", 307882.1), "308 000");
  EXPECT_EQ(printedLike("0.0004", 0.000374), "0.00037");
}

TEST(ValueOf, KnowsFactorsQuotientsAndUnits) {
  const TestFolder folder;
  folder.file("bench_a.csv", "problem,median_ns\nx,2000\ny,500\n");
  const Results results({folder.root()});
  EXPECT_EQ(valueOf("a:x", results), 2000.0);
  EXPECT_EQ(valueOf("a:x us", results), 2.0);
  EXPECT_EQ(valueOf("a:x / a:y", results), 4.0);
  EXPECT_EQ(valueOf("a:x / 4 * a:y", results), 1.0);
  EXPECT_EQ(valueOf("0.5 * a:y / a:x %", results), 12.5);
  EXPECT_THROW(static_cast<void>(valueOf("b:x", results)), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
