#pragma once

#include <vector>

namespace vehicle {

/// Equations first .. first+count-1 of one owner, neighbours in its slot of the exchange as in a reader's state.
struct ShownPiece {
  int slot = 0;   // of the owner's slot [doubles]
  int first = 0;  // equation
  int count = 0;
};

/// Adds an equation, to the last piece where it continues that.
inline void addShown(std::vector<ShownPiece>& pieces, int slot, int equation) {
  if (!pieces.empty()) {
    ShownPiece& last = pieces.back();
    if (last.first + last.count == equation && last.slot + 2 * last.count == slot) {
      ++last.count;
      return;
    }
  }
  pieces.push_back({slot, equation, 1});
}

}  // namespace vehicle
