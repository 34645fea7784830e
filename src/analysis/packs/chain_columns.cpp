#include "chain_columns.hpp"

#include "higherpair/mechanism/description.hpp"
#include "higherpair/numeric/overload.hpp"

#include <algorithm>
#include <variant>

namespace higherpair {

ChainRates rates_for(std::span<const ChainColumn> columns) {
  ChainRates rates = ChainRates::kNone;
  for (const ChainColumn& column : columns) {
    rates = std::max(rates, column.quantity >= ChainColumn::Quantity::kAx   ? ChainRates::kAccelerations
                            : column.quantity >= ChainColumn::Quantity::kVx ? ChainRates::kVelocities
                                                                            : ChainRates::kNone);
  }
  return rates;
}

std::vector<char> placed_bodies(std::span<const ChainGroup> groups, std::span<const ChainColumn> columns,
                                std::size_t bodies) {
  using Quantity = ChainColumn::Quantity;
  std::vector<char> placed(bodies, 0);
  const auto place = [&](int body) { placed[body] = 1; };
  for (const ChainColumn& column : columns) {
    if (is_force(column.quantity)) {
      return std::vector<char>(bodies, 1);
    }
    const bool turning = column.quantity == Quantity::kAngle || column.quantity == Quantity::kOmega ||
                         column.quantity == Quantity::kAlpha;
    if (!turning && column.quantity != Quantity::kPressure) {
      place(column.item);
    }
  }
  for (const ChainGroup& group : groups) {
    if (const ChainTouch* touch = touch_of(group)) {  // of discs or ovals; variants may differ
      place(touch->link);
      place(touch->known);
      place(touch->carrier);
      continue;
    }
    const auto place_known = [&](const auto& dyad) {
      for (const int body : dyad.known()) {
        place(body);
      }
    };
    std::visit(Overload{[](const DrivenBody&) {}, [](const OvalContact&) {}, place_known,
                        [&](const RrpDyad& dyad) {
                          place_known(dyad);
                          if (dyad.slider) {
                            place(dyad.link);
                          }
                        }},
               group.kind);
  }
  return placed;
}

std::vector<ChainAngle> angles_of(std::span<const ChainGroup> groups, std::size_t bodies,
                                  std::vector<ChainTurning>& turnings) {
  std::vector<ChainAngle> angles(bodies);
  const auto at = [&](int body) -> ChainAngle& { return angles[body]; };
  const auto turns = [&](int body) {
    at(body) = {0, static_cast<int>(turnings.size()), 0};
    turnings.push_back({body});
  };
  for (const ChainGroup& group : groups) {
    std::visit(
        Overload{[&](const DrivenBody& driven) {
                   const auto& [body, carrier, freedom, sign] = driven.carried;
                   at(body) = freedom.turns ? ChainAngle{sign, -1, 0} : ChainAngle{0, -1, freedom.theta};
                 },
                 [&](const OvalContact& ovals) {
                   const OneFreedom& freedom = ovals.touch.freedom;
                   if (freedom.turns) {
                     turns(ovals.touch.body);
                   } else {
                     at(ovals.touch.body) = {0, -1, freedom.theta};
                   }
                 },
                 [&](const auto& dyad) {
                   for (const int link : dyad.links()) {
                     turns(link);
                   }
                   if constexpr (requires { dyad.slider; }) {
                     if (dyad.slider) {
                       at(dyad.slider->body) = at(dyad.slider->carrier);
                       at(dyad.slider->body).offset += dyad.slider->relative_angle;
                     }
                   }
                 }},
        group.kind);
  }
  return angles;
}

const ChainTouch* touch_in(std::span<const ChainGroup> groups, int contact) {
  for (const ChainGroup& group : groups) {
    if (const ChainTouch* touch = touch_of(group); touch != nullptr && touch->contact == contact) {
      return touch;
    }
  }
  return nullptr;
}

bool has_pressure(const Mechanism& mechanism, std::span<const ChainGroup> groups, int contact) {
  const ChainTouch* touch = touch_in(groups, contact);
  const Contact& of = mechanism.contacts[contact];
  return touch != nullptr && touch->carrier == kGround && of.second.body == touch->body &&
         of.first.body != kGround;
}

}  // namespace higherpair
