// Elements from code. Texts become text nodes and attributes, never HTML: what a scene calls itself
// cannot run.

export function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export function section(id, title, ...children) {
  return el(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    el("h2", { id: `${id}-title` }, title),
    ...children,
  );
}

// A choice of few: options are [value, text]. Calls `change` with the value.
export function select(label, options, change) {
  const box = el(
    "select",
    { onchange: () => change(box.value) },
    options.map(([value, text]) => el("option", { value }, text)),
  );
  return el("label", { class: "choice" }, `${label} `, box);
}

export function checkbox(label, checked, change) {
  const box = el("input", { type: "checkbox", onchange: () => change(box.checked) });
  box.checked = checked;
  return el("label", { class: "choice" }, box, ` ${label}`);
}

let names = 0;

export function uniqueId(stem) {
  names += 1;
  return `${stem}-${names}`;
}

// A table whose first column is names; cells are texts or elements. look: "quiet" (a heading stands
// above already), "text" (columns of words).
export function dataTable(caption, head, rows, look = "") {
  return el(
    "div",
    { class: `table ${look}`, tabindex: "0", role: "group", "aria-label": caption },
    el(
      "table",
      {},
      el("caption", {}, caption),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          head.map((text) => el("th", { scope: "col" }, text)),
        ),
      ),
      el(
        "tbody",
        {},
        rows.map((row) =>
          el(
            "tr",
            { class: row.strong ? "strong" : null },
            row.map((cell, k) => el(k === 0 ? "th" : "td", k === 0 ? { scope: "row" } : {}, cell)),
          ),
        ),
      ),
    ),
  );
}

// Hands `text` out as a file, from inside the page.
export function download(name, text) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/csv;charset=utf-8" }));
  const link = el("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
