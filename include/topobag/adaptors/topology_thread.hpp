// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <topobag/assert.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What a full queue does with one key frame more.
enum class WhenFull {
  drop_oldest,  ///< the one that waits longest is given up: tracking never waits
  refuse,       ///< the new one is given up: `push` is false
  wait,         ///< `push` waits for room: nothing is given up, tracking may stall
};

/// How much may wait, and what then.
struct TopologyThreadOptions {
  std::size_t capacity = 8;                    ///< key frames that may wait, >= 1
  WhenFull when_full = WhenFull::drop_oldest;  ///< what gives way
};

/// What became of the key frames that were handed over.
/// pushed = processed + failed + given_up + those that wait or are being worked on.
struct TopologyThreadCounts {
  std::size_t pushed = 0;     ///< handed over, taken or not
  std::size_t processed = 0;  ///< the work returned
  std::size_t failed = 0;     ///< the work threw
  std::size_t given_up = 0;   ///< dropped, refused, forgotten by `reset` or left by `stop`
};

/// The semantic topology graph thread: works on key frames beside tracking, one after the other, in
/// the order they came.
///
/// `Input` is what the work needs of a key frame: its id and images, which it must own. The work
/// runs the detector, lifts, and hands the nodes on (`OrbSlamDatabase::observe`); what it throws is
/// counted and told, and the thread goes on. `on_lost` hears of every key frame that came to
/// nothing, with the reason, on the thread that lost it; it tells who waits for the key frame
/// (`OrbSlamDatabase::give_up`), and must not call back or throw.
template <typename Input>
class TopologyThread {
 public:
  /// What is done with a key frame, on the thread.
  using Work = std::function<void(const Input&)>;
  /// Hears what came to nothing.
  using OnLost = std::function<void(const Input&, const std::string& why)>;

  /// Throws InvalidValue for a capacity of 0.
  explicit TopologyThread(Work work, TopologyThreadOptions options = {}, OnLost on_lost = {})
      : work_(std::move(work)), on_lost_(std::move(on_lost)), options_(options) {
    if (options.capacity == 0) throw InvalidValue("the queue of a topology thread needs room");
    thread_ = std::thread([this] { run(); });
  }

  TopologyThread(const TopologyThread&) = delete;
  TopologyThread& operator=(const TopologyThread&) = delete;
  ~TopologyThread() { stop(); }

  /// Hands a key frame over. False when it was given up: the queue was full under
  /// `WhenFull::refuse`, or the thread was reset or stopped meanwhile.
  bool push(Input input) {
    std::optional<Input> lost;
    const char* why = "the queue is full";
    bool taken = true;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      const std::uint64_t generation = generation_;
      ++counts_.pushed;
      if (options_.when_full == WhenFull::wait) {
        room_.wait(lock, [&] {
          return stopped_ || generation_ != generation || waiting_.size() < options_.capacity;
        });
      }
      if (stopped_ || generation_ != generation) {
        taken = false;
        why = stopped_ ? "the thread has stopped" : "the map was reset";
      } else if (waiting_.size() >= options_.capacity) {
        taken = options_.when_full == WhenFull::drop_oldest;
        if (taken) {
          lost = std::move(waiting_.front());
          waiting_.pop_front();
        }
      }
      if (!taken) {
        lost = std::move(input);
      } else {
        waiting_.push_back(std::move(input));
      }
      if (lost) ++counts_.given_up;
    }
    work_waits_.notify_one();
    if (lost) tell(*lost, why);
    return taken;
  }

  /// Forgets the key frames that wait, and returns when the one at work is done: afterwards no work
  /// on anything pushed before goes on. Not to be called by the work itself.
  void reset() {
    TOPOBAG_ASSERT(std::this_thread::get_id() != thread_.get_id());
    std::unique_lock<std::mutex> lock(mutex_);
    ++generation_;
    const std::deque<Input> lost = forget_waiting();
    room_.notify_all();
    idle_.wait(lock, [this] { return !busy_; });
    lock.unlock();
    for (const Input& input : lost) tell(input, "the map was reset");
  }

  /// Returns when nothing waits and nothing is being worked on.
  void wait_idle() {
    TOPOBAG_ASSERT(std::this_thread::get_id() != thread_.get_id());
    std::unique_lock<std::mutex> lock(mutex_);
    idle_.wait(lock, [this] { return !busy_ && waiting_.empty(); });
  }

  /// Ends the thread after the key frame at work; those that wait are given up. Call it before the
  /// host shuts down; the destructor does. May be called twice, not by the work itself.
  void stop() {
    TOPOBAG_ASSERT(std::this_thread::get_id() != thread_.get_id());
    std::deque<Input> lost;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopped_ = true;
      lost = forget_waiting();
    }
    work_waits_.notify_all();
    room_.notify_all();
    for (const Input& input : lost) tell(input, "the thread has stopped");
    if (thread_.joinable()) thread_.join();
  }

  /// As they stand now.
  TopologyThreadCounts counts() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
  }

 private:
  void run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      work_waits_.wait(lock, [this] { return stopped_ || !waiting_.empty(); });
      if (stopped_) return;
      const Input input = std::move(waiting_.front());
      waiting_.pop_front();
      busy_ = true;
      room_.notify_one();
      lock.unlock();
      const std::optional<std::string> failure = failure_of(input);
      if (failure) tell(input, *failure);
      lock.lock();
      busy_ = false;
      ++(failure ? counts_.failed : counts_.processed);
      idle_.notify_all();
    }
  }

  std::optional<std::string> failure_of(const Input& input) const {
    try {
      work_(input);
      return std::nullopt;
    } catch (const std::exception& error) {
      return error.what();
    } catch (...) {
      return "the work threw something that is not a std::exception";
    }
  }

  std::deque<Input> forget_waiting() {
    counts_.given_up += waiting_.size();
    idle_.notify_all();  // the thread may not have noticed that anything waited
    return std::exchange(waiting_, {});
  }

  void tell(const Input& input, const std::string& why) const {
    if (on_lost_) on_lost_(input, why);
  }

  const Work work_;
  const OnLost on_lost_;
  const TopologyThreadOptions options_;

  mutable std::mutex mutex_;
  std::condition_variable work_waits_, room_, idle_;
  std::deque<Input> waiting_;
  TopologyThreadCounts counts_;
  std::uint64_t generation_ = 0;  ///< goes up with every reset
  bool busy_ = false;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace v0
}  // namespace topobag
