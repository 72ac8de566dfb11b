#include "libvehicle/study/execute/work_pool.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "libvehicle/threads/refused_thread.h"

namespace vehicle {

WorkPool::WorkPool(const Evaluator& evaluator, int threads)
    : evaluator_(evaluator),
      batch_size_(std::max<std::int64_t>(1, evaluator.batchSize())),
      given_(evaluator.given()),
      most_finished_(2 * static_cast<std::size_t>(threads) + 2) {
  for (int i = 0; i < threads; ++i) shares_.push_back(std::make_unique<Share>());
  try {
    for (std::size_t i = 0; i < shares_.size(); ++i) threads_.emplace_back([this, i] { work(i); });
  } catch (const std::system_error& refused) {
    const std::size_t number = threads_.size() + 1;
    close();  // those that stand already wait for work, and would be waited for
    throw std::runtime_error(refusedThread(number, threads, refused));
  } catch (...) {
    close();
    throw;
  }
}

WorkPool::~WorkPool() { close(); }

void WorkPool::close() {
  abandoned_ = true;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  work_came_.notify_all();
  room_came_.notify_all();
  threads_.clear();
}

void WorkPool::add(std::span<const DesignSpan> ranges, std::span<const double> given) {
  std::int64_t total = 0;
  for (const DesignSpan& range : ranges) total += range.size();
  if (total == 0) return;
  {
    // Counted before it can be claimed.
    const std::lock_guard lock(mutex_);
    outstanding_ += total;
    unclaimed_ += total;
    abandoned_ = failure_ != nullptr;
  }
  const auto threads = static_cast<std::int64_t>(shares_.size());
  std::int64_t dealt = 0;
  std::size_t owner = 0;
  for (const DesignSpan& range : ranges) {
    Piece rest{range, given.subspan(static_cast<std::size_t>(dealt) * given_,
                                    static_cast<std::size_t>(range.size()) * given_)};
    while (rest.range.size() > 0) {
      const std::int64_t end = total * static_cast<std::int64_t>(owner + 1) / threads;  // of this owner's share
      if (dealt == end) {
        ++owner;
        continue;
      }
      const Piece piece = cutFront(rest, std::min(end - dealt, rest.range.size()));
      dealt += piece.range.size();
      Share& share = *shares_[owner];
      const std::lock_guard lock(share.mutex);
      share.pieces.push_back(piece);
      share.designs += piece.range.size();
    }
  }
  work_came_.notify_all();
}

std::optional<Batch> WorkPool::take(std::chrono::milliseconds wait) {
  std::unique_lock lock(mutex_);
  batch_came_.wait_for(lock, wait, [this] { return !finished_.empty() || outstanding_ == 0; });
  if (finished_.empty()) {
    if (outstanding_ == 0 && failure_) std::rethrow_exception(failure_);
    return std::nullopt;
  }
  Batch batch = std::move(finished_.front());
  finished_.pop_front();
  outstanding_ -= batch.range.size();
  lock.unlock();
  room_came_.notify_one();
  return batch;
}

void WorkPool::recycle(Batch batch) {
  const std::lock_guard lock(mutex_);
  if (spares_.size() < most_finished_) spares_.push_back(std::move(batch));
}

void WorkPool::abandon() { abandoned_ = true; }

std::int64_t WorkPool::outstanding() const {
  const std::lock_guard lock(mutex_);
  return outstanding_;
}

void WorkPool::work(std::size_t self) {
  std::unique_ptr<Worker> worker;
  try {
    worker = evaluator_.worker();
  } catch (...) {
    fail(0);
  }
  Piece piece;
  while (claim(self, piece)) {
    try {
      Batch batch = spare();
      batch.reset(piece.range, evaluator_.columns());
      worker->evaluate({piece.range, piece.given}, batch);
      if (!deliver(std::move(batch))) return;
    } catch (...) {
      fail(piece.range.size());
    }
  }
}

// Waits for work; what is claimed of abandoned work is dropped here. False: the pool closes.
bool WorkPool::claim(std::size_t self, Piece& piece) {
  for (;;) {
    const bool found = cutOwn(self, piece) || (steal(self) && cutOwn(self, piece));
    std::unique_lock lock(mutex_);
    if (found) {
      unclaimed_ -= piece.range.size();
      if (!abandoned_) return true;
      outstanding_ -= piece.range.size();
      const bool last = outstanding_ == 0;
      lock.unlock();
      if (last) batch_came_.notify_all();
      continue;
    }
    work_came_.wait(lock, [this] { return closing_ || unclaimed_ > 0; });
    if (closing_) return false;
    // Something unclaimed that was not found is on its way between two threads.
    lock.unlock();
    std::this_thread::yield();
  }
}

bool WorkPool::cutOwn(std::size_t self, Piece& piece) {
  Share& share = *shares_[self];
  const std::lock_guard lock(share.mutex);
  if (share.pieces.empty()) return false;
  Piece& front = share.pieces.front();
  const std::int64_t designs = abandoned_ ? front.range.size() : std::min(batch_size_, front.range.size());
  piece = cutFront(front, designs);
  if (front.range.size() == 0) share.pieces.pop_front();
  share.designs -= designs;
  return true;
}

bool WorkPool::steal(std::size_t self) {
  const auto most = std::max_element(shares_.begin(), shares_.end(), [](const auto& a, const auto& b) {
    return a->designs.load(std::memory_order_relaxed) < b->designs.load(std::memory_order_relaxed);
  });
  Share& victim = **most;
  std::vector<Piece> loot;  // from the back, last piece first
  std::int64_t stolen = 0;
  {
    const std::lock_guard lock(victim.mutex);
    const std::int64_t half = (victim.designs + 1) / 2;
    // Whole batches, at least one.
    const std::int64_t wanted = std::min((half + batch_size_ - 1) / batch_size_ * batch_size_, victim.designs.load());
    while (stolen < wanted) {
      Piece& back = victim.pieces.back();
      if (back.range.size() <= wanted - stolen) {
        loot.push_back(back);
        victim.pieces.pop_back();
      } else {
        const Piece kept = cutFront(back, back.range.size() - (wanted - stolen));
        loot.push_back(back);
        back = kept;
      }
      stolen += loot.back().range.size();
    }
    victim.designs -= stolen;
  }
  if (stolen == 0) return false;
  Share& own = *shares_[self];
  const std::lock_guard lock(own.mutex);
  own.pieces.insert(own.pieces.end(), loot.rbegin(), loot.rend());
  own.designs += stolen;
  return true;
}

// Takes so many designs from the front of a piece.
WorkPool::Piece WorkPool::cutFront(Piece& piece, std::int64_t designs) const {
  const std::size_t numbers = static_cast<std::size_t>(designs) * given_;
  const Piece front{{piece.range.first, piece.range.first + designs}, piece.given.first(numbers)};
  piece.range.first += designs;
  piece.given = piece.given.subspan(numbers);
  return front;
}

Batch WorkPool::spare() {
  const std::lock_guard lock(mutex_);
  if (spares_.empty()) return {};
  Batch batch = std::move(spares_.back());
  spares_.pop_back();
  return batch;
}

bool WorkPool::deliver(Batch batch) {
  {
    std::unique_lock lock(mutex_);
    room_came_.wait(lock, [this] { return closing_ || finished_.size() < most_finished_; });
    if (closing_) return false;
    finished_.push_back(std::move(batch));
  }
  batch_came_.notify_one();
  return true;
}

void WorkPool::fail(std::int64_t designs) {
  {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
    if (!failure_) failure_ = std::current_exception();
    outstanding_ -= designs;
  }
  batch_came_.notify_all();
}

}  // namespace vehicle
