// SPDX-License-Identifier: MIT
#pragma once

#include <libpq-fe.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/detail/postgres_parameters.hpp>
#include <topobag/adaptors/detail/postgres_result.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A statement that the server refused, with PostgreSQL's code for why.
class PostgresRefusal : public Error {
 public:
  PostgresRefusal(const std::string& what, std::string code, std::string constraint)
      : Error(what), code_(std::move(code)), constraint_(std::move(constraint)) {}
  const std::string& code() const noexcept { return code_; }
  const std::string& constraint() const noexcept { return constraint_; }

 private:
  std::string code_, constraint_;
};

/// An open connection. What libpq reads of passwords, service files and TLS holds here.
class PostgresConnection {
 public:
  /// @param silence  how long the server may say nothing before it counts as lost
  /// Throws FormatError for an address that libpq cannot read, Error when there is no connection;
  /// the text never holds the password.
  PostgresConnection(const std::string& conninfo, std::chrono::milliseconds silence)
      : silence_(silence) {
    require_readable(conninfo);
    const long seconds = std::max(2L, static_cast<long>(silence.count() / 1000));
    const std::string patience = std::to_string(seconds);
    // What comes later holds: the user's own connect_timeout, but not another encoding.
    const char* const keys[] = {"connect_timeout", "dbname", "client_encoding", nullptr};
    const char* const values[] = {patience.c_str(), conninfo.c_str(), "UTF8", nullptr};
    connection_.reset(PQconnectdbParams(keys, values, 1));
    name_ = "PostgreSQL";  // and what of its address could be read
    const auto add = [&](const char* what, const char* text) {
      if (text != nullptr && *text != '\0') name_ += what + std::string(text);
    };
    add(" at ", PQhost(get()));
    add(", port ", PQport(get()));
    add(", data base ", PQdb(get()));
    if (PQstatus(get()) != CONNECTION_OK) lose(said());
    PQsetNoticeProcessor(
        get(), [](void*, const char*) {}, nullptr);  // stderr is the program's
    PQsetnonblocking(get(), 1);
    // What a follower has seen must outlive the server's crash; names mean PostgreSQL's own.
    run("SELECT set_config('search_path', 'pg_catalog', false), set_config('synchronous_commit',"
        " CASE current_setting('synchronous_commit') WHEN 'off' THEN 'on'"
        " ELSE current_setting('synchronous_commit') END, false)");
  }

  /// For people: host, port and data base.
  const std::string& name() const noexcept { return name_; }
  bool is_open() const noexcept { return connection_ && PQstatus(get()) == CONNECTION_OK; }
  int socket() const noexcept { return PQsocket(get()); }

  /// Runs a statement. Throws PostgresRefusal when the server says no, Error when it is lost.
  PostgresResult run(const char* sql, const PostgresParameters& parameters = {}) {
    std::vector<const char*> values;
    std::vector<int> lengths;
    for (const std::string& value : parameters.values()) {
      values.push_back(value.data());
      lengths.push_back(static_cast<int>(value.size()));
    }
    const std::vector<int> binary(values.size(), 1);
    if (PQsendQueryParams(get(), sql, static_cast<int>(values.size()), parameters.types().data(),
                          values.data(), lengths.data(), binary.data(), 1) == 0) {
      lose(said());
    }
    return answer();
  }

  /// Runs statements without parameters, one after another, whole or not at all.
  void run_all(const char* sql) {
    if (PQsendQuery(get(), sql) == 0) lose(said());
    answer();
  }

  /// Whether the server has notified since it was asked last. Throws Error when it is lost.
  bool notified() {
    if (PQconsumeInput(get()) == 0) lose(said());
    bool any = false;
    struct Free {
      void operator()(PGnotify* notice) const noexcept { PQfreemem(notice); }
    };
    while (std::unique_ptr<PGnotify, Free>(PQnotifies(get()))) any = true;
    return any;
  }

 private:
  struct Finish {
    void operator()(PGconn* connection) const noexcept { PQfinish(connection); }
  };

  PGconn* get() const noexcept { return connection_.get(); }

