#include "libvehicle/diagnostics/problem.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace vehicle {

std::string Problem::text() const {
  std::string line;
  if (!place.file.empty()) line = place.line > 0 ? fmt::format("{}:{}: ", place.file, place.line) : place.file + ": ";
  line += "error: ";
  if (!element.empty()) line += element + ": ";
  line += message;
  if (!remedy.empty()) line += "; " + remedy;
  return line;
}

void ProblemList::add(const Place& place, std::string element, std::string message, std::string remedy) {
  Problem& problem = problems_.emplace_back();
  problem.place = place;
  problem.element = std::move(element);
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
}

void ProblemList::append(const ProblemList& other) {
  problems_.insert(problems_.end(), other.problems_.begin(), other.problems_.end());
}

void ProblemList::addNew(const Problem& problem) {
  if (!contains(problem)) add(problem);
}

void ProblemList::addNew(const Place& place, std::string element, std::string message, std::string remedy) {
  ProblemList one;
  one.add(place, std::move(element), std::move(message), std::move(remedy));
  addNew(one.problems_.front());
}

bool ProblemList::contains(const Problem& problem) const {
  return std::any_of(problems_.begin(), problems_.end(),
                     [text = problem.text()](const Problem& each) { return each.text() == text; });
}

void ProblemList::sortByPlace() {
  std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
  });
}

std::string ProblemList::text() const {
  std::string lines;
  for (const Problem& problem : problems_) lines += problem.text() + '\n';
  return lines;
}

InvalidInput::InvalidInput(ProblemList problems)
    : std::runtime_error(problems.text()), problems_(std::move(problems)) {}

namespace {

// Optimal string alignment distance, row by row: an insertion, a removal, another letter, and two neighbours exchanged
// ("falt") count 1 each. L. Boytsov, ACM J. Exp. Algorithmics 16 (2011) 1.1, sec. 2.1.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, substituted});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearestName(const std::string& word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t bestDistance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string unknownName(const std::string& kind, const std::string& word, const std::vector<std::string>& candidates) {
  std::string text = (kind.empty() ? "\"" : kind + " \"") + word + "\" is unknown; ";
  if (const std::optional<std::string> nearest = nearestName(word, candidates))
    return text + "did you mean \"" + *nearest + "\"?";
  text += "choose one of ";
  for (const std::string& candidate : candidates) text += candidate + (&candidate == &candidates.back() ? "" : ", ");
  return text;
}

}  // namespace vehicle
