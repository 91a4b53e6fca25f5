// Collision spectra by pair of groups: how many episodes of which energy, and where the energy goes.
import { dataTable, el, section, select } from "../dom.js";
import { number, withUnit } from "../format.js";
import { plot } from "../plot.js";
import { dashOf, nameIn } from "./power.js";

const QUANTITIES = [
  ["count", "Episodes by dissipated energy", "episodes per second", "1/s", "dissipated energy"],
  ["energy", "Dissipation by dissipated energy", "dissipation", "W", "dissipated energy"],
  ["approach_count", "Episodes by energy of approach", "episodes per second", "1/s", "energy of approach"],
  [
    "approach_energy",
    "Energy of approach by energy of approach",
    "energy per time",
    "W",
    "energy of approach",
  ],
  ["impact_count", "First touches by impact energy", "touches per second", "1/s", "impact energy"],
  ["impact_energy", "Impact energy by impact energy", "energy per time", "W", "impact energy"],
];

const listedKinds = (run) =>
  run.lines("spectra/kind").length > 0 ? run.lines("spectra/kind") : run.lines("power_by_kind/kind");

export function kindsOf(run) {
  const listed = listedKinds(run).filter((kind) => run.has(`spectra/${kind}/count`));
  if (listed.length > 0) return listed;
  return run.below("spectra").filter((kind) => run.has(`spectra/${kind}/count`));
}

const timeOf = (run) => run.values("spectra/recorded_time")[0] || NaN;

// Bins with both edges: without what is below the first or above the last.
function line(run, kind, quantity) {
  const edges = run.values("spectra/energy_from"),
    values = run.values(`spectra/${kind}/${quantity}`);
  const x = [],
    y = [];
  for (let k = 1; k + 1 < edges.length; k += 1) {
    if (!(values[k] > 0)) continue;
    x.push(Math.sqrt(edges[k] * edges[k + 1]));
    y.push(values[k] / timeOf(run));
  }
  return { x, y };
}

function allKinds(run, quantity) {
  const edges = run.values("spectra/energy_from");
  const sums = edges.map((_, k) =>
    kindsOf(run).reduce((sum, kind) => sum + (run.values(`spectra/${kind}/${quantity}`)[k] ?? 0), 0),
  );
  const x = [],
    y = [];
  for (let k = 1; k + 1 < edges.length; k += 1) {
    if (!(sums[k] > 0)) continue;
    x.push(Math.sqrt(edges[k] * edges[k + 1]));
    y.push(sums[k] / timeOf(run));
  }
  return { x, y };
}

function spectrum(runs, quantity) {
  const [name, title, label, unit, energy] = QUANTITIES.find(([q]) => q === quantity);
  const series = runs
    .flatMap((run) => [
      ...kindsOf(run).map((kind, k) => ({
        label: nameIn(runs, run, kind),
        colour: k,
        dash: dashOf(run),
        ...line(run, kind, name),
      })),
      { label: nameIn(runs, run, "all"), colour: 6, dash: dashOf(run), ...allKinds(run, name) },
    ])
    .filter((s) => s.x.length > 0);
  return {
    title,
    x: { label: energy, unit: "J", log: true },
    y: { label: `${label} in a bin`, unit, log: true },
    series,
    note: "Ten bins a decade, each shown at its middle; what lies below 10⁻¹² J or above 10³ J is in the table only. Click a name to hide a line.",
  };
}

const sum = (list) => list.reduce((a, b) => a + (b ?? 0), 0);

// Energy that half of all episodes stay below.
function middle(run, kind, quantity) {
  const edges = run.values("spectra/energy_from"),
    weights = run.values(`spectra/${kind}/${quantity}`);
  const half = 0.5 * sum(weights);
  let so = 0;
  for (let k = 0; k < weights.length; k += 1) {
    so += weights[k];
    if (so >= half && half > 0) return k + 1 < edges.length ? edges[k + 1] : edges[k];
  }
  return NaN;
}

function table(runs) {
  const rows = runs.flatMap((run) =>
    kindsOf(run).map((kind) => {
      const at = listedKinds(run).indexOf(kind);
      const counts = run.values(`spectra/${kind}/count`),
        energies = run.values(`spectra/${kind}/energy`),
        t = timeOf(run);
      return [
        nameIn(runs, run, kind),
        withUnit(sum(counts) / t, "Hz"),
        withUnit(sum(energies) / t, "W"),
        withUnit(middle(run, kind, "count"), "J", 2),
        withUnit(middle(run, kind, "energy"), "J", 2),
        number((counts[0] ?? 0) / t),
        number(counts.at(-1) / t),
        at < 0
          ? "–"
          : `${number(run.values("spectra/open_count")[at])} (${withUnit(run.values("spectra/open_energy")[at], "J")})`,
      ];
    }),
  );
  return dataTable(
    "Episodes",
    [
      "kind",
      "episodes",
      "dissipation",
      "half of the episodes below",
      "half of the dissipation below",
      "below 10⁻¹² J, 1/s",
      "above 10³ J, 1/s",
      "open at the end",
    ],
    rows,
  );
}

function checks(runs) {
  return runs
    .filter((run) => Number.isFinite(run.summary.spectra_sum_error))
    .map((run) =>
      el(
        "p",
        { class: "note" },
        nameIn(
          runs,
          run,
          `Bins and open episodes together miss the dissipation of the energy account by ${number(run.summary.spectra_sum_error, 2)} of it.`,
        ),
      ),
    );
}

export function spectra(page) {
  const runs = page.runs.filter((run) => run.has("spectra/energy_from") && kindsOf(run).length > 0);
  if (runs.length === 0) return null;
  const left = ["count", "energy"].map((quantity) => plot(spectrum(runs, quantity)));
  let other = "impact_count";
  const more = QUANTITIES.slice(2).filter(([q]) =>
    runs.some((run) => kindsOf(run).some((kind) => sum(run.values(`spectra/${kind}/${q}`)) > 0)),
  );
  if (more.length > 0) other = more[0][0];
  const third = more.length > 0 ? plot(() => spectrum(runs, other)) : null;
  return section(
    "spectra",
    "Collision spectra",
    el("div", { class: "pair" }, left),
    table(runs),
    checks(runs),
    third
      ? select(
          "Also",
          more.map(([q, title]) => [q, title]),
          (value) => {
            other = value;
            third.change();
          },
        )
      : null,
    third,
  );
}
