#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/mechanism/description.hpp"
#include "table_reader.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

enum class LawUnits { kProfile, kSi };

/// What a law is a function of, what it gives, and in which units its user wants it.
struct LawQuantities {
  Dimension coordinate;
  Dimension value;
  LawUnits units = LawUnits::kProfile;

  bool operator==(const LawQuantities&) const = default;
};

/// A law in two systems of units. It is made in one only: of a table that takes a large part of reading.
struct ReadLaw {
  LawDescription profile;
  LawDescription si;
  std::vector<int> lines;         ///< of the points, where they come from a file
  std::optional<MotionLaw> made;  ///< in LawQuantities::units; always, once it has been read

  [[nodiscard]] const LawDescription& in(LawUnits units) const {
    return units == LawUnits::kSi ? si : profile;
  }
};

/// Reads `[laws.NAME]` for these quantities; none where it has mistakes, which are reported.
[[nodiscard]] std::optional<ReadLaw> read_law(TableReader& table, const LawQuantities& quantities);

/// The segments of a law, with `origin` and `start`; a mistake in them is reported. \param item  `segments`
void read_law_segments(TableReader& table, const Item& item, const LawQuantities& quantities, ReadLaw& law);

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

  /// The same law, in the units that it was looked for in.
  [[nodiscard]] const MotionLaw& made(int index) const;

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
  std::vector<MotionLaw> laws_;  ///< of Mechanism::laws, in the units asked for
};

}  // namespace higherpair::io_detail
