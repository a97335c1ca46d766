// SPDX-License-Identifier: MIT
#include <pybind11/eigen.h>

#include <topobag/bag/memory_usage.hpp>
#include <topobag/bag/merge_options.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/bag/search_result.hpp>

#include "fields.hpp"
#include "rooms.hpp"

namespace python {

void bind_queries(py::module_& module) {
  using namespace topobag;
  Fields<EntryInfo>(module, "EntryInfo")
      .field("stamp", &EntryInfo::stamp)
      .field("session", &EntryInfo::session)
      .field("T_world_camera", &EntryInfo::T_world_camera)
      .field("label", &EntryInfo::label)
      .field("image", &EntryInfo::image);
  Fields<MapRegion>(module, "MapRegion")
      .field("center", &MapRegion::center)
      .field("radius", &MapRegion::radius);
  Fields<PresentVisit>(module, "PresentVisit")
      .field("session", &PresentVisit::session)
      .field("since", &PresentVisit::since);
  Fields<EntryFilter>(module, "EntryFilter")
      .field("min_id", &EntryFilter::min_id)
      .field("max_id", &EntryFilter::max_id)
      .field("min_stamp", &EntryFilter::min_stamp)
      .field("max_stamp", &EntryFilter::max_stamp)
      .field("sessions", &EntryFilter::sessions)
      .field("labels", &EntryFilter::labels)
      .field("not_of", &EntryFilter::not_of)
      .field("region", &EntryFilter::region);
  Fields<ExcludedNeighbors>(module, "ExcludedNeighbors")
      .field("id", &ExcludedNeighbors::id)
      .field("min_id_gap", &ExcludedNeighbors::min_id_gap)
      .field("stamp", &ExcludedNeighbors::stamp)
      .field("min_time_gap", &ExcludedNeighbors::min_time_gap)
      .field("session", &ExcludedNeighbors::session);
  Fields<QueryOptions>(module, "QueryOptions")
      .field("max_results", &QueryOptions::max_results)
      .field("min_similarity", &QueryOptions::min_similarity)
      .field("exclude", &QueryOptions::exclude)
      .field("among", &QueryOptions::among)
      .field("image", &QueryOptions::image)
      .field("filter", &QueryOptions::filter);
  Fields<Candidate>(module, "Candidate")
      .field("id", &Candidate::id)
      .field("similarity", &Candidate::similarity)
      .def("__eq__", [](const Candidate& a, const Candidate& b) { return a == b; });
  Fields<SearchResult>(module, "SearchResult")
      .field("candidates", &SearchResult::candidates)
      .field("entries", &SearchResult::entries)
      .field("visited", &SearchResult::visited)
      .field("exact", &SearchResult::exact)
      .field("missed_similarity", &SearchResult::missed_similarity);
  Fields<MergeOptions>(module, "MergeOptions")
      .field("session_offset", &MergeOptions::session_offset)
      .field("T_world_other", &MergeOptions::T_world_other)
      .field("scale", &MergeOptions::scale);
  Fields<MemoryUsage>(module, "MemoryUsage")
      .field("graphs", &MemoryUsage::graphs)
      .field("index", &MemoryUsage::index)
      .field("entries", &MemoryUsage::entries)
      .field("nodes", &MemoryUsage::nodes)
      .def("total", &MemoryUsage::total, doc("MemoryUsage.total"))
      .def("bytes_per_node", &MemoryUsage::bytes_per_node, doc("MemoryUsage.bytes_per_node"));
}

}  // namespace python
