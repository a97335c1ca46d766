// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet/enlist_with_server.hpp>
#include <topobag/adaptors/fleet/fleet_options.hpp>
#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/fleet_view.hpp>
#include <topobag/adaptors/fleet/push.hpp>
#include <topobag/adaptors/postgres.hpp>
#include <topobag/bag/bag_reader.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

namespace topobag {
inline namespace v0 {

/// All key frames of chosen sites, of all robots, on any number of servers, in one bag in memory:
/// looked up exactly and near the asker, kept up to date by `follow`.
///
///     FleetBag fleet({{"postgresql://site.example/fleet", {"hall", "yard"}}});
///     for (;; fleet.wait()) fleet.follow();             // one thread
///     const auto now = fleet.view();                    // any thread, at any time
///     for (const Candidate& c : now->query(graph)) tell(now->key(c.id), c.similarity);
///
/// One thread at a time may call what is not const; the const calls ask the view of now.
/// `Relocalizer<FleetBag>` localizes in it.
class FleetBag : public BagReader<FleetBag, FleetView> {
 public:
  using Graph = FleetView::Graph;

  /// Connects when it is asked to.
  explicit FleetBag(std::vector<FleetSource> sources, FleetOptions options = {})
      : options_(std::move(options)), bag_({}, options_.views), shown_(std::make_unique<Shown>()) {
    if (options_.classes) options_.catalog = fingerprint(options_.classes->catalog);
    for (FleetSource& source : sources) {
      feeds_.push_back({PostgresStore(std::move(source.conninfo), options_.silence), {}});
      for (std::string& site : source.sites) feeds_.back().sites[std::move(site)];
      feeds_.back().store.listen();
    }
  }

  /// Takes in what is new on every server; returns how many versions. When a server cannot be
  /// asked, what the others had is in, and Error tells of the first that failed; the next call goes
  /// on where this one stopped, over a new connection. So it is with a site that says something
  /// else of the options' classes: nothing of it is taken, and FormatError tells what.
  std::size_t follow() {
    std::size_t taken = 0;
    std::exception_ptr failure;
    for (Feed& feed : feeds_) {
      try {
        for (auto& [site, followed] : feed.sites) {
          try {
            taken += follow_site(feed.store, site, followed);
          } catch (const FormatError&) {
            if (!failure) failure = std::current_exception();
          }
        }
      } catch (const Error&) {
        if (!failure) failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
    return taken;
  }

  /// What a server says of the classes of a site that is followed there, the first that says more
  /// than their fingerprint; nothing where none does. Throws as `PostgresStore::site_catalog`.
  std::optional<DescribedCatalog> site_catalog(const std::string& site) {
    for (Feed& feed : feeds_) {
      if (feed.sites.count(site) == 0) continue;
      if (auto classes = feed.store.site_catalog(site)) return classes;
    }
    return std::nullopt;
  }

  /// Waits until a server says that there is something new, or the time is up: then `follow` is
  /// worth a call anyway, for what committed behind another transaction. Whether one has said so.
  bool wait(std::chrono::milliseconds time = std::chrono::milliseconds(500)) {
    std::vector<::pollfd> sockets;
    for (Feed& feed : feeds_) {
      if (feed.store.socket() < 0) continue;
      try {
        if (feed.store.notified()) return true;
      } catch (const Error&) {
        return true;  // `follow` will say it, or connect again
      }
      sockets.push_back({feed.store.socket(), POLLIN, 0});
    }
    const int ready =
        ::poll(sockets.data(), static_cast<nfds_t>(sockets.size()), static_cast<int>(time.count()));
    return ready > 0;
  }

  /// The bag as it is now. Thread-safe; O(1).
  std::shared_ptr<const FleetView> view() const {
    // In this order: a session is shown before its first key frame is.
    auto bag = bag_.view();
    const std::lock_guard<std::mutex> lock(shown_->mutex);
    return std::make_shared<const FleetView>(std::move(bag), shown_->sessions);
  }

  /// Why versions could not be taken, a sentence each. They harm no others, and a later version of
  /// their key frame replaces them; until then the one before stands.
  const std::vector<std::string>& refused() const noexcept { return refused_; }

 private:
  struct FollowedSite {
    FleetCursor cursor;
    bool agreed = false;  ///< its classes are the options', as far as it says
  };
  struct Feed {
    PostgresStore store;
    std::map<std::string, FollowedSite> sites;  ///< by name
  };
  /// What readers share with the thread that follows.
  struct Shown {
    std::mutex mutex;
    std::shared_ptr<const FleetView::Sessions> sessions =
        std::make_shared<const FleetView::Sessions>();
  };

  std::size_t follow_site(PostgresStore& store, const std::string& site, FollowedSite& followed) {
    std::size_t taken = 0;
    // Pages grow: the server sorts a transaction anew for each, and a replica's first copy is one.
    for (std::size_t page_size = 5000;; page_size = std::min<std::size_t>(2 * page_size, 40000)) {
      FleetCursor next = followed.cursor;
      const std::vector<ReadVersion> page = store.read(site, next, page_size);
      // Once they are read: what a site says of its classes, it has said before its first version.
      if (options_.classes && !followed.agreed) store.require_classes(site, *options_.classes);
      followed.agreed = followed.agreed || !page.empty();
      note_sessions(page);
      for (const ReadVersion& read : page) taken += std::size_t{take(read)};
      followed.cursor = next;  // acknowledged: all of the page is in
      if (page.empty()) return taken;
    }
  }

  /// Whether it was new: a version may come twice, from two servers or over a new connection, and
  /// an earlier one after a later one.
  bool take(const ReadVersion& read) {
    const FleetVersion& version = read.version;
    const KeyframeId id = id_of(version.key);
    const auto [known, first] = last_seq_.emplace(id, version.seq);
    if (!first && known->second >= version.seq) return false;
    known->second = version.seq;
    if (version.tombstone && read.fault.empty()) {
      bag_.erase(id);
      return true;
    }
    try {
      if (!read.fault.empty()) throw FormatError(read.fault);
      put(id, version);
    } catch (const Error& error) {
      refused_.push_back("site '" + version.key.site + "', robot " + to_text(version.key.robot) +
                         ", key frame " + std::to_string(value(version.key.keyframe)) + ": " +
                         error.what());
    }
    return true;
  }

  void put(KeyframeId id, const FleetVersion& version) {
    if (options_.catalog != 0 && version.catalog != options_.catalog) {
      throw FormatError("its class numbers mean other names than yours");
    }
    EntryInfo info = version.info();
    info.session = static_cast<std::uint32_t>(value(id) >> 32);
    const Graph graph = decode(version.graph);
    if (bag_.contains(id)) {
      bag_.update(id, graph, info);
    } else {
      bag_.add(id, graph, info);
    }
  }

  using SessionKey = std::tuple<std::string, Uuid, Uuid, std::uint32_t>;
  static SessionKey session_of(const FleetKey& key) {
    return {key.site, key.robot, key.session,
            static_cast<std::uint32_t>(value(key.keyframe) >> 32)};
  }

  /// Numbers the sessions that are new, and shows them before their key frames.
  void note_sessions(const std::vector<ReadVersion>& page) {
    auto sessions = std::make_shared<FleetView::Sessions>();
    for (const ReadVersion& read : page) {
      const FleetKey& key = read.version.key;
      const SessionKey session = session_of(key);
      if (!numbers_.try_emplace(session, numbers_.size()).second) continue;
      if (sessions->empty()) *sessions = *shown_->sessions;
      sessions->push_back(
          {key.site, key.robot, key.session, std::get<3>(session), read.version.run});
    }
    if (sessions->empty()) return;
    const std::lock_guard<std::mutex> lock(shown_->mutex);
    shown_->sessions = std::move(sessions);
  }

  /// The session's number and the lower half of the robot's own: no two key frames share an id.
  /// Precondition: the session is noted.
  KeyframeId id_of(const FleetKey& key) const {
    return KeyframeId{std::uint64_t{numbers_.at(session_of(key))} << 32 |
                      (value(key.keyframe) & 0xFFFFFFFF)};
  }

  FleetOptions options_;
  std::vector<Feed> feeds_;
  IndexedBag bag_;
  std::map<SessionKey, std::size_t> numbers_;
  std::unordered_map<KeyframeId, std::int64_t> last_seq_;  ///< of every key frame ever met
  std::vector<std::string> refused_;
  std::unique_ptr<Shown> shown_;
};

}  // namespace v0
}  // namespace topobag
