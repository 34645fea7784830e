#pragma once

#include "higherpair/io/force_table.hpp"
#include "row_writer.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace higherpair::cli {

/// What `forces` adds to the rows of `analyze`: reactions, and where contacts open.
class ForceRows {
public:
  ForceRows(const Profile& profile, const Run& run, ForceTable table);

  [[nodiscard]] const std::vector<Column>& columns() const { return table_.columns(); }

  /// The cells of the row in which `run` stands; adds an event where a contact opens.
  const std::vector<Cell>& row(const Run& run, const std::vector<DriverMotion>& drivers,
                               const std::vector<Cell>& motion, std::vector<Event>& events);

  /// Whether a contact has pulled in some row.
  [[nodiscard]] bool opened() const { return opened_; }

  /// Writes causes into the events of this run, once all rows are known.
  void finish(std::vector<Event>& events) const;

private:
  const Profile& profile_;
  InverseDynamics dynamics_;
  ContactWatch watch_;
  ForceTable table_;
  bool opened_ = false;
  std::vector<std::pair<std::size_t, ContactOpening>> openings_;  ///< and which event each one is
};

}  // namespace higherpair::cli
