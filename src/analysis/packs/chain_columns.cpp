#include "chain_columns.hpp"

#include "higherpair/mechanism/description.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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
    } else if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
      place(rrr->A.body);
      place(rrr->B.body);
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
      place(rrp->A.body);
      place(rrp->line.body);
      if (rrp->slider) {
        place(rrp->link);
      }
    } else if (const auto* rpr = std::get_if<RprDyad>(&group.kind)) {
      place(rpr->A.body);
      place(rpr->B.body);
    }
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
  const auto rides = [&](const std::optional<Rider>& rider) {
    if (rider) {
      at(rider->body) = at(rider->carrier);
      at(rider->body).offset += rider->relative_angle;
    }
  };
  for (const ChainGroup& group : groups) {
    if (const auto* driven = std::get_if<DrivenBody>(&group.kind)) {
      const CarriedBody& carried = driven->carried;
      at(carried.body) =
          carried.freedom.turns ? ChainAngle{carried.sign, -1, 0} : ChainAngle{0, -1, carried.freedom.theta};
    } else if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
      turns(rrr->link_a);
      turns(rrr->link_b);
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
      turns(rrp->link);
      rides(rrp->slider);
    } else if (const auto* rpr = std::get_if<RprDyad>(&group.kind)) {
      turns(rpr->link);
      rides(rpr->slider);
    } else if (const auto* ovals = std::get_if<OvalContact>(&group.kind)) {
      const OneFreedom& freedom = ovals->touch.freedom;
      if (freedom.turns) {
        turns(ovals->touch.body);
      } else {
        at(ovals->touch.body) = {0, -1, freedom.theta};
      }
    }
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
  return touch != nullptr && touch->carrier == kGround &&
         mechanism.contacts[contact].second.body == touch->body;
}

}  // namespace higherpair
