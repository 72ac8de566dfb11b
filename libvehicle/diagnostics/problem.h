#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vehicle {

/// Where something was written. Line 0: the file as a whole; empty file name: not read from a file.
struct Place {
  std::string file;
  int line = 0;
};

/// One thing that is wrong with an input, worded so that a stranger can fix it.
struct Problem {
  Place place;
  std::string element;  // path of the element, e.g. "<vehicle><body>"; may be empty
  std::string message;  // what stands there and which rule it breaks
  std::string remedy;   // what to write instead; may be empty

  /// One line that editors turn into a link:  FILE:LINE: error: ELEMENT: MESSAGE; REMEDY
  [[nodiscard]] std::string text() const;
};

/// All problems of an input, in the order in which they stand in the file.
class ProblemList {
 public:
  void add(Problem problem) { problems_.push_back(std::move(problem)); }
  /// The same from its parts, for texts made on the spot: g++ 12 takes a Problem braced of them for one half made.
  void add(const Place& place, std::string element, std::string message, std::string remedy);
  void append(const ProblemList& other);
  /// Unless it is among them already.
  void addNew(const Problem& problem);
  void addNew(const Place& place, std::string element, std::string message, std::string remedy);
  [[nodiscard]] bool contains(const Problem& problem) const;
  /// Sorts by file and line, keeping the order of equals: checks run in passes, readers read from the top.
  void sortByPlace();

  [[nodiscard]] bool empty() const { return problems_.empty(); }
  [[nodiscard]] std::size_t size() const { return problems_.size(); }
  [[nodiscard]] const Problem& operator[](std::size_t i) const { return problems_[i]; }
  [[nodiscard]] auto begin() const { return problems_.begin(); }
  [[nodiscard]] auto end() const { return problems_.end(); }

  /// All lines, one a problem, each ended by a newline.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<Problem> problems_;
};

/// Thrown by `orThrow()` and by whoever cannot go on with a wrong input; carries every problem.
class InvalidInput : public std::runtime_error {
 public:
  explicit InvalidInput(ProblemList problems);
  [[nodiscard]] const ProblemList& problems() const { return problems_; }

 private:
  ProblemList problems_;
};

/// A run that started and could not be finished (NaN, step size at zero, a disk that is full).
class RunFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a reader gives: a value, or the problems that prevented it.
template <class T>
struct Outcome {
  std::optional<T> value;
  ProblemList problems;

  [[nodiscard]] bool ok() const { return value.has_value() && problems.empty(); }
  /// @throws InvalidInput with all problems unless ok()
  [[nodiscard]] T orThrow() && {
    if (!ok()) throw InvalidInput(std::move(problems));
    return std::move(*value);
  }
};

/// The candidate nearest to `word` by edit distance, if any is near enough to be what was meant
/// (at most a third of the word's length, at least 1 edit allowed; two neighbouring letters exchanged are one edit).
[[nodiscard]] std::optional<std::string> nearestName(const std::string& word,
                                                     const std::vector<std::string>& candidates);

/// What to say of a name that is none of the candidates:  KIND "WORD" is unknown; did you mean "NEAREST"?  -- or, where
/// none is near,  ...; choose one of A, B, C.  An empty kind is left out.
[[nodiscard]] std::string unknownName(const std::string& kind, const std::string& word,
                                      const std::vector<std::string>& candidates);

}  // namespace vehicle
