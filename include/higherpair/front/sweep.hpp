#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

struct SweepSettings {
  double tolerance = 1e-9;              ///< as RunSettings::tolerance
  std::optional<std::int64_t> samples;  ///< as RunSettings::samples
  int part = 1;                         ///< which of `parts` equal parts of the variants this is, from 1
  int parts = 1;
  const std::atomic<bool>* stop = nullptr;          ///< as RunSettings::stop
  std::shared_ptr<const SweepTask> task = nullptr;  ///< null: that of the profile
};

/// The results of consecutive variants.
struct SweepBlock {
  std::int64_t number = 0;          ///< of the block, from 0
  std::int64_t variants = 0;        ///< number of variants
  std::int64_t good = 0;            ///< number of those whose whole path is good
  std::vector<double> values;       ///< row after row, one for each of Sweep::columns(); NaN where undefined
  std::vector<std::string> causes;  ///< for each row: why it is not good; empty if it is
  bool complete = true;             ///< false: stopped before its last variant
};

/// What a few variants show of a sweep before it is run.
struct SweepForecast {
  std::int64_t tried = 0;
  std::int64_t unreadable = 0;  ///< how many of these have an invalid profile, for example a negative radius
  std::int64_t variant = 0;     ///< the first of them
  std::string cause;            ///< its first mistake
};

/// The variants of a model that [sweep] in its profile asks for, and the table of their results. Immutable;
/// any number of threads may compute its blocks. A block is the same to the last bit whichever thread
/// computes it, and when.
///
/// Every variant has at least one row, even if its profile is invalid or it cannot be assembled: the status
/// is then `not_started`, and the cause says why. Without SweepTask::rows it has just one, with the worst
/// status of the rows of its run. The order, from good to bad: ok, singular, contact_open, overlap,
/// not_converged, not_assemblable, not_started. A path that is not good although its rows are also has a
/// cause.
class Sweep {
public:
  /// Fails for a model without a task or one built in C++, for a task with a mistake (fault_of() of its plan,
  /// paths that lead to no number, columns that do not exist), if the profile itself cannot be run at all,
  /// and if none of the variants that are tried has a valid profile.
  [[nodiscard]] static Result<Sweep> of(const Model& model, const SweepSettings& settings = {});

  /// Number of variants of this part, and of the first of them.
  [[nodiscard]] std::int64_t size() const;
  [[nodiscard]] std::int64_t first() const;
  /// The part is divided into blocks of equally many variants; their size depends on the profile alone.
  [[nodiscard]] std::int64_t blocks() const;
  /// 0 for a number that no block has; block() is empty then.
  [[nodiscard]] std::int64_t variants_of(std::int64_t block) const;

  /// "variant", the variables, the results (or the columns of the rows), "status".
  [[nodiscard]] const std::vector<Column>& columns() const;
  /// The index of the first result in columns(), and the number of results; 0 if rows are written.
  [[nodiscard]] std::size_t first_result() const;
  [[nodiscard]] std::size_t result_count() const;

  [[nodiscard]] const SweepForecast& forecast() const;

  /// Computes a block. It is not complete if it was stopped.
  [[nodiscard]] SweepBlock block(std::int64_t number) const;

  struct Data;
  explicit Sweep(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

private:
  std::shared_ptr<const Data> data_;
};

/// Computes the blocks from `first` on, on several threads at once, and passes them to `take` in order, one
/// at a time. Ends early if `take` returns false or the sweep is stopped.
/// \param threads  number of threads, at most 1024; 0 or less: one for each available core
void run_sweep(const Sweep& sweep, std::int64_t first, int threads,
               const std::function<bool(const SweepBlock&)>& take);

/// The header and the rows of a block as CSV: the columns, followed by `cause`.
[[nodiscard]] std::string sweep_csv_header(const Sweep& sweep);
void append_sweep_csv(const Sweep& sweep, const SweepBlock& block, std::string& out);

}  // namespace higherpair
