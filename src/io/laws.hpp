#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/mechanism/description.hpp"
#include "table_reader.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// What a law is a function of, and what it gives.
struct LawQuantities {
  Dimension coordinate;
  Dimension value;

  bool operator==(const LawQuantities&) const = default;
};

/// A law in two systems of units.
struct ReadLaw {
  LawDescription profile;
  LawDescription si;
  std::vector<int> lines;         ///< of the points, where they come from a file
  std::optional<MotionLaw> made;  ///< in the profile's units; always, once it has been read
};

/// Reads `[laws.NAME]` for these quantities; none where it has mistakes, which are reported.
[[nodiscard]] std::optional<ReadLaw> read_law(TableReader& table, const LawQuantities& quantities);

/// What a law that has been read probably does not mean: the noise of a table's rounding, a turn that does
/// not close.
void note_law(TableReader& table, const LawQuantities& quantities, const ReadLaw& law);

/// The laws of a profile. A law has the units of what uses it, so that it is read when it is used, for each
/// pair of quantities once.
class LawBook {
public:
  explicit LawBook(TableReader& root);

  /// The law of that name; reports that there is none, or what is wrong with it (once).
  /// \return its place in Mechanism::laws, where it is put in SI units
  [[nodiscard]] std::optional<int> find(const Item& name, const LawQuantities& quantities,
                                        Mechanism& mechanism);

  /// The same law in the profile's units.
  [[nodiscard]] const MotionLaw& in_profile_units(int index) const;

  /// Reads the laws that nothing has used, for their mistakes, and notes that.
  void finish();

private:
  struct Entry {
    std::string name;
    Item item;
    bool used = false;
  };
  struct Known {
    std::size_t entry = 0;
    LawQuantities quantities;
    std::optional<int> index;  ///< none: it has mistakes
  };

  Reading* reading_;
  std::vector<Entry> entries_;
  std::vector<Known> known_;
  std::vector<MotionLaw> laws_;  ///< of Mechanism::laws, in the profile's units
};

}  // namespace higherpair::io_detail
