// SPDX-License-Identifier: MIT
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include <topobag/adaptors/orb_slam/key_frame_pins.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("whoever forgets a pointer waits for older readers alone", "[adaptors]") {
  std::mutex mutex;
  KeyFramePins pins;
  std::atomic<bool> forgotten{false};
  KeyFramePins::Lock lock(mutex);
  auto reader = std::make_unique<KeyFramePins::Scope>(pins, lock);
  CHECK_FALSE(lock.owns_lock());

  std::thread forgetting([&] {
    KeyFramePins::Lock own(mutex);
    pins.wait_for_older(own);
    forgotten = true;
  });
  // A reader that came later must not hold the other up; whether it is later is up to the
  // scheduler, which is why nothing waits on it.
  KeyFramePins::Lock later_lock(mutex);
  auto later = std::make_unique<KeyFramePins::Scope>(pins, later_lock);
  CHECK_FALSE(forgotten);
  reader.reset();
  later.reset();
  forgetting.join();
  CHECK(forgotten);

  // With a reader that is surely later: none older is open, so there is nothing to wait for.
  KeyFramePins::Lock free_lock(mutex);
  pins.wait_for_older(free_lock);
  CHECK(free_lock.owns_lock());
}
