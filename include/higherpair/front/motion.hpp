#pragma once

#include "higherpair/analysis/status.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/units.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// What to compute, and where.
struct RunSettings {
  bool in_time = false;  ///< rows in time (duration and time_step of the drivers), not positions
  std::optional<std::int64_t> samples;  ///< instead of that of the profile; in time: rows over the duration
  std::vector<double> positions;     ///< of a single driver, in the profile's unit; instead of the profile's
  bool forces = false;               ///< columns of the reactions of joints, contacts and drivers
  bool jerk = false;                 ///< columns of the jerk, and of that of the frozen equivalent linkage
  std::optional<int> derivatives;    ///< columns of the time derivatives from the third to this one, 3 … 6
  std::vector<std::string> columns;  ///< names or globs ("follower.*"); empty: all. Only these are computed
  std::optional<Units> units;  ///< of columns and events; none: the profile's. kSiUnits: metres, radians
  double tolerance = 1e-9;     ///< largest closure error of an ok row, relative to the size of the mechanism
  const std::atomic<bool>* stop = nullptr;  ///< checked at every inner step: once true, no further row is
                                            ///< returned
};

/// A column of a table.
struct Column {
  std::string name;                         ///< "follower.alpha"
  std::string unit;                         ///< "deg/s^2", "1" for a pure number; empty for words
  std::span<const std::string_view> words;  ///< of a column of words: its values are indices into these
};

/// A row of the table of a run, in the units of the run. The caller owns it and may keep and copy it.
struct Row {
  std::int64_t number = -1;  ///< from 0
  RowStatus status = RowStatus::kNotConverged;
  std::vector<double> values;  ///< one for each column; NaN where undefined (an empty field in CSV)
};

/// An event on the path to a row.
struct Event {
  EventType type = EventType::kLimitPosition;
  double driver = 0;           ///< position of the (first) driver in the units of the run
  std::optional<double> time;  ///< in a run in time, or along the law that a driver follows
  std::string item;            ///< name of the joint or contact concerned; empty: none
  std::string cause;           ///< a sentence
  std::int64_t row = 0;        ///< it happened on the path from the row before to this row
  double driver_si = 0;        ///< the position in [rad or m]
  std::optional<int> joint;    ///< index into Mechanism::joints
  std::optional<int> contact;  ///< index into Mechanism::contacts
  /// For a stroke end: the joint's coordinate there, in the units of the run.
  std::optional<double> value;
  /// Where it happened, as a fraction of the path from the row before to `row`; of the time between them for
  /// a law's jump and an opening. Above 1 at a limit at infinity that `row` is too near to.
  double share = 1;
};

/// The word in a column of words; empty where undefined.
[[nodiscard]] std::string_view word_of(const Column& column, double value);

/// A column's name with its unit, as in the header of CSV: "crank.angle[deg]".
[[nodiscard]] std::string csv_head(const Column& column);

/// One line of CSV (with its line end) appended to `out`: the names with their units, or a row.
void append_csv_header(const std::vector<Column>& columns, std::string& out);
void append_csv_row(const std::vector<Column>& columns, const Row& row, std::string& out);

/// The smallest force of a contact on a path, in the units of the run; < 0: the contact would have to pull.
struct SmallestForce {
  std::string contact;
  double force = 0;
  double driver = 0;  ///< position of the (first) driver
};

/// A run that is computed row by row, for more rows than memory should hold. Made by Model::start. One thread
/// at a time may use it; any number of them may run on one model at once.
///
///     Row row;
///     while (analysis.next(row)) { … row.values[k] … }
class Analysis {
public:
  struct Impl;
  explicit Analysis(std::unique_ptr<Impl> impl);
  Analysis(Analysis&& other) noexcept;
  Analysis& operator=(Analysis&& other) noexcept;
  ~Analysis();

  /// Number of rows of the whole run, >= 1.
  [[nodiscard]] std::int64_t size() const;
  [[nodiscard]] const std::vector<Column>& columns() const;

  /// Moves on to the next row and writes it into `row`. False after the last one, and once stopped: with
  /// forces also where the search for openings that comes with the last row is stopped, and that row is not
  /// given.
  [[nodiscard]] bool next(Row& row);
  /// Whether RunSettings::stop ended it.
  [[nodiscard]] bool stopped() const;

