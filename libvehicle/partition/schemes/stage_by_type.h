#pragma once

// The stage exchange of a small system whose equations the compiler sees: between the look that finds the others'
// values and the store that shows one's own stand the equations' own operations and nothing else. With four equations
// the loops, windows and virtual calls of the general member cost more than the equations.
//
// 1. Which equations a thread has is a template argument: all arrays are registers, and the operations of other
//    threads' equations are never emitted.
// 2. Others' values go from their line straight into the equations; pointers to them are made once.
// 3. The expressions are those of rk4_stages.h and of the serial right-hand side, to the letter.

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "libvehicle/integrate/tableau.h"
#include "libvehicle/partition/schemes/stage_walk.h"

namespace vehicle {

/// One thread's equations, by type.
/// @tparam Rhs   x' = f(x, u) with x = (q, q'), u = (heights, rates), equations and channels in cut order; kStates
/// @tparam kOwn  bit e: equation e is this thread's
template <class Rhs, unsigned kOwn>
class TypedStageMember {
 public:
  static constexpr std::size_t kEquations = Rhs::kStates / 2;

  TypedStageMember(const Rhs& rhs, const StageSeat& seat)
      : rhs_(rhs), me_(seat.me), exchange_(seat.exchange), part_(seat.part) {
    std::copy_n(seat.cut.x0().begin(), x_.size(), x_.begin());
    for (std::size_t parity = 0; parity < 2; ++parity) {
      from_[parity].fill(nothing_.data());
      to_[parity].fill(nothing_.data());
      double* slot = exchange_.slot(me_.number(), static_cast<long>(parity));
      for (const EquationRun& run : part_.shown) {
        for (int e = run.first; e < run.last; ++e, slot += 2) to_[parity][static_cast<std::size_t>(e)] = slot;
      }
      for (const StagePlan::Source& source : part_.sources) {
        const double* shown = exchange_.slot(source.owner, static_cast<long>(parity));
        for (const ShownPiece& piece : source.pieces) {
          for (int i = 0; i < piece.count; ++i) {
            from_[parity][static_cast<std::size_t>(piece.first + i)] = shown + piece.slot + 2 * i;
          }
        }
      }
    }
  }

  template <class Rows>
  void step(double h, Rows& rows) {
    me_.beginStep(epoch_ / 4);
    State x{}, s{}, k{}, sum{};
    every<true>([&](auto e) { x.set(e, x_[2 * e], x_[2 * e + 1]); });
    if (epoch_ > 0) {
      take(x);  // the start is known to all
    } else {
      every<false>([&](auto e) { x.set(e, x_[2 * e], x_[2 * e + 1]); });
    }
    evaluate(x, rows.row(0), k);
    entries([&](auto i) { s[i] = x[i] + h * kRk4.a[1][0] * k[i]; });
    show(s);
    entries([&](auto i) { sum[i] = kRk4.b[0] * k[i]; });
    rows.afterStage(0);
    take(s);
    evaluate(s, rows.row(1), k);
    entries([&](auto i) { s[i] = x[i] + h * kRk4.a[2][1] * k[i]; });
    show(s);
    entries([&](auto i) { sum[i] += kRk4.b[1] * k[i]; });
    rows.afterStage(1);
    take(s);
    evaluate(s, rows.row(1), k);
    entries([&](auto i) { s[i] = x[i] + h * kRk4.a[3][2] * k[i]; });
    show(s);
    entries([&](auto i) { sum[i] += kRk4.b[2] * k[i]; });
    rows.afterStage(2);
    take(s);
    evaluate(s, rows.row(2), k);
    entries([&](auto i) { x[i] += h * (sum[i] + kRk4.b[3] * k[i]); });
    show(x);
    every<true>([&](auto e) {
      x_[2 * e] = x.q[e];
      x_[2 * e + 1] = x.v[e];
    });
    rows.afterStage(3);
    me_.endStep(epoch_ / 4 - 1);
  }

  const double* x(int equation) const { return &x_[2 * static_cast<std::size_t>(equation)]; }

 private:
  // Entry 2 e is q of equation e, 2 e + 1 its q'. Indices are constants, so that no array is left.
  struct State {
    std::array<double, kEquations> q, v;
    void set(std::size_t e, double displacement, double velocity) {
      q[e] = displacement;
      v[e] = velocity;
    }
    double& operator[](std::size_t i) { return i % 2 == 0 ? q[i / 2] : v[i / 2]; }
  };
  static constexpr bool isOwn(std::size_t e) { return (kOwn >> e & 1u) != 0; }

