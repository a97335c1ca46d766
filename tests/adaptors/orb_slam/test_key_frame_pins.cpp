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
  std::atomic<bool> forgetting_locked{false}, forgotten{false};
  KeyFramePins::Lock lock(mutex);
  auto reader = std::make_unique<KeyFramePins::Scope>(pins, lock);
  CHECK_FALSE(lock.owns_lock());

  std::thread forgetting([&] {
    KeyFramePins::Lock own(mutex);
    forgetting_locked = true;
    pins.wait_for_older(own);
    forgotten = true;
  });
  // A reader that came later must not hold the other up: the lock is free again only once that
  // one waits.
  while (!forgetting_locked) std::this_thread::yield();
  KeyFramePins::Lock later_lock(mutex);
  auto later = std::make_unique<KeyFramePins::Scope>(pins, later_lock);
  CHECK_FALSE(forgotten);
  reader.reset();
  forgetting.join();
  CHECK(forgotten);
}