  /// The events up to the last row taken. What would keep an opened contact closed depends on all rows, and
  /// is in the event's `cause` after the last one.
  [[nodiscard]] const std::vector<Event>& events() const;
  /// Notes on what is probably a slip in the profile: what is far from its pose once the mechanism is
  /// assembled; after the last row also contacts that may part and never touched. In this order.
  [[nodiscard]] Diagnostics notes() const;
  /// With RunSettings::forces, after the last row: the smallest force of each contact on the whole path,
  /// between its rows too; only contacts whose force is defined somewhere.
  [[nodiscard]] std::vector<SmallestForce> smallest_forces() const;
  /// Factor on the drivers' speed up to which no contact opens: 0 if one opens at rest already, infinite if
  /// no speed opens one. None if it is not known: dampers act, a force is not defined on the whole path, or
  /// falls below 0 next to a singular position.
  [[nodiscard]] std::optional<double> highest_speed() const;
  /// Whether the whole path so far is good: every row `ok`, and on the path no limit position (except at its
  /// very ends), no overlap and no contact that opens.
  [[nodiscard]] bool good() const;

  /// For the library itself; no part of what stays the same from version to version.
  [[nodiscard]] const Impl& impl() const { return *impl_; }
  [[nodiscard]] Impl& impl() { return *impl_; }

private:
  std::unique_ptr<Impl> impl_;
};

/// The values of a column, row by row, in its unit; NaN where undefined.
struct ColumnValues {
  std::string_view name;
  std::string_view unit;
  std::span<const double> values;

  [[nodiscard]] double operator[](std::size_t row) const { return values[row]; }
  [[nodiscard]] std::size_t size() const { return values.size(); }
  [[nodiscard]] auto begin() const { return values.begin(); }
  [[nodiscard]] auto end() const { return values.end(); }
};

/// A whole run: its table by columns, and its events. A value; what its members return refers to it and is
/// valid as long as it lives.
class Motion {
public:
  /// The rows of an analysis that have not been taken yet.
  explicit Motion(Analysis analysis);

  /// Number of rows.
  [[nodiscard]] std::size_t size() const { return statuses_.size(); }
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The column of that name; the error suggests similar names.
  [[nodiscard]] Result<ColumnValues> find_column(std::string_view name) const&;
  Result<ColumnValues> find_column(std::string_view name) const&& = delete;

  /// The same for a name that is known to exist, such as one of RunSettings::columns.
  /// \throws std::out_of_range  if it does not exist, with the message of the error
  [[nodiscard]] ColumnValues column(std::string_view name) const&;
  ColumnValues column(std::string_view name) const&& = delete;

  [[nodiscard]] std::span<const RowStatus> statuses() const& { return statuses_; }
  std::span<const RowStatus> statuses() const&& = delete;
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] const Diagnostics& notes() const { return notes_; }  ///< as Analysis::notes
  [[nodiscard]] bool good() const { return good_; }                  ///< as Analysis::good
  [[nodiscard]] bool stopped() const { return stopped_; }  ///< as Analysis::stopped: rows are missing

private:
  std::vector<Column> columns_;
  std::vector<std::vector<double>> values_;  ///< of each column
  std::vector<RowStatus> statuses_;
  std::vector<Event> events_;
  Diagnostics notes_;
  bool good_ = false;
  bool stopped_ = false;
};

/// Consecutive rows of a run.
struct RowBlock {
  std::int64_t first = 0;  ///< number of its first row
  std::vector<RowStatus> statuses;
  std::vector<double> values;  ///< row after row, one for each column, as Row::values

  [[nodiscard]] std::size_t size() const { return statuses.size(); }
  /// The values of its i-th row.
  [[nodiscard]] std::span<const double> row(std::size_t i) const {
    const std::size_t width = values.size() / statuses.size();
    return std::span(values).subspan(i * width, width);
  }
};

/// The text to be written for a block, one for each output.
using BlockTexts = std::vector<std::string>;

/// Computes all rows of a run in blocks, on several threads at once, and passes them to `take` in order, one
/// block at a time. Rows, events and everything else are those of Analysis::next to the last bit, whatever
/// the number of threads; events() and the other queries of the analysis then answer as after its last row.
/// Memory does not grow with the number of rows. Ends early if `take` returns false or the run is stopped.
/// \pre no row of the analysis has been taken
/// \param threads  number of threads, at most 1024; 0 or less: one for each available core
/// \param texts    makes the texts of a block; called on any thread, several at once. It gets the strings
///                 that it left for an earlier block, emptied, to reuse their memory
/// \param take     receives the blocks and their texts in order, one at a time; returning false ends the run
void run_blocks(Analysis& analysis, int threads,
                const std::function<void(const RowBlock&, BlockTexts&)>& texts,
                const std::function<bool(const RowBlock&, const BlockTexts&)>& take);

/// The lines of CSV (with their ends) of a block, appended to `out`: those of append_csv_row.
void append_csv_rows(const std::vector<Column>& columns, const RowBlock& block, std::string& out);

}  // namespace higherpair
