// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "../../../examples/orb_slam/hooks/SemanticHooks.h"
#include "catch.hpp"

namespace {

struct HookedMap {};

struct HookedKeyFrame {
  HookedMap* map = nullptr;
  HookedMap* GetMap() const { return map; }
};

struct HookedFrame {};

using Hooks = topobag_hooks::SemanticHooks<HookedKeyFrame, HookedFrame>;

/// Knows the key frames that it was told of.
struct Listener final : Hooks::Observer {
  std::multiset<const HookedKeyFrame*> told;
  std::vector<HookedKeyFrame*> found;

  void FrameMade(HookedFrame&, const cv::Mat&, const cv::Mat&) override {}
  void KeyFrameMade(HookedKeyFrame*) override {}
  void Added(HookedKeyFrame* key_frame) override { told.insert(key_frame); }
  void Erased(HookedKeyFrame* key_frame) override { told.erase(key_frame); }
  void Cleared() override { told.clear(); }
  void LoopCandidates(HookedKeyFrame*, std::vector<HookedKeyFrame*>& candidates) override {
    candidates.insert(candidates.end(), found.begin(), found.end());
  }
  void RelocalizationCandidates(HookedFrame*, std::vector<HookedKeyFrame*>&, const void*) override {
  }
  Places RelocalizationPlaces() override { return {}; }
  void PlacesTried(int) override {}
};

using Told = std::multiset<const HookedKeyFrame*>;

}  // namespace

TEST_CASE("an observer that comes late is told of the key frames that are there", "[hooks]") {
  HookedMap one, other;
  HookedKeyFrame a{&one}, b{&one}, c{&other}, d{&other}, e{&one};
  Hooks hooks;
  for (HookedKeyFrame* key_frame : {&a, &b, &c}) hooks.Added(key_frame);
  hooks.Erased(&b);
  Listener listener;
  hooks.SetObserver(&listener);
  CHECK(listener.told == Told{&a, &c});
  hooks.Added(&d);
  CHECK(listener.told == Told{&a, &c, &d});

  hooks.SetObserver(nullptr);
  hooks.ClearedMap(&other);
  hooks.Added(&e);
  Listener next;
  hooks.SetObserver(&next);
  CHECK(next.told == Told{&a, &e});
  hooks.Cleared();
  Listener last;
  hooks.SetObserver(&last);
  CHECK(last.told.empty());
}

TEST_CASE("without an observer the hooks leave the host as it is", "[hooks]") {
  Hooks hooks;
  HookedKeyFrame key_frame, found;
  HookedFrame frame;
  std::vector<HookedKeyFrame*> candidates{&key_frame};
  hooks.FrameMade(frame, {}, {});
  hooks.KeyFrameMade(&key_frame);
  hooks.LoopCandidates(&key_frame, candidates);
  hooks.MergeCandidates(&key_frame, candidates);
  hooks.RelocalizationCandidates(&frame, candidates);
  CHECK(candidates == std::vector<HookedKeyFrame*>{&key_frame});
  CHECK(hooks.MergePlaces().empty());
  CHECK(hooks.RelocalizationPlaces().empty());

  Listener listener;
  listener.found = {&found};
  hooks.SetObserver(&listener);
  hooks.LoopCandidates(&key_frame, candidates);
  CHECK(candidates == std::vector<HookedKeyFrame*>{&key_frame, &found});
}

TEST_CASE("an observer that comes while key frames are added misses none", "[hooks]") {
  std::vector<HookedKeyFrame> key_frames(500);
  for (int round = 0; round < 20; ++round) {
    Hooks hooks;
    std::atomic<bool> begun{false};
    std::thread host([&] {
      for (HookedKeyFrame& key_frame : key_frames) {
        hooks.Added(&key_frame);
        begun = true;
      }
    });
    while (!begun) std::this_thread::yield();
    struct Set final : topobag_hooks::SemanticObserver<HookedKeyFrame, HookedFrame> {
      std::mutex mutex;
      std::set<const HookedKeyFrame*> told;
      void FrameMade(HookedFrame&, const cv::Mat&, const cv::Mat&) override {}
      void KeyFrameMade(HookedKeyFrame*) override {}
      void Added(HookedKeyFrame* key_frame) override {
        const std::lock_guard<std::mutex> lock(mutex);
        told.insert(key_frame);
      }
      void Erased(HookedKeyFrame*) override {}
      void Cleared() override {}
      void LoopCandidates(HookedKeyFrame*, std::vector<HookedKeyFrame*>&) override {}
      void RelocalizationCandidates(HookedFrame*, std::vector<HookedKeyFrame*>&,
                                    const void*) override {}
      Places RelocalizationPlaces() override { return {}; }
      void PlacesTried(int) override {}
    } listener;
    hooks.SetObserver(&listener);
    host.join();
    CHECK(listener.told.size() == key_frames.size());
  }
}

namespace {

/// Stays in a call until it is let go.
struct SlowListener final : Hooks::Observer {
  std::atomic<bool> entered{false}, go{false}, ended{false};

  void FrameMade(HookedFrame&, const cv::Mat&, const cv::Mat&) override {}
  void KeyFrameMade(HookedKeyFrame*) override {}
  void Added(HookedKeyFrame*) override {}
  void Erased(HookedKeyFrame*) override {}
  void Cleared() override {}
  void LoopCandidates(HookedKeyFrame*, std::vector<HookedKeyFrame*>&) override {
    entered = true;
    while (!go) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ended = true;
  }
  void RelocalizationCandidates(HookedFrame*, std::vector<HookedKeyFrame*>&, const void*) override {
  }
  Places RelocalizationPlaces() override { return {}; }
  void PlacesTried(int) override {}
};

}  // namespace

TEST_CASE("an observer that is taken away is in no call any more", "[hooks]") {
  Hooks hooks;
  SlowListener listener;
  hooks.SetObserver(&listener);
  HookedKeyFrame key_frame;
  std::thread host([&] {
    std::vector<HookedKeyFrame*> candidates;
    hooks.LoopCandidates(&key_frame, candidates);
  });
  while (!listener.entered) std::this_thread::yield();
  listener.go = true;
  hooks.SetObserver(nullptr);
  CHECK(listener.ended);
  host.join();
}

TEST_CASE("observers come, go and are deleted while the host calls them", "[hooks]") {
  Hooks hooks;
  std::atomic<bool> finished{false};
  std::vector<std::thread> host;
  for (int thread = 0; thread < 2; ++thread) {
    host.emplace_back([&] {
      HookedKeyFrame key_frame;
      while (!finished) {
        std::vector<HookedKeyFrame*> candidates;
        hooks.LoopCandidates(&key_frame, candidates);
        hooks.PlacesTried(-1);
        std::this_thread::yield();
      }
    });
  }
  for (int round = 0; round < 200; ++round) {
    const auto listener = std::make_unique<Listener>();
    hooks.SetObserver(listener.get());
    std::this_thread::yield();
    hooks.SetObserver(nullptr);
  }
  finished = true;
  for (std::thread& thread : host) thread.join();
  std::vector<HookedKeyFrame*> candidates;
  hooks.LoopCandidates(nullptr, candidates);
  CHECK(candidates.empty());
}
