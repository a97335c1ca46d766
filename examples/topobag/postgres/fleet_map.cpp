// SPDX-License-Identifier: MIT
#include "fleet_map.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>

#include <topobag/adaptors/fleet_bag.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "input_error.hpp"

namespace program {
namespace {

/// The sites of the address, or all that may be read. Throws InputError where there are none.
std::vector<std::string> sites_of(const FleetAddress& address, topobag::PostgresStore& store) {
  const std::vector<std::string> known = store.site_names();
  if (known.empty()) {
    throw InputError(
        "the server has no site that this role may read: its owner makes one with `topobag fleet "
        "init`, and lets roles read it with `topobag fleet admit`");
  }
  for (const std::string& site : address.sites) {
    if (std::find(known.begin(), known.end(), site) != known.end()) continue;
    throw InputError("the server has no site '" + site +
                     "' that this role may read; `topobag fleet status` names those that it has");
  }
  return address.sites.empty() ? known : address.sites;
}

/// What became of key frames that could not be taken, in one sentence.
std::string refusal_text(const std::vector<std::string>& refused) {
  if (refused.size() == 1) return refused.front();
  return std::to_string(refused.size()) + " key frames cannot be taken, the first of " +
         refused.front();
}

/// What the first of the sites that says so keeps of its classes.
std::optional<topobag::DescribedCatalog> kept_at(const std::vector<std::string>& sites,
                                                 topobag::PostgresStore& store) {
  for (const std::string& site : sites) {
    if (auto kept = store.site_catalog(site)) return kept;
  }
  return std::nullopt;
}

/// Throws FormatError for a site that says something else of classes of the same names; those of
/// other names are told by what is pushed or read.
void require_same(const std::string& site, const topobag::DescribedCatalog& classes,
                  topobag::PostgresStore& store) {
  const auto kept = store.site_catalog(site);
  if (!kept || topobag::fingerprint(kept->catalog) != topobag::fingerprint(classes.catalog)) return;
  if (const auto what = topobag::difference(*kept, classes)) {
    throw topobag::FormatError("site '" + site + "': " + *what +
                               "; take the classes that it was made with");
  }
}

topobag::FleetBag bag_of(const FleetAddress& address, const ObjectClasses& given) {
  topobag::PostgresStore store(address.conninfo);
  const std::vector<std::string> sites = sites_of(address, store);
  ObjectClasses classes = given;
  if (may_adopt(given)) {
    if (const auto kept = kept_at(sites, store)) classes = adopted(given, *kept, sites.front());
  }
  for (const std::string& site : sites) require_same(site, described(classes), store);
  topobag::FleetOptions options;
  options.catalog = topobag::fingerprint(classes.catalog);
  return topobag::FleetBag({{address.conninfo, sites}}, options);
}

/// The site that a robot maps. Throws InputError unless the server has it.
std::string only_site(const FleetAddress& address, topobag::PostgresStore& store) {
  if (address.sites.size() == 1) return sites_of(address, store).front();
  throw InputError("the address names " + std::to_string(address.sites.size()) +
                   " sites; a robot maps one: give one site=NAME");
}

std::optional<topobag::Uuid> robot_of(const FleetAddress& address) {
  if (address.robot.empty()) return std::nullopt;
  return topobag::parse_uuid(address.robot);
}

std::string name_of(const topobag::FleetSession& session) {
  return session.site + ", robot " + topobag::to_text(session.robot).substr(0, 8) +
         (session.run.empty() ? "" : ", " + session.run);
}

}  // namespace

std::optional<topobag::DescribedCatalog> fleet_map_classes(const std::string& text) {
  const FleetAddress address = parse_fleet_address(text);
  topobag::PostgresStore store(address.conninfo);
  return kept_at(sites_of(address, store), store);
}

SavedMap read_fleet_map(const std::string& address, const ObjectClasses& classes) {
  topobag::FleetBag fleet = bag_of(parse_fleet_address(address), classes);
  fleet.follow();
  if (!fleet.refused().empty()) throw InputError(address, refusal_text(fleet.refused()));
  const auto view = fleet.view();
  SavedMap saved{"PostgreSQL, schema " + std::to_string(topobag::postgres_schema_version),
                 {},
                 topobag::BagOfTopologyGraphs<>()};
  std::map<std::uint32_t, std::uint32_t> numbers;  // sessions by their keys, as the key frames are
  view->for_each([&](const topobag::FleetKey&, topobag::EntryInfo info, const auto& graph) {
    const auto [number, first] =
        numbers.emplace(info.session, static_cast<std::uint32_t>(numbers.size()));
    if (first) {
      saved.sessions.push_back({number->second, name_of(view->sessions()[info.session])});
    }
    info.session = number->second;
    saved.bag.add(topobag::KeyframeId{saved.bag.size()}, graph, std::move(info));
  });
  return saved;
}

void extend_fleet_map(const std::string& text, const std::string& session,
                      const topobag::BagOfTopologyGraphs<>& entries, const ObjectClasses& classes) {
  const FleetAddress address = parse_fleet_address(text);
  topobag::PostgresStore store(address.conninfo);
  const std::string site = only_site(address, store);
  require_same(site, described(classes), store);
  const topobag::Uuid robot = robot_of(address).value_or(topobag::random_uuid());
  const topobag::Uuid run = topobag::random_uuid();
  std::vector<topobag::FleetVersion> versions;
  entries.for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info, const auto& graph) {
    topobag::FleetVersion version = topobag::version_of({site, robot, run, id}, info, graph);
    version.seq = static_cast<std::int64_t>(versions.size()) + 1;
    version.run = session;
    version.catalog = topobag::fingerprint(classes.catalog);
    versions.push_back(std::move(version));
  });
  store.append(versions);
}

