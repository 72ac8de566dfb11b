#include "libvehicle/ensemble/block_rows.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

namespace vehicle::ensemble {
namespace {

constexpr int kMassRows = 4;  // mk, Jk, m1, m2

std::array<double, kCoefficientRows> numbersOf(const FlatCoefficients<double>& p) {
  return {p.inv_mk, p.inv_Jk, p.inv_m1, p.inv_m2, p.lf,  p.lr,  p.ck1, p.bk1,  p.ck2,  p.bk2,  p.cb1, p.bb1,
          p.cb2,    p.bb2,    p.cb3,    p.bb3,    p.cb4, p.bb4, p.cb12, p.bb12, p.cb34, p.bb34, p.kg};
}
static_assert(sizeof(FlatCoefficients<double>) == kCoefficientRows * sizeof(double));

bool isIn(FlatColumn column, FlatColumn first, FlatColumn last) { return first <= column && column <= last; }

}  // namespace

ColumnChoice::ColumnChoice(std::span<const FlatColumn> columns) {
  for (const FlatColumn column : columns) {
    const int number = static_cast<int>(column);
    if (number < 0 || number >= kFlatColumns) {
      throw std::invalid_argument("ensemble: column number " + std::to_string(number) + ", must be 0.." +
                                  std::to_string(kFlatColumns - 1));
    }
    columns_.push_back(number);
    flags_.accelerations |= isIn(column, FlatColumn::kCarbodyAz, FlatColumn::kCarbodyPitchAcc) ||
                            column == FlatColumn::kFrontBogieAz || column == FlatColumn::kRearBogieAz;
    flags_.secondaries |= isIn(column, FlatColumn::kSecondaryFrontDeflection, FlatColumn::kSecondaryRearForce);
    flags_.wheels |= isIn(column, FlatColumn::kPrimary1Deflection, FlatColumn::kWheel4Load);
    flags_.points |= column >= FlatColumn::kFirstPoint;
  }
}

Choice ColumnChoice::get() const {
  Choice choice = flags_;
  choice.columns = columns_.data();
  choice.count = count();
  return choice;
}

BlockRows::BlockRows(std::span<const EnsembleDesign> designs, std::span<const int> order, int lanes, int columns,
                     int packs)
    : lanes_(lanes),
      used_(static_cast<int>(order.size())),
      columns_(columns),
      blocks_((used_ + packs * lanes - 1) / (packs * lanes) * packs),
      coefficients_(offset(blocks_, kCoefficientRows)),
      extra_(offset(blocks_, kExtraRows)),
      masses_(offset(blocks_, kMassRows)),
      state_(offset(blocks_, kStateRows)),
      metrics_(offset(blocks_, columns * kMetricRows)),
      range_(offset(blocks_, kRangeRows)),
      failed_(offset(blocks_, 1)) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto width = static_cast<std::size_t>(lanes);
  for (int b = 0; b < blocks_; ++b) {
    for (int lane = 0; lane < lanes; ++lane) {
      const int place = std::min(b * lanes + lane, used_ - 1);
      const EnsembleDesign& design = designs[static_cast<std::size_t>(order[static_cast<std::size_t>(place)])];
      const auto set = [&](AlignedDoubles& rows, int rows_of_block, int row, double value) {
        rows[offset(b, rows_of_block) + static_cast<std::size_t>(row) * width + static_cast<std::size_t>(lane)] = value;
      };
      const auto setAll = [&](AlignedDoubles& rows, int rows_of_block, int first, const auto& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
          set(rows, rows_of_block, first + static_cast<int>(i), values[i]);
        }
      };
      const FlatParameters& v = design.vehicle;
      setAll(coefficients_, kCoefficientRows, 0, numbersOf(coefficientsOf(v)));
      setAll(extra_, kExtraRows, kLoadRow, design.wheel_load);
      setAll(extra_, kExtraRows, kMassRow, design.wheelset_mass);
      setAll(extra_, kExtraRows, kArmRow, design.point_arm);
      setAll(masses_, kMassRows, 0, std::array<double, 4>{v.mk, v.Jk, v.m1, v.m2});
      setAll(state_, kStateRows, 0, design.start);
      for (int k = 0; k < columns; ++k) {
        set(metrics_, columns * kMetricRows, k * kMetricRows + 2, kInfinity);
        set(metrics_, columns * kMetricRows, k * kMetricRows + 3, -kInfinity);
      }
      set(range_, kRangeRows, 0, kInfinity);
      set(failed_, 1, 0, kInfinity);
    }
  }
}

std::size_t BlockRows::offset(int block, int rows) const {
  return static_cast<std::size_t>(block) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(lanes_);
}

Block BlockRows::block(int index) {
  return {.coefficients = coefficients_.data() + offset(index, kCoefficientRows),
          .extra = extra_.data() + offset(index, kExtraRows),
          .state = state_.data() + offset(index, kStateRows),
          .metrics = metrics_.data() + offset(index, columns_ * kMetricRows),
          .range = range_.data() + offset(index, kRangeRows),
          .failed = failed_.data() + offset(index, 1),
          .stored = nullptr};
}

SteadyBlock BlockRows::steadyBlock(int index) {
  return {.coefficients = coefficients_.data() + offset(index, kCoefficientRows),
          .extra = extra_.data() + offset(index, kExtraRows),
          .masses = masses_.data() + offset(index, kMassRows),
          .motion = nullptr,
          .amplitude = nullptr,
          .metrics = metrics_.data() + offset(index, columns_ * kMetricRows),
          .range = range_.data() + offset(index, kRangeRows)};
}

double BlockRows::metric(int lane, int column, int metric) const {
  const int row = column * kMetricRows + metric;
  return metrics_[offset(lane / lanes_, columns_ * kMetricRows) +
                  static_cast<std::size_t>(row) * static_cast<std::size_t>(lanes_) +
                  static_cast<std::size_t>(lane % lanes_)];
}

double BlockRows::range(int lane, int row) const {
  return range_[offset(lane / lanes_, kRangeRows) + static_cast<std::size_t>(row) * static_cast<std::size_t>(lanes_) +
                static_cast<std::size_t>(lane % lanes_)];
}

double BlockRows::failedAt(int lane) const { return failed_[static_cast<std::size_t>(lane)]; }

}  // namespace vehicle::ensemble
