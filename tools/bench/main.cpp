// Measures the time of one step, together with that of a four-bar written by hand in the same run. All
// results are checked before anything is timed.
#include "boundaries.hpp"
#include "checks.hpp"
#include "designs.hpp"
#include "front/columns/column_set.hpp"
#include "higherpair/cam/law_series.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/front/check.hpp"
#include "laws.hpp"
#include "linkages.hpp"
#include "long_runs.hpp"
#include "packs.hpp"
#include "variants.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string_view>

#include <benchmark/benchmark.h>
#include <fmt/core.h>

namespace higherpair::bench {
namespace {

double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

// Runs steps over whole turns, repeatedly. `restart` puts the object under test back to the start. The
// fastest turn is compared with the floor, which is also that of the fastest turn.
template <class Step, class Restart>
void run_turns(benchmark::State& state, double floor, const Step& step, const Restart& restart) {
  int number = 0;
  double best = INFINITY;
  restart();
  auto start = std::chrono::steady_clock::now();
  for (auto _ : state) {
    if (number == kStepsPerTurn) {
      best = std::min(best, nanoseconds_since(start));
      number = 0;
      restart();
      start = std::chrono::steady_clock::now();
    }
    step(number++);
  }
  if (std::isfinite(best)) {
    state.counters["floors"] = best / kStepsPerTurn / floor;
  }
}

// The floor: the fastest of many turns, which excludes disturbances by other processes.
double measure_floor() {
  double best = INFINITY;
  for (int turn = 0; turn < 500; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < kStepsPerTurn; ++step) {
      benchmark::DoNotOptimize(kFourBar.at(driver_position(step)));
    }
    best = std::min(best, nanoseconds_since(start) / kStepsPerTurn);
  }
  return best;
}

template <class Function>
void add([[maybe_unused]] const std::string& name, [[maybe_unused]] const Function& function) {
#ifndef __clang_analyzer__  // the analyser mistakes the registry, which owns what it is given, for a leak
  benchmark::RegisterBenchmark(name.c_str(), function);
#endif
}

void register_floor(double floor) {
  const auto nothing = [] {};
  add("four_bar/by_hand (the floor)", [=](benchmark::State& state) {
    const auto step = [](int k) { benchmark::DoNotOptimize(kFourBar.at(driver_position(k))); };
    run_turns(state, floor, step, nothing);
  });
}

void register_tracking(const Case& reference, double floor) {
  add("step/" + reference.name, [=](benchmark::State& state) {
    ContactTrack track;
    const auto step = [&](int k) {
      benchmark::DoNotOptimize(step_to(track, driver_position(k), track.branch));
    };
    run_turns(state, floor, step, [&] { track = track_of(reference.run); });
  });
  add("step_and_details/" + reference.name, [=](benchmark::State& state) {
    ContactTrack track;
    const auto step = [&](int k) {
      benchmark::DoNotOptimize(step_to(track, driver_position(k), track.branch));
      benchmark::DoNotOptimize(details_of(track.pair, track.at, track.phi));
    };
    run_turns(state, floor, step, [&] { track = track_of(reference.run); });
  });
}

// Computes rows as the program does. `level` 0: the motion; 1: also the cells of the table; 2: also the text.
void run_rows(benchmark::State& state, const Case& reference, double floor, int level) {
  Run run = reference.run;
  ColumnSet table = table_of(reference.profile);
  Row row;
  std::string text;
  std::vector<DriverMotion> motions(1);
  std::vector<DriverState> drivers(1);
  const auto step = [&](int k) {
    const double u = driver_position(k);
    motions[0] = {u, 1, 0};
    move_to(run, motions);
    benchmark::DoNotOptimize(run.row.bodies.data());
    if (level == 0) {
      return;
    }
    drivers[0] = {{k * 360.0 / kStepsPerTurn, 1, 0}, {u, 1, 0}};
    table.fill({run, drivers}, row.values);
    benchmark::DoNotOptimize(row.values.data());
    if (level == 2) {
      if (text.size() > 1 << 16) {
        text.clear();
      }
      append_csv_row(table.columns(), row, text);
      benchmark::DoNotOptimize(text.data());
    }
  };
  run_turns(state, floor, step, [&] { run = reference.run; });
  if (level > 0) {
    state.counters["columns"] = static_cast<double>(table.columns().size());
  }
}

// Computes a row and the scene of a picture of it.
void run_scenes(benchmark::State& state, const Case& reference, double floor) {
  Run run = reference.run;
  std::vector<DriverMotion> motions{{driver_position(0), 1, 0}};
  move_to(run, motions);
  SceneMaker maker(reference.profile.mechanism, {run.row});
  const auto step = [&](int k) {
    motions[0] = {driver_position(k), 1, 0};
    move_to(run, motions);
    benchmark::DoNotOptimize(maker.at(run.row).moving.size());
  };
  run_turns(state, floor, step, [&] { run = reference.run; });
}

void register_rows(const Case& reference, double floor) {
  add("scene/" + reference.name, [=](benchmark::State& state) { run_scenes(state, reference, floor); });
  static constexpr std::array kLevels{"move_to/", "move_to_and_cells/", "move_to_and_csv/"};
  for (int level = 0; level < 3; ++level) {
    add(kLevels[level] + reference.name,
        [=](benchmark::State& state) { run_rows(state, reference, floor, level); });
  }
}

void register_watt_by_hand(const SixBarByHand& by_hand, double floor) {
  const auto nothing = [] {};
  add("watt_sixbar/by_hand", [=](benchmark::State& state) {
    const auto step = [&](int k) { benchmark::DoNotOptimize(by_hand.motion_at(driver_position(k))); };
    run_turns(state, floor, step, nothing);
  });
  add("watt_sixbar/by_hand_with_forces", [=](benchmark::State& state) {
    const auto step = [&](int k) {
      const SixBarByHand::Motion motion = by_hand.motion_at(driver_position(k));
      benchmark::DoNotOptimize(motion);
      benchmark::DoNotOptimize(by_hand.forces_of(motion));
    };
    run_turns(state, floor, step, nothing);
  });
}

// Evaluates s, v, a and j at each step.
void register_laws(const std::vector<LawCase>& laws, double floor) {
  const auto nothing = [] {};
  add("law/by_hand", [=](benchmark::State& state) {
    const auto step = [](int k) { benchmark::DoNotOptimize(kCam.at(driver_position(k))); };
    run_turns(state, floor, step, nothing);
  });
  for (const LawCase& one : laws) {
    add("law/" + one.name, [=](benchmark::State& state) {
      const auto step = [&](int k) { benchmark::DoNotOptimize(series_at<3>(one.law, driver_position(k))); };
      run_turns(state, floor, step, nothing);
    });
  }
}

// Runs on one thread; one of the candidate's hundred positions is compared with the floor.
void register_design(const DesignCase& design, double floor) {
  for (const bool gradients : {false, true}) {
    add(gradients ? "design/candidate_with_gradients" : "design/candidate", [=](benchmark::State& state) {
      const auto evaluator = design.problem.evaluator();
      DesignValues values;
      DesignJacobian jacobian;
      std::size_t number = 0;
      const auto start = std::chrono::steady_clock::now();
      for (auto _ : state) {
        const std::vector<double>& x = design.candidates[number++ % design.candidates.size()];
        evaluator->evaluate(x, design.problem.start_branch, values);
        if (gradients) (void)evaluator->differentiate(x, design.problem.start_branch, jacobian);
        benchmark::DoNotOptimize(values.residuals.data());
        benchmark::DoNotOptimize(jacobian.residuals.data());
      }
      const Eigen::Index places = values.residuals.size() / 2;
      const double positions = static_cast<double>(number) * static_cast<double>(places);
      state.counters["floors"] = nanoseconds_since(start) / positions / floor;
      state.SetItemsProcessed(static_cast<std::int64_t>(number));
    });
  }
}

// Compares a cam given by points with the same one as a conic, move_to/ellipse_on_circle; and a step over a
// joint of arcs with one before it.
void register_boundaries(const BoundaryCase& spline, const JointCase& joint, double floor) {
  add("move_to/" + spline.name, [=](benchmark::State& state) {
    Run run = spline.run;
    std::vector<DriverMotion> motions(1);
    const auto step = [&](int k) {
      motions[0] = {driver_position(k), 1, 0};
      move_to(run, motions);
      benchmark::DoNotOptimize(run.row.bodies.data());
    };
    run_turns(state, floor, step, [&] { run = spline.run; });
  });
  const auto add_step = [&](const std::string& name, const Run& start) {
    add("one_step/" + name, [=, step = joint.step](benchmark::State& state) {
      const std::vector<DriverMotion> next{{start.at.inputs.front() + step, 1, 0}};
      Run run = start;
      for (auto _ : state) {
        run.at = start.at;
        move_to(run, next);
        benchmark::DoNotOptimize(run.row.bodies.data());
      }
    });
  };
  add_step("on_an_arc", joint.before_that);
  add_step("over_a_joint_of_arcs", joint.before_joint);
}

// Reads and checks whole files.
void register_files(const LargeFiles& large) {
  for (const LargeFiles::File& file : large.files()) {
    add((file.check ? "read_and_check/" : "read/") + file.name, [=](benchmark::State& state) {
      for (auto _ : state) {
        const auto model = Model::open(file.profile);
        benchmark::DoNotOptimize(model.has_value());
        if (file.check) {
          benchmark::DoNotOptimize(check(*model).has_value());
        }
      }
      state.SetLabel("whole file");
    });
  }
}

// Uses the general plan: the motion of all bodies, and optionally the reactions of all joints.
void register_plan(const std::string& name, const Run& start, double floor) {
  const auto measure = [=](benchmark::State& state, bool with_forces) {
    Run run = start;
    InverseDynamics dynamics(run);
    const double from = start.at.inputs.front();
    std::vector<DriverMotion> motions(1);
    const auto step = [&](int k) {
      motions[0] = {from + driver_position(k), 1, 0};
      move_to(run, motions);
      benchmark::DoNotOptimize(run.row.bodies.data());
      if (with_forces) {
        benchmark::DoNotOptimize(dynamics.solve(run));
      }
    };
    run_turns(state, floor, step, [&] { run = start; });
  };
  add("plan/" + name, [=](benchmark::State& state) { measure(state, false); });
  add("plan_with_forces/" + name, [=](benchmark::State& state) { measure(state, true); });
}

// The fastest of many variants computed by hand [ns].
double measure_variant_floor(const DriverTable& driver) {
  double best = INFINITY;
  for (int turn = 0; turn < 2000; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(variant_by_hand({1, 2 + 1e-9 * turn, 3.5, 4, 2, 1}, driver, 10));
    best = std::min(best, nanoseconds_since(start));
  }
  return best;
}

// Whole turns, many rows at a time; a vector floor is one step of the four-bar by hand in vector registers.
void register_packs(const std::vector<std::shared_ptr<PackCase>>& cases, double vector_floor) {
  for (const auto& one : cases) {
    add("packs/" + one->name, [=](benchmark::State& state) {
      double best = INFINITY;
      for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(one->chain.solve(one->mechanism));
        benchmark::DoNotOptimize(one->chain.values(0).data());
        best = std::min(best, nanoseconds_since(start) / kStepsPerTurn);
      }
      state.counters["ns_a_step"] = best;
      state.counters["vector_floors"] = best / vector_floor;
    });
  }
}

