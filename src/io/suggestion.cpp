#include "suggestion.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kMostSuggestions = 3;
constexpr std::size_t kMostListed = 12;
constexpr std::size_t kLongestCompared = 64;  // the distance costs length²; longer names are no slips

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// One wrong letter always, and one more for every four letters.
bool is_near(int distance, std::string_view name) {
  return distance <= 1 + static_cast<int>(name.size() / 4) && distance < static_cast<int>(name.size());
}

std::vector<std::string> nearest(std::string_view name, const std::vector<std::string>& existing) {
  struct Candidate {
    int distance;
    std::string_view name;
  };
  std::vector<Candidate> candidates;
  for (const std::string& candidate : existing) {
    const int distance = edit_distance(name, candidate);
    if (is_near(distance, name) || (name.size() == 1 && distance <= 1)) {
      candidates.push_back({distance, candidate});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(candidates.size(), kMostSuggestions); ++i) {
    names.push_back(fmt::format("`{}`", candidates[i].name));
  }
  return names;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  if (a.size() > kLongestCompared || b.size() > kLongestCompared) {
    return static_cast<int>(std::max(a.size(), b.size()));
  }
  // Rows i-2, i-1 and i of the table of distances between the first i letters of a and the first j of b.
  std::vector<int> before(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = last;
    last = row;
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + replace});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

std::string suggestion(std::string_view name, const std::vector<std::string>& existing) {
  if (existing.empty()) {
    return "there is none";
  }
  const std::vector<std::string> names = nearest(name, existing);
  if (!names.empty()) {
    return fmt::format("did you mean {}?", fmt::join(names, " or "));
  }
  const auto listed = std::min(existing.size(), kMostListed);
  return fmt::format(
      "there {} {}{}", existing.size() == 1 ? "is only" : "are",
      fmt::join(existing.begin(), existing.begin() + static_cast<std::ptrdiff_t>(listed), ", "),
      listed < existing.size() ? ", …" : "");
}

}  // namespace higherpair::io_detail