void prepare_fleet(const FleetAddress& address, const ObjectClasses& classes) {
  topobag::PostgresStore store(address.conninfo);
  store.prepare();
  const std::uint64_t catalog = topobag::fingerprint(classes.catalog);
  std::set<std::string> known;
  for (const topobag::FleetSite& site : store.sites()) {
    known.insert(site.name);
    const bool named = std::count(address.sites.begin(), address.sites.end(), site.name) > 0;
    if (!named || classes.file.empty() || site.catalog == catalog) continue;
    throw InputError(classes.file, "site '" + site.name +
                                       "' exists with other classes, which are for ever; give "
                                       "another site=NAME");
  }
  for (const std::string& site : address.sites) {
    if (known.insert(site).second) store.add_site(site, described(classes));
  }
}

void admit_to_fleet(const FleetAddress& address, const std::string& role) {
  if (address.sites.empty()) throw InputError("the address names no site; give site=NAME");
  const auto robot = robot_of(address);
  topobag::PostgresStore store(address.conninfo);
  const std::vector<std::string> sites = sites_of(address, store);
  if (!store.has_role(role)) {
    throw InputError("--role " + role,
                     "the server has no role '" + role + "'; CREATE ROLE makes one");
  }
  for (const std::string& site : sites) store.admit(role, site, robot);
}

std::size_t push_to_fleet(const FleetAddress& address, const std::string& map) {
  topobag::PostgresStore store(address.conninfo);
  const std::string site = only_site(address, store);
  if (auto kept = topobag::sqlite_catalog(map)) {
    kept->source = map;
    require_same(site, *kept, store);
  }
  topobag::enlist(map, site, store, robot_of(address));
  return topobag::push(topobag::FleetOutbox(map), store);
}

void follow_fleet(const FleetAddress& address, const ObjectClasses& classes,
                  std::optional<std::chrono::seconds> time, const FollowSays& says) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + time.value_or(std::chrono::seconds(0));
  std::unique_ptr<topobag::FleetBag> fleet;  // once its server has been asked
  std::string said, why;
  std::size_t refused = 0;
  bool followed = false;
  const auto if_new = [&](const auto& say, const std::string& text) {
    if (text != std::exchange(said, text)) say(text);
  };
  do {
    try {
      if (!fleet) fleet.reset(new topobag::FleetBag(bag_of(address, classes)));
      fleet->follow();
      const auto view = fleet->view();
      if (!followed && view->size() == 0 && !fleet->refused().empty()) {
        throw InputError(refusal_text(fleet->refused()));
      }
      followed = true;
      if_new(says.count, std::to_string(view->size()) + " key frames of " +
                             std::to_string(view->sessions().size()) + " sessions");
    } catch (const InputError&) {
      throw;
    } catch (const topobag::Error& error) {
      // An address that cannot be read, or classes that are not the site's: no other try mends it.
      if (!fleet && dynamic_cast<const topobag::FormatError*>(&error) != nullptr) throw;
      why = error.what();
      if (followed || !time || Clock::now() < end) if_new(says.trouble, why);
    }
    if (!fleet) {
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      continue;
    }
    const std::vector<std::string>& all = fleet->refused();
    if (refused < all.size()) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(refused);
      says.trouble(refusal_text({first, all.end()}));
      refused = all.size();
    }
    fleet->wait();
  } while (!time || Clock::now() < end);
  if (followed) return;
  throw topobag::Error("nothing could be read in " + std::to_string(time->count()) + " s: " + why);
}

std::vector<SiteFigures> fleet_status(const FleetAddress& address) {
  std::vector<SiteFigures> figures;
  topobag::PostgresStore store(address.conninfo);
  std::vector<std::string> asked = address.sites;
  if (!asked.empty()) asked = sites_of(address, store);
  for (const topobag::FleetSite& site : store.sites()) {
    const bool named = std::count(asked.begin(), asked.end(), site.name) > 0;
    if (!asked.empty() && !named) continue;
    figures.push_back({site.name, site.versions, site.robots});
  }
  return figures;
}

}  // namespace program