// Computes a sweep block by block; an iteration is one variant.
void register_variants(const std::vector<VariantCase>& cases) {
  const DriverTable driver = driver_table();
  const double floor = measure_variant_floor(driver);
  add("variant/by_hand (its floor)", [=](benchmark::State& state) {
    double crank = 2;
    for (auto _ : state) {
      benchmark::DoNotOptimize(variant_by_hand({1, crank += 1e-9, 3.5, 4, 2, 1}, driver, 10));
    }
    state.counters["variant_floors"] = 1;
  });
  for (const VariantCase& one : cases) {
    add("variant/" + one.name, [=](benchmark::State& state) {
      const Sweep& sweep = one.sweep;
      double best = INFINITY;
      std::int64_t block = 0;
      const std::int64_t variants = sweep.variants_of(0);
      while (state.KeepRunningBatch(variants)) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(sweep.block(block++ % (sweep.blocks() - 1)).values.data());
        best = std::min(best, nanoseconds_since(start) / static_cast<double>(variants));
      }
      state.counters["variant_floors"] = best / floor;
    });
  }
}

// Tables as the program makes them, in wall-clock time: rows per second on one thread and on two, and for
// formatting alone.
void register_long_runs() {
  const auto rate = [](double rows) { return benchmark::Counter(rows, benchmark::Counter::kIsRate); };
  for (const LongRun& one : long_runs()) {
    for (const int threads : {1, 2}) {
      benchmark::RegisterBenchmark(fmt::format("table/{}/threads:{}", one.profile, threads).c_str(),
                                   [=](benchmark::State& state) {
                                     double rows = 0;
                                     for (auto _ : state) rows += work_out(one, threads);
                                     state.counters["rows/s"] = rate(rows);
                                   })
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    }
    add("csv_of_ready_rows/" + one.profile, [=](benchmark::State& state) {
      const ReadyBlock ready = ready_block(one);
      std::string text;
      double rows = 0;
      for (auto _ : state) {
        text.clear();
        append_csv_rows(ready.columns, ready.rows, text);
        benchmark::DoNotOptimize(text.data());
        rows += static_cast<double>(ready.rows.size());
      }
      state.counters["rows/s"] = rate(rows);
      state.counters["columns"] = static_cast<double>(ready.columns.size());
    });
  }
}

