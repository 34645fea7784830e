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
  int part = 1;  ///< the variants are cut into `parts` of equal length, of which this is one
  int parts = 1;
  const std::atomic<bool>* stop = nullptr;          ///< as RunSettings::stop
  std::shared_ptr<const SweepTask> task = nullptr;  ///< none: that of the profile
};

/// Consecutive variants, worked out.
struct SweepBlock {
  std::int64_t number = 0;          ///< of the block, from 0
  std::int64_t variants = 0;        ///< so many
  std::int64_t good = 0;            ///< of them so many whose whole path is good
  std::vector<double> values;       ///< row after row, one for each of Sweep::columns(); NaN where undefined
  std::vector<std::string> causes;  ///< of each row: why it is not good; empty: it is
  bool complete = true;             ///< false: stopped before its last variant
};

/// What can be said of a sweep before it is run, from some of its variants.
struct SweepForecast {
  std::int64_t tried = 0;
  std::int64_t unreadable = 0;  ///< of these so many whose profile would be wrong, as with a negative radius
  std::int64_t variant = 0;     ///< the first of them
  std::string cause;            ///< its first mistake
};

/// The many variants of a model that [sweep] in its profile asks for: the table of their results. Never
/// changes; any number of threads may work out its blocks. A block is the same to the last bit whoever works
/// it out, and when.
///
/// Every variant has at least one row, also one that cannot be read or put together: its status is
/// `not_started`, and its cause says why. Without SweepTask::rows it has just one, with the worst status of
/// the rows of its run. The order, from good to bad: ok, singular, contact_open, overlap, not_converged,
/// not_assemblable, not_started. A path that is not good although its rows are has a cause as well.
class Sweep {
public:
  /// Fails for a profile without [sweep], for columns that do not exist, where the profile itself cannot be
  /// run at all, and where no variant can be read of those that are tried.
  [[nodiscard]] static Result<Sweep> of(const Model& model, const SweepSettings& settings = {});

  /// Number of variants of this part, and of the first of them.
  [[nodiscard]] std::int64_t size() const;
  [[nodiscard]] std::int64_t first() const;
  /// The part is cut into blocks of equally many variants; how many depends on the profile alone.
  [[nodiscard]] std::int64_t blocks() const;
  [[nodiscard]] std::int64_t variants_of(std::int64_t block) const;

  /// "variant", the variables, the results (or the columns of the rows), "status".
  [[nodiscard]] const std::vector<Column>& columns() const;
  /// The place of the first result in columns(), and how many results there are; none where rows are written.
  [[nodiscard]] std::size_t first_result() const;
  [[nodiscard]] std::size_t result_count() const;

  [[nodiscard]] const SweepForecast& forecast() const;

  /// Works out a block. Not complete where it was stopped.
  [[nodiscard]] SweepBlock block(std::int64_t number) const;

  struct Data;
  explicit Sweep(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

private:
  std::shared_ptr<const Data> data_;
};

/// Works out the blocks from `first` on, on several threads at once, and gives them to `take` in their order,
/// one at a time. Ends early where `take` returns false, or the sweep is stopped.
/// \param threads  so many; 0: as many as there are cores to be used
void run_sweep(const Sweep& sweep, std::int64_t first, int threads,
               const std::function<bool(const SweepBlock&)>& take);

/// The rows of a block as CSV, and the header; the columns and behind them `cause`.
[[nodiscard]] std::string sweep_csv_header(const Sweep& sweep);
void append_sweep_csv(const Sweep& sweep, const SweepBlock& block, std::string& out);

}  // namespace higherpair
