// SPDX-License-Identifier: MIT
#include "fleet_map.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <topobag/adaptors/fleet_bag.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "input_error.hpp"

namespace program {
namespace {

/// The sites of the address, or all that may be read.
std::vector<std::string> sites_of(const FleetAddress& address) {
  if (!address.sites.empty()) return address.sites;
  std::vector<std::string> sites;
  for (const SiteFigures& site : fleet_status(address)) sites.push_back(site.name);
  return sites;
}

topobag::FleetBag bag_of(const FleetAddress& address, const topobag::ClassCatalog& catalog) {
  topobag::FleetOptions options;
  options.catalog = topobag::fingerprint(catalog);
  return topobag::FleetBag({{address.conninfo, sites_of(address)}}, options);
}

const std::string& only_site(const FleetAddress& address) {
  if (address.sites.size() == 1) return address.sites.front();
  throw InputError("the address names " + std::to_string(address.sites.size()) +
                   " sites; a robot maps one: add ?site=NAME");
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

SavedMap read_fleet_map(const std::string& address, const topobag::ClassCatalog& catalog) {
  topobag::FleetBag fleet = bag_of(parse_fleet_address(address), catalog);
  fleet.follow();
  if (!fleet.refused().empty()) throw InputError(address, fleet.refused().front());
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
                      const topobag::BagOfTopologyGraphs<>& entries,
                      const topobag::ClassCatalog& catalog) {
  const FleetAddress address = parse_fleet_address(text);
  const topobag::Uuid robot = robot_of(address).value_or(topobag::random_uuid());
  const topobag::Uuid run = topobag::random_uuid();
  std::vector<topobag::FleetVersion> versions;
  entries.for_each([&](topobag::KeyframeId id, const topobag::EntryInfo& info, const auto& graph) {
    topobag::FleetVersion version =
        topobag::version_of({only_site(address), robot, run, id}, info, graph);
    version.seq = static_cast<std::int64_t>(versions.size()) + 1;
    version.run = session;
    version.catalog = topobag::fingerprint(catalog);
    versions.push_back(std::move(version));
  });
  topobag::PostgresStore(address.conninfo).append(versions);
}

void prepare_fleet(const FleetAddress& address, const topobag::ClassCatalog& catalog) {
  topobag::PostgresStore store(address.conninfo);
  store.prepare();
  std::set<std::string> known;
  for (const topobag::FleetSite& site : store.sites()) known.insert(site.name);
  for (const std::string& site : address.sites) {
    if (known.count(site) == 0) store.add_site(site, topobag::fingerprint(catalog));
  }
}

void admit_to_fleet(const FleetAddress& address, const std::string& role) {
  topobag::PostgresStore store(address.conninfo);
  for (const std::string& site : address.sites) {
    store.admit(role, site, robot_of(address));
  }
}

std::size_t push_to_fleet(const FleetAddress& address, const std::string& map) {
  topobag::enlist(map, only_site(address), robot_of(address));
  topobag::PostgresStore store(address.conninfo);
  return topobag::push(topobag::FleetOutbox(map), store);
}

void follow_fleet(const FleetAddress& address, const topobag::ClassCatalog& catalog,
                  std::optional<std::chrono::seconds> time,
                  const std::function<void(const std::string&)>& tell) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + time.value_or(std::chrono::seconds(0));
  topobag::FleetBag fleet = bag_of(address, catalog);
  std::string said;
  std::size_t refused = 0;
  const auto tell_if_new = [&](const std::string& text) {
    if (text != std::exchange(said, text)) tell(text);
  };
  do {
    try {
      fleet.follow();
      const auto view = fleet.view();
      tell_if_new(std::to_string(view->size()) + " key frames of " +
                  std::to_string(view->sessions().size()) + " sessions");
    } catch (const topobag::Error& error) {
      tell_if_new(error.what());
    }
    for (; refused < fleet.refused().size(); ++refused) tell(fleet.refused()[refused]);
    fleet.wait();
  } while (!time || Clock::now() < end);
}

std::vector<SiteFigures> fleet_status(const FleetAddress& address) {
  std::vector<SiteFigures> figures;
  topobag::PostgresStore store(address.conninfo);
  for (const topobag::FleetSite& site : store.sites()) {
    figures.push_back({site.name, site.versions, site.robots});
  }
  return figures;
}

}  // namespace program
