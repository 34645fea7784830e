#include "search_bytes.hpp"

#include "record_bytes.hpp"

#include <cstdint>

namespace higherpair::cli {
namespace {

struct SearchHead {
  std::int32_t number = 0;
  std::int32_t branch = 0;
  std::int64_t evaluations = 0;
  double objective = 0;
  double violation = 0;
};

}  // namespace

std::string search_bytes(const DesignSearchEnd& end) {
  std::string bytes;
  put(SearchHead{end.number, end.best.branch, end.evaluations, end.best.objective, end.best.violation},
      bytes);
  for (const double x : end.best.x) put(x, bytes);
  return bytes;
}

std::optional<DesignSearchEnd> search_of(std::string_view bytes) {
  if (bytes.size() < sizeof(SearchHead) || (bytes.size() - sizeof(SearchHead)) % sizeof(double) != 0) {
    return std::nullopt;
  }
  const auto head = take<SearchHead>(bytes);
  DesignSearchEnd end{head.number, {{}, head.branch, head.objective, head.violation}, head.evaluations};
  while (!bytes.empty()) end.best.x.push_back(take<double>(bytes));
  return end;
}

}  // namespace higherpair::cli
