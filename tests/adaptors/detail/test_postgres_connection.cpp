// SPDX-License-Identifier: MIT
#include <chrono>
#include <string>
#include <thread>

#include <topobag/adaptors/detail/postgres_connection.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;
using detail::PostgresConnection;

namespace {

constexpr auto patience = std::chrono::seconds(30);

std::string connection_error(const std::string& conninfo) {
  return error_text([&] { PostgresConnection connection(conninfo, patience); });
}

/// Asks a role of the shared server for its password from now on.
void require_password(const std::string& role) {
  const std::string path = shared_postgres().data() + "/pg_hba.conf";
  const std::string rules = content_of(path);
  std::ofstream(path) << "local all " << role << " scram-sha-256\n" << rules;
  const std::string before = shared_postgres().sql("SELECT pg_conf_load_time()");
  shared_postgres().sql("SELECT pg_reload_conf()");
  while (shared_postgres().sql("SELECT pg_conf_load_time()") == before) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

TEST_CASE("a role's password is libpq's matter, and no error tells it", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  shared_postgres().sql("CREATE ROLE han LOGIN PASSWORD 'millennium'");
  require_password("han");
  const std::string han = shared_postgres().new_base("han");
  CHECK(connection_error(han).find("no password supplied") != std::string::npos);
  const std::string wrong = connection_error(han + " password=falcon");
  CHECK(wrong.find("password authentication failed") != std::string::npos);
  CHECK(wrong.find("falcon") == std::string::npos);
  PostgresConnection connection(han + " password=millennium", patience);
  CHECK(connection.run("SELECT current_user::text").text(0, 0) == "han");
  CHECK(connection.name().find("millennium") == std::string::npos);
}

TEST_CASE("what a server refuses has a code, and leaves the connection open", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  PostgresConnection connection(shared_postgres().new_base(), patience);
  connection.run_all(
      "CREATE TABLE public.kept(number bigint); CREATE TABLE public.other(number bigint)");
  try {
    detail::PostgresTransaction transaction(connection);
    connection.run("INSERT INTO public.kept VALUES (1)");
    connection.run("INSERT INTO public.none VALUES (1)");
    FAIL("the statement names no table");
  } catch (const detail::PostgresRefusal& refusal) {
    CHECK(refusal.code() == "42P01");
    CHECK(std::string(refusal.what()).find(connection.name() + ": ") == 0);
    CHECK(std::string(refusal.what()).find('\n') == std::string::npos);
  }
  REQUIRE(connection.is_open());
  CHECK(connection.run("SELECT count(*) FROM public.kept").integer(0, 0) == 0);
  {
    detail::PostgresTransaction transaction(connection);
    connection.run("INSERT INTO public.kept VALUES (1)");
    transaction.commit();
  }
  CHECK(connection.run("SELECT count(*) FROM public.kept").integer(0, 0) == 1);
}

TEST_CASE("no server is told in one line", "[postgres]") {
  const ScratchFolder folder;
  const std::string text = connection_error("dbname=base host=" + folder.path());
  CHECK(text.find("PostgreSQL at " + folder.path() + ", port 5432, data base base: ") == 0);
  for (const char blank : {'\n', '\t'}) CHECK(text.find(blank) == std::string::npos);
}
