#pragma once

#include <algorithm>
#include <iterator>

namespace higherpair {

/// Whether one of the items is equal to `item`.
template <class Items, class Item>
[[nodiscard]] bool contains(const Items& items, const Item& item) {
  return std::find(std::begin(items), std::end(items), item) != std::end(items);
}

}  // namespace higherpair