std::vector<std::shared_ptr<PackCase>> checked_all_packs(const Run& four_bar, const Run& watt,
                                                         const std::vector<Case>& cases) {
  std::vector<std::shared_ptr<PackCase>> packs;
  const auto add = [&](PackCase packed) { packs.push_back(std::make_shared<PackCase>(std::move(packed))); };
  add(checked_packs("four_bar", four_bar));
  add(checked_packs("watt_sixbar", watt));
  add(checked_packs_with_forces("watt_sixbar_with_forces", watt));
  for (std::size_t i = 0; i + 1 < cases.size(); ++i) {  // all but the flat face
    add(checked_packs(cases[i].name, cases[i].run));
  }
  return packs;
}

// Returns the exit code.
int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const bool only_check = argc == 2 && std::string_view(argv[1]) == "--check";
  if (!only_check && benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  check_four_bar();
  const std::vector<Case> cases = make_cases();
  for (const Case& reference : cases) {
    check_tracking(reference);
    check_rows(reference);
  }
  const LinkageCase<FourBarByHand> four_bar = checked_four_bar();
  const LinkageCase<SixBarByHand> watt = checked_watt_sixbar();
  const std::vector<LawCase> laws = checked_laws();
  const std::vector<VariantCase> variants = checked_variants();
  const auto packs = checked_all_packs(four_bar.run, watt.run, cases);
  VectorFourBar vector_bar = checked_vector_floor();
  const DesignCase design = checked_design();
  const BoundaryCase spline_cam = checked_spline_cam(cases[1]);
  const JointCase joint = checked_joint();
  const LargeFiles large;
  require_right(large);
  for (const LongRun& one : long_runs()) {
    check_long_run(one);
  }
  fmt::print(stderr, "bench: all answers agree\n");
  if (only_check) {
    return 0;
  }

  const double floor = measure_floor();
  register_floor(floor);
  register_watt_by_hand(watt.by_hand, floor);
  register_laws(laws, floor);
  register_design(design, floor);
  register_plan("four_bar", four_bar.run, floor);
  register_plan("watt_sixbar", watt.run, floor);
  const double vector_floor = measure(vector_bar);
  register_packs(packs, vector_floor);
  register_variants(variants);
  for (const Case& reference : cases) {
    register_tracking(reference, floor);
  }
  for (const Case& reference : cases) {
    register_rows(reference, floor);
  }
  register_boundaries(spline_cam, joint, floor);
  register_files(large);
  register_long_runs();
  benchmark::AddCustomContext("floor",
                              fmt::format("{:.1f} ns a step: four-bar by hand, sincos and atan2", floor));
  benchmark::AddCustomContext(
      "vector floor",
      fmt::format("{:.1f} ns a step: four-bar by hand, unit vectors, in vectors", vector_floor));
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace higherpair::bench

int main(int argc, char** argv) {
  return higherpair::bench::run(argc, argv);
}
