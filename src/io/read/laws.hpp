#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/mechanism/description.hpp"
#include "io/document/table_reader.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

enum class LawUnits { kProfile, kSi };

/// The dimensions of a law's argument and value, and the units in which its user wants it.
struct LawQuantities {
  Dimension coordinate;
  Dimension value;
  LawUnits units = LawUnits::kProfile;

  bool operator==(const LawQuantities&) const = default;
};

/// A law in two systems of units. The MotionLaw is made in only one of them: for a table this takes a large
/// part of the time of reading.
struct ReadLaw {
  LawDescription profile;
  LawDescription si;
  std::vector<int> lines;         ///< line numbers of the points, if they come from a file
  std::optional<MotionLaw> made;  ///< in LawQuantities::units; always set by read_law()

  [[nodiscard]] const LawDescription& in(LawUnits units) const {
    return units == LawUnits::kSi ? si : profile;
  }
};

/// Reads `[laws.NAME]` for these quantities; none if it has mistakes, which are reported.
[[nodiscard]] std::optional<ReadLaw> read_law(TableReader& table, const LawQuantities& quantities);

/// Reads the segments of a law, with `origin` and `start`; reports mistakes in them.
/// \param item  `segments`
void read_law_segments(TableReader& table, const Item& item, const LawQuantities& quantities, ReadLaw& law);

/// Notes what is probably a mistake in a law that was read: noise from rounded table values, a law over a
/// turn that does not close.
void note_law(TableReader& table, const LawQuantities& quantities, const ReadLaw& law);

/// The laws of a profile. A law takes its units from what uses it, so it is read only when it is used, once
/// for each pair of quantities.
class LawBook {
public:
  explicit LawBook(TableReader& root);

  /// The law of that name; reports that there is none, or (once) what is wrong with it.
  /// \return its index in Mechanism::laws, where it is added in SI units
  [[nodiscard]] std::optional<int> find(const Item& name, const LawQuantities& quantities,
                                        Mechanism& mechanism);

  /// The same law, in the units that were asked for in find().
  [[nodiscard]] const MotionLaw& made(int index) const;

  /// Reads the laws that nothing has used, to find their mistakes, and notes that they are unused.
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
  std::vector<MotionLaw> laws_;  ///< parallel to Mechanism::laws, in the units asked for
};

}  // namespace higherpair::io_detail
