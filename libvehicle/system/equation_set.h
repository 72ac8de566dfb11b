#pragma once

#include <string>
#include <vector>

namespace vehicle {

/// One equation of a system that may be cut into equations: the acceleration of one coordinate.
struct Equation {
  std::string name;        // "carbody bounce (2)", "coach_3.front_bogie bounce (4)"
  std::vector<int> reads;  // numbers of the other equations whose q or q' enter this one, ascending
  int first_channel = 0;   // the input channels first .. last-1 enter this one; none where they are equal
  int last_channel = 0;
};

/// Which equations to compute and where their arguments lie. Every array may hold a part of the whole only, so
/// that a thread works on its own memory: x[0] is the displacement of equation `x_first`.
struct EquationWindow {
  int first = 0;                 // equations first .. last-1 are computed
  int last = 0;
  const double* x = nullptr;     // (q, q') of the equations from x_first on, as far as any computed one reads
  int x_first = 0;
  const double* u = nullptr;     // heights of u_count channels from u_first on, then their rates
  int u_first = 0;
  int u_count = 0;
  double* dx = nullptr;          // (q', q'') of the equations from dx_first on; written for first .. last-1 alone
  int dx_first = 0;
};

/// The right-hand side x' = f(x, u) of a second-order system, cut into equations that threads may share.
///
/// State in cut order: equation e owns the entries 2 e (q_e) and 2 e + 1 (q'_e); neighbours along a train are
/// neighbours in memory. An equation gives the same bits whoever computes it and with whichever others: sums inside
/// it run in one order. Immutable: one object serves any number of threads.
class EquationSet {
 public:
  virtual ~EquationSet() = default;

  [[nodiscard]] virtual int channels() const = 0;  // w, of the whole
  [[nodiscard]] virtual const std::vector<Equation>& equations() const = 0;
  [[nodiscard]] int size() const { return 2 * static_cast<int>(equations().size()); }  // n, states

  /// Entry i of the state in cut order is entry stateOrder()[i] of the System's x.
  [[nodiscard]] virtual const std::vector<int>& stateOrder() const = 0;
  /// Channel i in cut order is channel channelOrder()[i] of the System's input.
  [[nodiscard]] virtual const std::vector<int>& channelOrder() const = 0;

  /// Never allocates, never throws.
  virtual void derivative(const EquationWindow& window) const = 0;
};

}  // namespace vehicle
