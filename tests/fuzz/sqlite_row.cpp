// SPDX-License-Identifier: MIT
// A row of an SQLite map as anyone may have edited it: refused with an Error, or an entry that a
// map could have written.
#include <sqlite3.h>

#include <optional>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "fuzz/fuzz_input.hpp"
#include "scratch_folder.hpp"

namespace {

using topobag::SqliteBag;
using topobag::detail::checksum_of;
using topobag::detail::sqlite_insert;

/// An empty map that is kept open without this project's help.
class RawMap {
 public:
  RawMap() {
    { const SqliteBag<> made(path()); }
    sqlite3_open(path().c_str(), &db_);
    run("PRAGMA journal_mode = DELETE; PRAGMA synchronous = OFF");
    sqlite3_prepare_v2(db_, sqlite_insert, -1, &insert_, nullptr);
  }
  ~RawMap() {
    sqlite3_finalize(insert_);
    sqlite3_close(db_);
  }

  std::string path() const { return folder_.path("map.db"); }

  void put_row(FuzzInput& input) {
    run("DELETE FROM keyframe");
    for (int column = 1; column <= sqlite3_bind_parameter_count(insert_); ++column) {
      bind(column, input);
    }
    if (input.below(4) != 0) {  // a graph that its checksum fits, or nothing of it is ever read
      const std::string text = input.rest();
      const std::vector<std::uint8_t> graph(text.begin(), text.end());
      sqlite3_bind_blob(insert_, 14, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
      sqlite3_bind_int64(insert_, 15, checksum_of(graph));
    }
    sqlite3_step(insert_);  // a column may refuse what it is given
    sqlite3_reset(insert_);
  }

 private:
  void run(const char* sql) { sqlite3_exec(db_, sql, nullptr, nullptr, nullptr); }

  void bind(int column, FuzzInput& input) {
    switch (input.below(6)) {
      case 0:
        sqlite3_bind_null(insert_, column);
        break;
      case 1:
        sqlite3_bind_double(insert_, column, input.number());
        break;
      case 2:
        sqlite3_bind_double(insert_, column, input.below(3) / 2.0);
        break;
      case 3: {
        const char text[] = {static_cast<char>(input.byte()), static_cast<char>(input.byte())};
        sqlite3_bind_text(insert_, column, text, sizeof(text), SQLITE_TRANSIENT);
        break;
      }
      case 4:
        sqlite3_bind_zeroblob(insert_, column, input.below(9));
        break;
      default:
        sqlite3_bind_int64(insert_, column, input.byte());
    }
  }

  ScratchFolder folder_;
  sqlite3* db_ = nullptr;
  sqlite3_stmt* insert_ = nullptr;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static RawMap map;
  FuzzInput input(data, size);
  map.put_row(input);
  topobag::SqliteOptions options;
  options.read_only = true;
  try {
    const SqliteBag<> opened(map.path(), options);
    opened.bag().for_each(
        [](topobag::KeyframeId, const topobag::EntryInfo& info, const auto&) { info.validate(); });
  } catch (const topobag::InvalidValue& invalid) {
    require(std::string(invalid.what()).find("map.db") != std::string::npos, "an error names it");
  } catch (const topobag::Error&) {
  }
  return 0;
}
