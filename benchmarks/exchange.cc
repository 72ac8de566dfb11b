// What it costs threads to wait for each other and nothing else: everybody shows one value and looks at everybody
// else's, for each waiting policy and against the barriers that the system and the language bring.
//
// The floor is the time a cache line takes from one core to another, measured in the same run by two threads that
// answer each other ("line_one_way": half a round trip). The last table gives every policy as a multiple of it.
//
// A step of Runge-Kutta exchanges four times: "step_of_4_exchanges" is what it costs before anything is computed, and
// what a trace of every step or of every 16th adds to it; its floor is four ways of a line. With more threads than
// cores "one_handover_of_a_core" is the floor of an exchange: two threads of one core that yield it to each other.

#include <pthread.h>

#include <atomic>
#include <barrier>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "benchmarks/measure.h"
#include "libvehicle/threads/exchange.h"
#include "libvehicle/threads/placement.h"
#include "libvehicle/threads/team.h"

namespace vehicle::bench {
namespace {

constexpr long kExchanges = 2000;  // of a batch: milliseconds, so that the start does not count

// Runs `meet(me, epoch)` for every epoch on every member; the wall time [s] of member 0.
template <class Meet>
double timeOf(int threads, const TeamPolicy& policy, Meet meet) {
  double took = 0.0;
  runTeam(threads, policy, [&](Member& me) {
    meet(me, 1L);  // all stand and have their lines
    const double begin = wallSeconds();
    for (long epoch = 2; epoch < kExchanges + 2; ++epoch) meet(me, epoch);
    if (me.number() == 0) took = wallSeconds() - begin;
  });
  return took;
}

void showAndLook(Exchange& exchange, Member& me, long epoch) {
  *exchange.slot(me.number(), epoch) = static_cast<double>(epoch);
  exchange.publish(me, epoch);
  for (int other = 0; other < me.threads(); ++other) {
    if (other == me.number()) continue;
    const double seen = *exchange.await(me, other, epoch);
    if (seen != static_cast<double>(epoch)) throw std::logic_error("a wrong value was delivered");
  }
}

double ours(int threads, const std::string& waiting) {
  Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 1));
  return timeOf(threads, {.waiting = waitingKindOf(waiting)},
                [&](Member& me, long epoch) { showAndLook(exchange, me, epoch); });
}

double stepOfFour(int threads, Tracer* tracer) {
  Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 1));
  return timeOf(threads, {.tracer = tracer}, [&](Member& me, long step) {
    me.beginStep(step);
    for (long epoch = 4 * step - 3; epoch <= 4 * step; ++epoch) showAndLook(exchange, me, epoch);
    me.endStep(step);
  });
}

double tracedStep(int threads, int every) {
  Tracer tracer(every);
  return stepOfFour(threads, &tracer);
}

double stdBarrier(int threads) {
  std::barrier barrier(threads);
  return timeOf(threads, {}, [&](Member&, long) { barrier.arrive_and_wait(); });
}

// The last to arrive opens the next epoch; the others sleep on it.
double atomicWait(int threads) {
  alignas(64) std::atomic<int> arrived{0};
  alignas(64) std::atomic<long> open{0};
  return timeOf(threads, {}, [&](Member&, long epoch) {
    if (arrived.fetch_add(1, std::memory_order_acq_rel) == threads - 1) {
      arrived.store(0, std::memory_order_relaxed);
      open.store(epoch, std::memory_order_release);
      open.notify_all();
    } else {
      open.wait(epoch - 1, std::memory_order_acquire);
    }
  });
}

double pthreadBarrier(int threads) {
  pthread_barrier_t barrier;
  pthread_barrier_init(&barrier, nullptr, static_cast<unsigned>(threads));
  const std::unique_ptr<pthread_barrier_t, int (*)(pthread_barrier_t*)> owner(&barrier, pthread_barrier_destroy);
  return timeOf(threads, {}, [&](Member&, long) { pthread_barrier_wait(&barrier); });
}

// Two threads answer each other, each on a line of its own: a round trip is two ways.
double lineOneWay() {
  struct alignas(128) Line {
    std::atomic<long> epoch{0};
  };
  Line lines[2];
  const double round_trips = timeOf(2, {}, [&](Member& me, long epoch) {
    const auto await = [&](int whom) {
      while (lines[whom].epoch.load(std::memory_order_acquire) < epoch) pauseCore();
    };
    if (me.number() == 1) await(0);
    lines[me.number()].epoch.store(epoch, std::memory_order_release);
    if (me.number() == 0) await(1);
  });
  return 0.5 * round_trips;
}

// Two threads of one core give it to each other: what every exchange costs at least where threads take turns.
double coreHandover() {
  const int cores = static_cast<int>(allowedCores().size());
  alignas(128) std::atomic<long> turn{0};
  double took = 0.0;
  runTeam(cores + 1, {}, [&](Member& me) {
    if (me.number() != 0 && me.number() != cores) return;
    const long mine = me.number() == 0 ? 0 : 1;
    const double begin = wallSeconds();
    for (long i = 0; i < kExchanges; ++i) {
      while (turn.load(std::memory_order_acquire) != 2 * i + mine) std::this_thread::yield();
      turn.store(2 * i + mine + 1, std::memory_order_release);
    }
    if (mine == 0) took = wallSeconds() - begin;
  });
  return 0.5 * took;
}

const bool kRegistered = registerForThreads([](const std::vector<int>& thread_counts) {
  const int cores = static_cast<int>(allowedCores().size());
  for (const int threads : thread_counts) {
    const std::string where = std::to_string(threads) + "_threads_" + std::to_string(cores) + "_cores/";
    std::string problem = "exchange_" + where;
    const auto add = [&](const std::string& solver, auto batch) {
      compare((problem + solver).c_str(),
              [=](benchmark::State& state) { measureWall(state, threads, kExchanges, batch); });
    };
    for (const std::string& waiting : waitingNames()) {
      if (waiting == "spin" && threads > cores) continue;  // refused, see waitingFor()
      add("ours_" + waiting, [=] { return ours(threads, waiting); });
    }
    add("std_barrier", [=] { return stdBarrier(threads); });
    add("std_atomic_wait", [=] { return atomicWait(threads); });
    add("pthread_barrier", [=] { return pthreadBarrier(threads); });
    if (cores >= 2) add("line_one_way", [] { return lineOneWay(); });

    if (threads > cores) add("one_handover_of_a_core", [] { return coreHandover(); });

    problem = "step_of_4_exchanges_" + where;
    add("ours", [=] { return stepOfFour(threads, nullptr); });
    add("ours_traced_every_16th", [=] { return tracedStep(threads, 16); });
    add("ours_traced_every_step", [=] { return tracedStep(threads, 1); });
    if (cores >= 2) add("four_lines_one_way", [] { return 4.0 * lineOneWay(); });
  }
});

}  // namespace
}  // namespace vehicle::bench
