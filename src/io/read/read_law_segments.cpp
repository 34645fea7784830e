#include "laws.hpp"

#include <utility>

namespace higherpair::io_detail {
namespace {

// Reads a segment in both systems of units.
class SegmentReader {
public:
  SegmentReader(TableReader& table, const LawQuantities& quantities, LawSegment& profile, LawSegment& si)
      : table_(table), quantities_(quantities), profile_(profile), si_(si) {}

  void read() {
    static const std::vector<std::string> names(kLawNames.begin(), kLawNames.end());
    set(&LawSegment::over, table_.need("over", "the length of the segment", as_quantity,
                                       {quantities_.coordinate, Sign::kPositive}));
    const auto choice = table_.need("law", "the name of a law, \"cycloidal\"", as_choice, names);
    if (!choice) {
      table_.knows({"rise", "start", "end", "cosines", "sines"});
      table_.finish();
      return;
    }
    const auto type = static_cast<LawType>(*choice);
    profile_.type = si_.type = type;
    const bool polynomial = type == LawType::kPolynomial;
    const bool harmonics = type == LawType::kHarmonics;
    const bool must_rise = !polynomial && !harmonics && type != LawType::kDwell;
    set(&LawSegment::rise, must_rise ? table_.need("rise", "by how much the value grows over the segment",
                                                   as_quantity, {quantities_.value})
                                     : table_.take("rise", as_quantity, {quantities_.value}));
    for (const auto& [key, member] :
         {std::pair("start", &LawSegment::start), std::pair("end", &LawSegment::end)}) {
      polynomial ? read_conditions(key, member)
                 : table_.refuse(key, "has a meaning for law = \"polynomial\" only");
    }
    for (const auto& [key, member] :
         {std::pair("cosines", &LawSegment::cosines), std::pair("sines", &LawSegment::sines)}) {
      harmonics ? read_amplitudes(key, member)
                : table_.refuse(key, "has a meaning for law = \"harmonics\" only");
    }
    table_.finish();
  }

private:
  void set(double LawSegment::*member, const std::optional<Quantity>& quantity) {
    if (quantity) {
      profile_.*member = quantity->profile;
      si_.*member = quantity->si;
    }
  }

  void add(std::vector<double> LawSegment::*member, const Quantity& quantity) {
    (profile_.*member).push_back(quantity.profile);
    (si_.*member).push_back(quantity.si);
  }

  // [s, v, a, …], each in its own unit.
  void read_conditions(const std::string& key, std::vector<double> LawSegment::*member) {
    const auto item =
        table_.need(key, "the value there and as many derivatives as are to be given, [s, v, a, ...]");
    const auto items = item ? as_items(table_.reading(), *item, "a list, [s, v, a, ...]") : std::nullopt;
    Dimension dimension = quantities_.value;
    for (const Item& number : items.value_or(std::vector<Item>{})) {
      add(member, as_quantity(table_.reading(), number, {dimension}).value_or(Quantity{}));
      dimension = dimension / quantities_.coordinate;
    }
  }

  void read_amplitudes(const std::string& key, std::vector<double> LawSegment::*member) {
    const auto list = table_.take(key, as_list, {quantities_.value}, 0);
    for (const Quantity& amplitude : list.value_or(std::vector<Quantity>{})) {
      add(member, amplitude);
    }
  }

  TableReader& table_;
  const LawQuantities& quantities_;
  LawSegment& profile_;
  LawSegment& si_;
};

}  // namespace

void read_law_segments(TableReader& table, const Item& item, const LawQuantities& quantities, ReadLaw& law) {
  for (const auto& [key, member, dimension] :
       {std::tuple("origin", &LawDescription::origin, quantities.coordinate),
        std::tuple("start", &LawDescription::start, quantities.value)}) {
    if (const auto quantity = table.take(key, as_quantity, {dimension})) {
      law.profile.*member = quantity->profile;
      law.si.*member = quantity->si;
    }
  }
  const auto items = as_items(table.reading(), item,
                              "a list of segments, [{ over = 120, law = \"cycloidal\", rise = 20 }, ...]");
  for (const Item& one : items.value_or(std::vector<Item>{})) {
    LawSegment& profile = law.profile.segments.emplace_back();
    LawSegment& si = law.si.segments.emplace_back();
    if (auto reader = as_reader(table.reading(), one, "a segment (a table)")) {
      SegmentReader(*reader, quantities, profile, si).read();
    }
  }
}

}  // namespace higherpair::io_detail
