// How the run went: accuracy, energy account, speed, warnings, where it was made.
import { dataTable, el, section } from "../dom.js";
import { count, duration, number, plain, withError } from "../format.js";
import { plot } from "../plot.js";
import { stateOf } from "./headline.js";
import { dashOf, nameIn } from "./power.js";

const WARNINGS = {
  overlap_warnings: "contacts deeper than half the smaller radius",
  contained_warnings: "contacts of a body within another",
  bounded_warnings: "contacts cut short by a limit of the narrow phase",
  wall_depth_warnings: "contacts deeper in a wall than it is taken to be thick",
};

function warningsOf(run) {
  const found = Object.entries(WARNINGS)
    .filter(([name]) => run.summary[name] > 0)
    .map(([name, text]) => `${count(run.summary[name])} ${text} (summed over steps)`);
  return found.length > 0 ? found.join("; ") : run.complete ? "none" : "not told before the end";
}

const percent = (share) => (Number.isFinite(share) ? `${number(100 * share, 2)} %` : "–");

const FACTS = [
  ["State", (run) => stateOf(run)[1]],
  ["Recorded window", (run) => run.summary.steady_statement ?? "–"],
  ["Drift of the power in the window", (run) => percent(run.summary.power_drift_share)],
  ["Time step", (run) => (run.scene?.time_step ? `${plain(1e6 * run.scene.time_step)} µs` : "–")],
  ["Fewest steps per contact", (run) => number(run.summary.steps_per_contact)],
  ["Steps", (run) => count(run.summary.steps)],
  ["Error of the energy account", (run) => number(run.summary.ledger_error, 2)],
  [
    "Balance of the recorded window, share of the work",
    (run) => number(run.summary.recorded_balance_error, 2),
  ],
  ["Sum over kinds of collision against the account", (run) => number(run.summary.kinds_sum_error, 2)],
  ["Open and ended collisions against the account", (run) => number(run.summary.spectra_sum_error, 2)],
  ["Numerical loss, share of the work", (run) => percent(run.summary.numerical_loss)],
  ["Work of the contact model, share of the dissipation", (run) => percent(run.summary.model_work_share)],
  [
    "Energy in: walls, gravity",
    (run) =>
      `${withError(run.summary.wall_work_J, NaN, "J")}, ${withError(run.summary.gravity_work_J, NaN, "J")}`,
  ],
  [
    "Energy out: dissipated, stored",
    (run) =>
      `${withError(run.summary.dissipation_J, NaN, "J")}, ${withError(run.summary.stored_energy_change_J, NaN, "J")}`,
  ],
  ["Warnings", warningsOf],
  [
    "Speed",
    (run) =>
      run.summary.particle_steps_per_s
        ? `${number(run.summary.particle_steps_per_s)} particle steps per second`
        : "–",
  ],
  ["Wall clock of the last process", (run) => duration(run.summary.wall_s)],
  [
    "Peak memory",
    (run) => (run.summary.peak_memory_B ? `${number(run.summary.peak_memory_B / 1e6)} MB` : "–"),
  ],
  [
    "Machine, threads, SIMD target",
    (run) => ["machine", "threads", "simd_target"].map((k) => run.provenance[k] ?? "–").join(", "),
  ],
  ["Precision, seed", (run) => `${run.provenance.precision ?? "–"}, ${run.summary.seed ?? "–"}`],
  ["Version, commit", (run) => `quern ${run.provenance.version ?? "–"}, ${run.provenance.commit ?? "–"}`],
  ["State hash", (run) => run.summary.state_hash ?? "–"],
];

function facts(runs) {
  const rows = FACTS.map(([label, tell]) => [label, ...runs.map(tell)]).filter((row) =>
    row.slice(1).some((text) => text !== "–" && text !== "–, –"),
  );
  return dataTable(
    "How the run went",
    ["", ...runs.map((run) => (runs.length > 1 ? run.name : ""))],
    rows,
    "text quiet",
  );
}

function energyPlot(runs) {
  const names = [
    ["wall_work", "work of the walls"],
    ["gravity_work", "work of gravity"],
    ["dissipation", "dissipated"],
  ];
  return plot({
    title: "Energy account over time",
    x: { label: "time", unit: "s" },
    y: { label: "energy since the start", unit: "J" },
    series: runs.flatMap((run) =>
      names.map(([name, label], k) => ({
        label: nameIn(runs, run, label),
        colour: k,
        dash: dashOf(run),
        x: run.time,
        y: run.values(`series/${name}`),
      })),
    ),
  });
}

function errorPlot(runs) {
  return plot({
    title: "Error of the energy account",
    x: { label: "time", unit: "s" },
    y: { label: "error, share of the energy that went in", unit: "1", log: true },
    series: runs.map((run) => ({
      label: nameIn(runs, run, "error"),
      colour: run.index,
      dash: dashOf(run),
      x: run.time,
      y: run.values("series/ledger_error").map((v) => Math.abs(v)),
    })),
  });
}

function storedPlot(runs) {
  const names = [
    ["kinetic_energy", "kinetic"],
    ["rotational_energy", "of that rotation"],
  ];
  return plot({
    title: "Kinetic energy of the charge",
    x: { label: "time", unit: "s" },
    y: { label: "energy", unit: "J", zero: true },
    series: runs.flatMap((run) =>
      names.map(([name, label], k) => ({
        label: nameIn(runs, run, label),
        colour: k,
        dash: dashOf(run),
        x: run.time,
        y: run.values(`series/${name}`),
      })),
    ),
  });
}

function contactsPlot(runs) {
  return plot({
    title: "Contacts per particle",
    x: { label: "time", unit: "s" },
    y: { label: "contacts per particle", unit: "1", zero: true },
    series: runs.map((run) => ({
      label: nameIn(runs, run, "contacts"),
      colour: run.index,
      dash: dashOf(run),
      x: run.time,
      y: run.values("series/contacts_per_particle"),
    })),
  });
}

export function course(page) {
  const { runs } = page;
  const series = runs.filter((run) => run.has("series/time"));
  return section(
    "course",
    "How the run went",
    runs
      .filter((run) => run.summary.error)
      .map((run) => el("p", { class: "bad" }, nameIn(runs, run, run.summary.error))),
    facts(runs),
    series.length > 0
      ? el(
          "div",
          { class: "pair" },
          energyPlot(series),
          errorPlot(series),
          storedPlot(series),
          contactsPlot(series),
        )
      : null,
    runs.map((run) =>
      el(
        "details",
        {},
        el("summary", {}, nameIn(runs, run, "The scene, as read")),
        el("pre", { tabindex: "0" }, run.sceneText),
      ),
    ),
  );
}
