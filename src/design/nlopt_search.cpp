#include "search.hpp"
#include "tolerances.hpp"

#include <memory>
#include <nlopt.h>

// This uses NLopt's C interface: the C++ one turns every outcome but success into an exception, and reports
// exceptions of the callbacks as a failure without a reason. The point that NLopt returns is ignored: SLSQP
// may return one that violates a constraint, COBYLA one that is not its best. Search keeps the best of all
// candidates that were evaluated.

namespace higherpair {
namespace {

constexpr int kMostEvaluations = 500;       // for SLSQP, not counting gradients
constexpr int kMostWithoutGradients = 100;  // for the methods without gradients, per variable
constexpr int kMostOfEvolution = 2000;      // the same for ISRES

struct Bridge {
  Search& search;
  nlopt_opt opt;
  bool penalties;

  [[nodiscard]] Eigen::VectorXd point(unsigned n, const double* x) const {
    return Eigen::Map<const Eigen::VectorXd>(x, n);
  }
};

double objective(unsigned n, const double* x, double* gradient, void* data) {
  auto& bridge = *static_cast<Bridge*>(data);
  if (bridge.search.stopped()) {
    nlopt_force_stop(bridge.opt);
    return 0;
  }
  const Eigen::VectorXd u = bridge.point(n, x);
  const DesignValues values = bridge.search.evaluate(u);
  if (gradient != nullptr) {
    Eigen::Map<Eigen::RowVectorXd>(gradient, n) = objective_slope(values, bridge.search.differentiate(u));
  }
  const double penalty = bridge.penalties && values.constraints.size() > 0
                             ? kPenalty * values.constraints.cwiseMax(0.0).sum()
                             : 0;
  return objective_of(values) + penalty;
}

void constraints(unsigned m, double* result, unsigned n, const double* x, double* gradient, void* data) {
  auto& bridge = *static_cast<Bridge*>(data);
  const Eigen::VectorXd u = bridge.point(n, x);
  Eigen::Map<Eigen::VectorXd>(result, m) = bridge.search.evaluate(u).constraints;
  if (gradient != nullptr) {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(gradient, m, n) = bridge.search.differentiate(u).constraints;
  }
}

struct Method {
  nlopt_algorithm algorithm;
  bool constraints;  // whether it supports them
  int most;          // limit of evaluations
};

Method method_of(DesignMethod method, Eigen::Index variables) {
  const int n = static_cast<int>(variables);
  switch (method) {
    case DesignMethod::kCobyla:
      return {NLOPT_LN_COBYLA, true, kMostWithoutGradients * n};
    case DesignMethod::kBobyqa:
      return {NLOPT_LN_BOBYQA, false, kMostWithoutGradients * n};
    case DesignMethod::kIsres:
      return {NLOPT_GN_ISRES, true, kMostOfEvolution * n};
    default:
      return {NLOPT_LD_SLSQP, true, kMostEvaluations};
  }
}

}  // namespace

void search_by_nlopt(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed) {
  const auto n = static_cast<unsigned>(search.size());
  const Method chosen = method_of(method, search.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> opt(nlopt_create(chosen.algorithm, n),
                                                              nlopt_destroy);
  if (!opt) {
    return;
  }
  Bridge bridge{search, opt.get(), !chosen.constraints};
  Eigen::VectorXd low = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd high = Eigen::VectorXd::Ones(n);
  Eigen::VectorXd at = u.cwiseMax(0.0).cwiseMin(1.0);
  for (unsigned i = 0; i < n; ++i) {
    if (search.is_fixed(i)) {
      low(i) = high(i) = at(i);
    }
  }
  nlopt_set_lower_bounds(opt.get(), low.data());
  nlopt_set_upper_bounds(opt.get(), high.data());
  nlopt_set_min_objective(opt.get(), objective, &bridge);
  if (const auto count = static_cast<unsigned>(search.problem().constraints);
      chosen.constraints && count > 0) {
    const std::vector<double> tolerances(count, 0.0);
    nlopt_add_inequality_mconstraint(opt.get(), count, constraints, &bridge, tolerances.data());
  }
  nlopt_set_maxeval(opt.get(), chosen.most);
  nlopt_set_xtol_rel(opt.get(), kVariablesSettled);
  nlopt_set_ftol_rel(opt.get(), kObjectiveSettled);
  nlopt_set_initial_step1(opt.get(), kFirstDesignStep);
  nlopt_srand(static_cast<unsigned long>(seed));
  double value = 0;
  (void)nlopt_optimize(opt.get(), at.data(), &value);
}

}  // namespace higherpair