  /// An address that says nothing to libpq today says nothing to it tomorrow.
  static void require_readable(const std::string& conninfo) {
    // The bare name of a data base is read, too, but not by this.
    if (conninfo.find('=') == std::string::npos && conninfo.find("://") == std::string::npos)
      return;
    char* why = nullptr;
    PQconninfoOption* const options = PQconninfoParse(conninfo.c_str(), &why);
    const std::string sentence = why == nullptr ? "" : in_one_line(why);
    PQfreemem(why);
    PQconninfoFree(options);
    if (options == nullptr) throw FormatError("PostgreSQL: " + sentence);
  }

  /// What libpq says, in one line.
  std::string said() const { return in_one_line(PQerrorMessage(get())); }
  static std::string in_one_line(const std::string& text) {
    std::string line;
    for (const char letter : text) {
      const bool blank = letter == '\n' || letter == '\t' || letter == ' ';
      if (!blank) line += letter;
      if (blank && !line.empty() && line.back() != ' ') line += ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  }

  [[noreturn]] void lose(const std::string& why) {
    connection_.reset();
    throw Error(name_ + ": " + (why.empty() ? "the connection is lost" : why));
  }

  /// Waits until the server's words, or its ear, are there.
  void wait(short events) {
    ::pollfd waiting{socket(), events, 0};
    if (::poll(&waiting, 1, static_cast<int>(silence_.count())) > 0) return;
    lose("the server has said nothing for " + std::to_string(silence_.count()) +
         " ms; what it had not acknowledged is sent again next time");
  }

  /// The last result of what was sent.
  PostgresResult answer() {
    int unsent = 0;
    while ((unsent = PQflush(get())) == 1) {
      wait(POLLIN | POLLOUT);
      if (PQconsumeInput(get()) == 0) lose(said());
    }
    if (unsent < 0) lose(said());
    PostgresResult last(nullptr);
    for (;;) {
      while (PQisBusy(get()) != 0) {
        wait(POLLIN);
        if (PQconsumeInput(get()) == 0) lose(said());
      }
      PostgresResult result(PQgetResult(get()));
      if (result.get() == nullptr) break;
      last = std::move(result);
      const ExecStatusType status = PQresultStatus(last.get());
      if (status == PGRES_COPY_IN || status == PGRES_COPY_OUT || status == PGRES_COPY_BOTH) break;
    }
    const ExecStatusType status = last.get() ? PQresultStatus(last.get()) : PGRES_FATAL_ERROR;
    if (status == PGRES_TUPLES_OK || status == PGRES_COMMAND_OK) return last;
    const auto field = [&](int which) {
      const char* text = last.get() ? PQresultErrorField(last.get(), which) : nullptr;
      return std::string(text == nullptr ? "" : text);
    };
    if (PQstatus(get()) != CONNECTION_OK || field(PG_DIAG_SQLSTATE).empty()) lose(said());
    throw PostgresRefusal(name_ + ": " + in_one_line(field(PG_DIAG_MESSAGE_PRIMARY)),
                          field(PG_DIAG_SQLSTATE), field(PG_DIAG_CONSTRAINT_NAME));
  }

  std::chrono::milliseconds silence_;
  std::string name_;
  std::unique_ptr<PGconn, Finish> connection_;
};

/// A change that is made whole by `commit` or not at all.
class PostgresTransaction {
 public:
  explicit PostgresTransaction(PostgresConnection& connection) : connection_(connection) {
    connection_.run("BEGIN");
  }
  PostgresTransaction(const PostgresTransaction&) = delete;
  PostgresTransaction& operator=(const PostgresTransaction&) = delete;
  ~PostgresTransaction() {
    if (!open_ || !connection_.is_open()) return;
    try {
      connection_.run("ROLLBACK");
    } catch (const Error&) {  // the connection went, and the transaction with it
    }
  }

  /// Throws Error; whether it was made is then known to the server alone.
  void commit() {
    open_ = false;
    connection_.run("COMMIT");
  }

 private:
  PostgresConnection& connection_;
  bool open_ = true;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
