#include "laws.hpp"

#include <utility>

namespace higherpair::io_detail {
namespace {

std::optional<ReadLaw> read_item(Reading& reading, const Item& item, const LawQuantities& quantities) {
  TableReader table(reading, *item.value);
  auto law = read_law(table, quantities);
  if (law) {
    note_law(table, quantities, *law);
  }
  return law;
}

}  // namespace

LawBook::LawBook(TableReader& root) : reading_(&root.reading()) {
  for_each_named(*reading_, root.take("laws"), "a law (a table)",
                 [&](const std::string& name, const Item& item) {
                   if (as_table(*reading_, item, "a law (a table)") != nullptr) {
                     entries_.push_back({name, item, false});
                   }
                 });
}

std::optional<int> LawBook::find(const Item& name, const LawQuantities& quantities, Mechanism& mechanism) {
  const auto text = as_text(*reading_, name);
  if (!text) {
    return std::nullopt;
  }
  const auto index = named_thing(*reading_, name, *text, "there is no law", entries_, "laws");
  if (!index) {
    return std::nullopt;
  }
  const auto place = static_cast<std::size_t>(*index);
  Entry& entry = entries_[place];
  entry.used = true;
  bool noted = false;
  for (const Known& known : known_) {
    if (known.entry == place && known.quantities == quantities) {
      return known.index;
    }
    noted = noted || (known.entry == place && known.quantities.coordinate == quantities.coordinate &&
                      known.quantities.value == quantities.value);
  }
  Known known{place, quantities, std::nullopt};
  const auto notes = static_cast<std::ptrdiff_t>(reading_->notes.size());
  if (auto law = read_item(*reading_, entry.item, quantities)) {
    if (noted) {  // noted before, when the law was read in the other units
      reading_->notes.erase(reading_->notes.begin() + notes, reading_->notes.end());
    }
    known.index = static_cast<int>(mechanism.laws.size());
    laws_.push_back(*std::move(law->made));
    mechanism.laws.push_back({*text, std::move(law->si)});
  }
  known_.push_back(known);
  return known.index;
}

const MotionLaw& LawBook::made(int index) const {
  return laws_[index];
}

void LawBook::finish() {
  for (const Entry& entry : entries_) {
    if (entry.used) {
      continue;
    }
    // The intended quantities are unknown: the law is right if it can be read with any of these pairs.
    std::optional<Reading> first;
    bool right = false;
    for (const Dimension& coordinate : {dimension::kAngle, dimension::kTime, dimension::kLength}) {
      for (const Dimension& value : {dimension::kLength, dimension::kAngle}) {
        Reading trial = *reading_;
        right = right || read_item(trial, entry.item, {coordinate, value});
        if (!first) {
          first = std::move(trial);
        }
      }
    }
    if (!right) {
      reading_->mistakes = std::move(first->mistakes);
    }
    reading_->notes.push_back(
        {entry.item.value->mark,
         path_of(*reading_, entry.item) + ": nothing uses this law; a driver does by its key `law`"});
  }
}

}  // namespace higherpair::io_detail