  /// visit(e) for all own (or all other) equations, e a constant.
  template <bool kOwnOnes, class Visit>
  [[gnu::always_inline]] static void every(Visit visit) {
    [&]<std::size_t... E>(std::index_sequence<E...>) {
      const auto one = [&](auto e) {
        if constexpr (isOwn(e) == kOwnOnes) visit(e);
      };
      (one(std::integral_constant<std::size_t, E>{}), ...);
    }(std::make_index_sequence<kEquations>{});
  }
  template <class Visit>
  [[gnu::always_inline]] static void entries(Visit visit) {
    every<true>([&](auto e) {
      visit(std::integral_constant<std::size_t, 2 * e>{});
      visit(std::integral_constant<std::size_t, 2 * e + 1>{});
    });
  }

  [[gnu::always_inline]] void evaluate(const State& s, const double* u, State& slope) const {
    double x[2 * kEquations];
    double dx[2 * kEquations];
    // Entry by entry: a loop would be made wide copies, through memory and between a look and the next store.
    const auto copy = [&](auto e) {
      x[e] = s.q[e];
      x[e + kEquations] = s.v[e];
    };
    every<true>(copy);
    every<false>(copy);
    rhs_(x, u, dx);
    every<true>([&](auto e) { slope.set(e, dx[e], dx[e + kEquations]); });
  }

  [[gnu::always_inline]] void show(State& s) {
    ++epoch_;
    if (part_.sources.empty()) return;
    const auto& to = to_[static_cast<std::size_t>(epoch_ & 1)];
    every<true>([&](auto e) {
      to[e][0] = s.q[e];
      to[e][1] = s.v[e];
    });
    exchange_.publish(me_, epoch_);
  }

  [[gnu::always_inline]] void take(State& s) {
    // A copy, made before the look: looked up after it, the pointers would stand between it and the equations.
    const std::array<const double*, kEquations> from = from_[static_cast<std::size_t>(epoch_ & 1)];
    for (const StagePlan::Source& source : part_.sources) (void)exchange_.await(me_, source.owner, epoch_);
    every<false>([&](auto e) { s.set(e, from[e][0], from[e][1]); });
  }

  Rhs rhs_;
  Member& me_;
  Exchange& exchange_;
  const StagePlan::Part& part_;
  std::array<double, 2 * kEquations> x_{};  // in cut order; own entries move
  std::array<double, 2> nothing_{};         // equations that are not read, or not shown
  std::array<std::array<const double*, kEquations>, 2> from_{};  // by parity of the epoch
  std::array<std::array<double*, kEquations>, 2> to_{};
  long epoch_ = 0;  // stages done
};

/// runStageExchange() for a system whose equations are also there by type: the same bits, sooner.
/// @param rhs  gives the bits of system.equations(), which has Rhs::kStates / 2 equations, at most four
/// @throws as runPartitioned(), and std::invalid_argument for another number of equations
template <class Rhs>
PartitionRun runStageExchangeByType(const Rhs& rhs, const System& system, const Input& input, const Schedule& schedule,
                                    FixedStep step, std::span<const double> x0, const Observer& observe,
                                    const PartitionChoice& choice) {
  constexpr std::size_t kEquations = Rhs::kStates / 2;
  static_assert(kEquations <= 4, "each share of the equations is a program of its own: 2^kEquations of them");
  if (equationsOf(system).equations().size() != kEquations) {
    throw std::invalid_argument("stage exchange by type: the right-hand side has " + std::to_string(kEquations) +
                                " equations, the system " + std::to_string(equationsOf(system).equations().size()));
  }
  return runStages(system, input, schedule, step, x0, observe, choice, true, [&](const StageSeat& seat, auto walk) {
    unsigned own = 0;
    for (const int e : seat.part.share) own |= 1u << e;
    bool whole = false;
    [&]<std::size_t... Own>(std::index_sequence<Own...>) {
      const auto sitIf = [&](auto mask) {
        if (own != mask) return;
        TypedStageMember<Rhs, static_cast<unsigned>(mask)> work(rhs, seat);
        whole = walk(work);
      };
      (sitIf(std::integral_constant<std::size_t, Own + 1>{}), ...);
    }(std::make_index_sequence<(1u << kEquations) - 1>{});
    return whole;
  });
}

}  // namespace vehicle
