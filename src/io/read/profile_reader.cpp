#include "higherpair/io/profile_reader.hpp"

#include "higherpair/io/names.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "io/document/consequences.hpp"
#include "io/document/document_content.hpp"
#include "io/notes/profile_notes.hpp"
#include "read_design.hpp"
#include "reading.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::Reading;
using io_detail::Table;
using io_detail::TableReader;
using io_detail::Value;

// False if the format's version is unknown: then no further message is useful.
bool read_format(TableReader& root) {
  const auto item = root.take("format");
  const auto format = item ? io_detail::as_integer(root.reading(), *item) : std::nullopt;
  if (!format) {
    return true;
  }
  if (*format > kProfileFormat) {
    report(root.reading(), *item,
           fmt::format("this profile needs a newer higherpair; this one reads format {}", kProfileFormat));
    return false;
  }
  if (*format < 1) {
    report(root.reading(), *item, fmt::format("expected format {}", kProfileFormat));
  }
  return true;
}

// A vector. For a mere number, the message shows how that one is written if it points downwards.
Vector2d read_gravity(Reading& reading, const io_detail::Item& item) {
  if (std::holds_alternative<io_detail::Array>(item.value->content)) {
    return io_detail::as_vector(reading, item, dimension::kAcceleration).value_or(Vector2d::Zero());
  }
  std::string downwards = "\"-9.81 m/s^2\"";
  if (const auto number = io_detail::number_in(*item.value)) {
    downwards = fmt::format("{}", -std::abs(*number));
  } else if (const auto* text = std::get_if<std::string>(&item.value->content)) {
    const std::string size = text->substr(std::min(text->find_first_of("0123456789."), text->size()));
    if (parse_quantity(size, dimension::kAcceleration, reading.units))
      downwards = fmt::format("\"-{}\"", size);
  }
  report(reading, item, fmt::format("expected [x, y]; downwards it is [0, {}]", downwards));
  return Vector2d::Zero();
}

Profile read_root(TableReader& root, const Table& document) {
  Profile profile;
  if (!read_format(root)) {
    return profile;
  }
  Mechanism& mechanism = profile.mechanism;
  read_units(root);
  profile.units = root.reading().units;
  mechanism.title = root.text("title");
  mechanism.description = root.text("description");
  if (const auto gravity = root.take("gravity")) {
    mechanism.gravity_W = read_gravity(root.reading(), *gravity);
  }
  io_detail::LawBook laws(root);
  io_detail::LateCurves late;
  read_bodies(root, mechanism, late);
  const std::vector<bool> joint_type_known = read_joints(root, mechanism);
  read_contacts(root, mechanism);
  make_late_curves(root.reading(), late, laws, mechanism);
  read_drivers(root, profile, joint_type_known, laws);
  read_loads(root, mechanism);
  read_springs(root, mechanism, joint_type_known);
  read_drawing(root, profile);
  read_limits(root, profile);
  read_sweep(root, document, profile);
  read_tolerances(root, document, profile);
  read_design(root, document, laws, profile);
  laws.finish();
  read_fit(root, profile);
  (void)root.take("extra");
  root.finish();
  return profile;
}

Profile read_document(const Value& document, Reading& reading) {
  const auto& table = std::get<Table>(document.content);
  reading.document = &document;
  note_varied(table, reading);
  TableReader root(reading, document);
  return read_root(root, table);
}

Diagnostics diagnostics_of(Reading reading) {
  Diagnostics diagnostics;
  for (const io_detail::Mistake& mistake : io_detail::without_consequences(std::move(reading.mistakes))) {
    diagnostics.push_back({place_of(reading, mistake.mark), io_detail::visible(mistake.message)});
  }
  return diagnostics;
}

// Of an override whose path is doubtful, says that instead of what is wrong with the table that it has made.
void doubt(const std::vector<std::string>& doubts, std::vector<io_detail::Mistake>& mistakes) {
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const int source = static_cast<int>(i) + 1;
    const auto is_of_it = [&](const io_detail::Mistake& mistake) { return mistake.mark.source == source; };
    if (doubts[i].empty() || std::none_of(mistakes.begin(), mistakes.end(), is_of_it)) {
      continue;
    }
    std::erase_if(mistakes, is_of_it);
    mistakes.push_back({{source, 0, 0}, doubts[i]});
  }
}

}  // namespace

tl::expected<Profile, Diagnostics> ProfileDocument::read() const {
  return read(true);
}

std::vector<ProfileDocument::Quantity> ProfileDocument::quantities() const {
  Reading reading;
  reading.sources = content_->sources;
  reading.lists_quantities = true;
  reading.advises = false;
  (void)read_document(content_->root, reading);
  std::vector<Quantity> quantities;
  std::set<std::string> seen;
  for (const Reading::ReadQuantity& quantity : reading.quantities) {
    if (seen.insert(quantity.path).second) {
      quantities.push_back({quantity.path, quantity.dimension, quantity.profile});
    }
  }
  return quantities;
}

tl::expected<Profile, Diagnostics> ProfileDocument::read(bool with_notes) const {
  Reading reading;
  reading.sources = content_->sources;
  reading.advises = with_notes;
  Profile profile = read_document(content_->root, reading);
  if (!reading.mistakes.empty()) {
    doubt(content_->doubts, reading.mistakes);
    return tl::unexpected(diagnostics_of(std::move(reading)));
  }
  profile.source = content_->sources.front();
  profile.files = reading.files;
  if (with_notes) {
    profile.notes = io_detail::profile_notes(reading, content_->root, profile);
  }
  use_boundaries(profile.mechanism);
  return profile;
}

tl::expected<Profile, Diagnostics> read_profile_text(std::string_view text, const std::string& source_name,
                                                     std::span<const std::string> overrides) {
  return ProfileDocument::parse(text, source_name)
      .and_then([&](const ProfileDocument& document) { return document.with(overrides); })
      .and_then([](const ProfileDocument& document) { return document.read(); });
}

tl::expected<Profile, Diagnostics> read_profile_file(const std::string& path,
                                                     std::span<const std::string> overrides) {
  return ProfileDocument::open(path)
      .and_then([&](const ProfileDocument& document) { return document.with(overrides); })
      .and_then([](const ProfileDocument& document) { return document.read(); });
}

}  // namespace higherpair
