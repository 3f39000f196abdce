// SPDX-License-Identifier: GPL-3.0-or-later
#include "registrations.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "config/table.hpp"
#include "decay.hpp"
#include "literate/imports/import_csv.hpp"
#include "literate/imports/import_json.hpp"

using namespace literate;
using numerics::Estimate;

Sample read_sample(const std::filesystem::path& file) {
  const config::Table table = config::Table::parse_file(file);
  const Sample sample{.label = table.text("label"),
                      .counts = table.integer("counts"),
                      .half_life = table.quantity("half_life", "s"),
                      .distance = table.table("detector").quantity("distance", "m"),
                      .printed = table.printed_number("printed").value()};
  if (table.texts("times").empty()) table.fail("times", "there is at least one");
  if (sample.half_life <= 0) table.fail("half_life", "it is more than 0");
  table.reject_unknown_keys();
  return sample;
}

namespace {

// One value of each format.
void register_values(Document& document, const Sample& sample) {
  const Estimate left = share_left(600, sample.half_life);
  document.value("label", Value::text(sample.label));
  document.value("half-life", Value(sample.half_life, exact(), "s"));
  document.value("distance", Value(sample.distance, exact(), "m"));
  document.value("counts", Value(sample.counts, integer()));
  document.value("left", Value(left, supported(6)));
  document.value("left.percent", Value(left, percent(1)));
  document.value("left.two-digits", Value(left, significant(2).in_percent()));
  document.value("lost", Value(Estimate{1 - left.value, left.abs_error}, fixed(2)));
  document.value("rate",
                 Value(std::numbers::ln2 / sample.half_life, significant(4), "1/s").within(1e-15));
  document.value("mean-life", Value(mean_life(2000), uncertain()));
  document.value("mean-life_error",
                 Value(mean_life(2000).abs_error, scientific(1).rounded_up()).as_is());
  document.value("flow", Value(2.5, exact(), "m3 s-1"));
  document.value("gain", Value(1.25, exact(), "um.kg^-1/K2"));
  document.value("tilt", Value(3, exact(), "%"));
  document.value("negative", Value(-0.0047, fixed(1), "mm").as_is());
  document.flag("is-short", sample.half_life < 3600);
  document.flag("is-long", sample.half_life >= 3600);
}

Table table_of_times(const Sample& sample, bool breaks) {
  Table table(breaks ? "all-times" : "times",
              {Column("$t$", fixed(0), "s").exact(), Column("left", fixed(4)).under("share"),
               Column("lost", percent(1)).under("share"), Column("rate", significant(3), "1/s")});
  const int step = breaks ? 20 : 300;
  for (int time = 0; time <= 1500; time += step) {
    const Estimate left = share_left(time, sample.half_life);
    const Estimate lost{1 - left.value, left.abs_error};
    Cell rate(Estimate{left.value * std::numbers::ln2 / sample.half_life, 1e-15});
    table.add_row({double(time), time == 600 ? Cell(left).marked("a") : Cell(left), lost, rate});
  }
  return table.note("a", "After ten minutes.").note("Computed from \\val{half-life}.");
}

void register_tables(Document& document, const Sample& sample) {
  document.table(table_of_times(sample, false));
  document.table(table_of_times(sample, true).break_over_pages());

  Table methods("methods", {Column::text("method"), Column("$n$", integer()),
                            Column("mean life", scientific(3)),
                            Column("as printed", fixed(3), "m").scaled(-3)});
  methods.add_row({"trapezoidal", 200, mean_life(200), Cell::quoted(1.44e-3, -5)});
  methods.add_row({"with twice as many & more", 400, mean_life(400), {}});
  methods.add_row({Cell::latex("$n \\to \\infty$"),
                   {},
                   Estimate{1 / std::numbers::ln2, 1e-16},
                   Cell::quoted(1.442e-3, -6)});
  document.table(std::move(methods));
}

void register_figures(Document& document, const Sample& sample) {
  std::vector<double> times, left, lost;
  for (int time = 0; time <= 3000; time += 30) {
    times.push_back(time);
    left.push_back(share_left(time, sample.half_life).value);
    lost.push_back(1 - left.back());
  }
  const FigureData curves{{"t", times}, {"left", left}, {"lost", lost}};
  document.figure("decay", {.width_cm = 8,
                            .height_cm = 5,
                            .data = {{"curves", curves}},
                            .numbers = {{"half_life", sample.half_life}},
                            .texts = {{"share", "$n/n_0$"}}});
  document.figure("left", {.width_cm = 4, .height_cm = 4, .data = {{"curves", curves}}});
  document.figure("right", {.width_cm = 4, .height_cm = 4, .data = {{"curves", curves}}});

  std::vector<double> x, y, z;
  for (int i = 0; i < 21; ++i) {
    for (int j = 0; j < 21; ++j) {
      x.push_back(0.1 * j);
      y.push_back(0.1 * i);
      z.push_back(std::exp(-x.back() * y.back()));
    }
  }
  document.figure("map", {.width_cm = 7,
                          .height_cm = 5,
                          .data = {{"grid", FigureData({{"x", x}, {"y", y}, {"z", z}}, 21)}}});
}

// One claim of each verdict.
void register_claims(Document& document, const Sample& sample) {
  const Estimate left = share_left(600, sample.half_life);
  const Estimate life = mean_life(2000);
  document.claim("more-than-half",
                 {.route = "the share at ten minutes",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_least("share", Value(left, percent(1)),
                                                   {LimitKind::data, 0.5, "one half"}),
                               Criterion::agrees("halves", Value(1, integer()), Value(1, integer()),
                                                 {LimitKind::data, 0.0, "counts are exact"})}});
  document.claim("mean-life-is-half-life",
                 {.route = "the trapezoidal rule over λ ≥ 0",
                  .expected = Verdict::refuted,
                  .criteria = {Criterion::agrees_relatively(
                      "mean life in half-lives", Value(life, significant(4)), Value(1, exact()),
                      {LimitKind::choice, 0.01, "one part in a hundred"})}});
  std::vector<Criterion> each;
  for (const int time : {300, 600, 900}) {
    each.push_back(Criterion::at_most("share",
                                      Value(share_left(time, sample.half_life), significant(3)),
                                      {LimitKind::data, 0.6, "one digit is printed"}));
  }
  document.claim("soon-gone",
                 {.route = "three times",
                  .expected = Verdict::partly,
                  .criteria = {Criterion::in_each("share at each time", "times", each)}});
  document.claim(
      "printed-share",
      {.route = "the exponential function",
       .expected = Verdict::undecided,
       .criteria = {Criterion::at_most(
           "share after one mean life", Value(Estimate{std::exp(-1), 1e-3}, significant(3)),
           {LimitKind::choice, sample.printed, "1/e, to four digits"})}});
  document.check(
      "rule-converges",
      {Criterion::at_most("error of the rule", Value(life.abs_error, scientific(1)).as_is(),
                          {LimitKind::choice, 1e-3, "ten times what was found"})},
      "The rule converges.");
  document.check("is-positive", left.value > 0, "Something is left.");
}

}  // namespace

void register_all(Document& document, const Inputs& inputs, const Sample& sample) {
  register_values(document, sample);
  register_tables(document, sample);
  register_figures(document, sample);
  register_claims(document, sample);
  import_csv(document, "measured", inputs.source / "data/measured.csv",
             inputs.source / "data/measure.py", {.root = inputs.source, .exact = {"t (s)"}});
  import_json(document, inputs.source / "data/results.json",
              {.root = inputs.source, .prefix = "fit-"});
}
