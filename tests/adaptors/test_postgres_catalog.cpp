// SPDX-License-Identifier: MIT
#include <stdexcept>
#include <string>

#include <topobag/adaptors/postgres.hpp>

#include "adaptors/postgres_server.hpp"
#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("a site keeps what is said of its classes", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const std::string base = shared_postgres().new_base();
  PostgresStore store(base);
  store.prepare();
  store.add_site("hall", warehouse());
  store.add_site("names", warehouse().catalog);
  store.add_site("old", fingerprint(warehouse().catalog));
  const auto kept = store.site_catalog("hall");
  REQUIRE(kept);
  CHECK_FALSE(difference(*kept, warehouse()));
  CHECK(fingerprint(kept->catalog) == fingerprint(warehouse().catalog));
  CHECK(store.sites().front().catalog == fingerprint(warehouse().catalog));
  CHECK(*kept->sizes == *warehouse().sizes);
  for (const auto& [other, sentence] : other_warehouses()) CHECK(difference(*kept, other));
  REQUIRE(store.site_catalog("names"));
  CHECK_FALSE(store.site_catalog("names")->lookalikes);
  CHECK_FALSE(store.site_catalog("names")->sizes);
  CHECK_FALSE(store.site_catalog("old"));
  CHECK_FALSE(store.site_catalog("no such site"));
  CHECK_THROWS_AS(store.add_site("hall", warehouse()), Error);
  CHECK(shared_postgres().sql("SELECT count(*) FROM topobag.class", base) == "10");
}

TEST_CASE("a site's classes are read by who may read the site, and written by its owner alone",
          "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const std::string base = shared_postgres().new_base();
  PostgresStore owner(base);
  owner.prepare();
  owner.add_site("hall", warehouse());
  owner.add_site("yard", warehouse());
  shared_postgres().sql("CREATE ROLE stocktaker LOGIN");
  owner.admit("stocktaker", "hall", Uuid{1});
  std::string of_role = base;
  of_role.replace(of_role.find("user=owner"), 10, "user=stocktaker");
  PostgresStore reader(of_role);
  CHECK(reader.site_catalog("hall"));
  CHECK_FALSE(reader.site_catalog("yard"));
  for (const char* sql :
       {"UPDATE topobag.class SET dynamics = 0", "DELETE FROM topobag.class",
        "INSERT INTO topobag.class(site, id, name, dynamics) VALUES ('hall', 9, 'x', 0)"}) {
    CHECK_THROWS_AS(shared_postgres().sql(sql, of_role), std::runtime_error);
  }
}

TEST_CASE("classes damaged on a server are named", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  for (const std::string damage :
       {"dynamics = 7", "lookalike = 5", "width = -1", "height = 'infinity'", "name = ''"}) {
    const std::string base = shared_postgres().new_base();
    PostgresStore store(base);
    store.prepare();
    store.add_site("hall", warehouse());
    shared_postgres().sql("UPDATE topobag.class SET " + damage + " WHERE id = 0", base);
    CAPTURE(damage);
    CHECK(error_text([&] {
            store.site_catalog("hall");
          }).find("the classes of site 'hall' cannot be read: ") != std::string::npos);
  }
}
