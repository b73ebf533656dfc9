// Sorting, filtering and looking at pictures. The page is complete without it.
"use strict";

// The value a cell sorts and filters by: the exact one where a shortened one is shown.
const valueOf = cell => (cell.title || cell.textContent).trim();

const numberOf = text => {
  if (text === "") return null;
  if (text === "inf") return Infinity;
  if (text === "-inf") return -Infinity;
  const value = Number(text.replace(/,(?=\d{3}\b)/g, ""));
  return Number.isNaN(value) ? null : value;
};

const words = new Intl.Collator("en", { numeric: true });

// Numbers before words; empty cells last, whichever way the column is sorted.
function compare(a, b, sign) {
  if (a.text === "" || b.text === "") return (a.text === "") - (b.text === "");
  if (a.number !== null && b.number !== null) return sign * (a.number < b.number ? -1 : a.number > b.number ? 1 : 0);
  if (a.number !== null || b.number !== null) return a.number !== null ? -1 : 1;
  return sign * words.compare(a.text, b.text);
}

function sortBy(table, column, header) {
  const sign = header.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  const body = table.tBodies[0];
  const keyed = Array.from(body.rows, row => {
    const text = row.cells[column] ? valueOf(row.cells[column]) : "";
    return { row, text, number: numberOf(text) };
  });
  keyed.sort((a, b) => compare(a, b, sign));
  body.append(...keyed.map(k => k.row));
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  header.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
}

for (const table of document.querySelectorAll("table")) {
  Array.from(table.tHead.rows[0].cells).forEach((header, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = header.textContent;
    header.replaceChildren(button);
    button.addEventListener("click", () => sortBy(table, column, header));
  });
}

const all = document.querySelector(".all table");
const form = document.querySelector(".filter");

// The terms of a filter: words, or a column, an operator and a value that may be quoted.
function termsOf(text, names) {
  const terms = [];
  for (const [whole, name, operator, value] of text.matchAll(/([\w#]+)(<=|>=|!=|=|<|>)("(?:[^"]|"")*"?|\S*)|\S+/g)) {
    const column = name === undefined ? -1 : names.indexOf(name);
    const bare = (value ?? "").startsWith('"') ? value.slice(1).replace(/"$/, "").replaceAll('""', '"') : value;
    if (column < 0) terms.push(row => row.textContent.toLowerCase().includes(whole.toLowerCase()));
    else terms.push(row => holds(valueOf(row.cells[column]), operator, bare));
  }
  return terms;
}

function holds(text, operator, value) {
  const [a, b] = [numberOf(text), numberOf(value)];
  const numbers = a !== null && b !== null;
  switch (operator) {
    case "=": return numbers ? a === b : text === value;
    case "!=": return numbers ? a !== b : text !== value;
    case "<": return numbers && a < b;
    case ">": return numbers && a > b;
    case "<=": return numbers && a <= b;
    default: return numbers && a >= b;
  }
}

function filterRows() {
  const names = Array.from(all.tHead.rows[0].cells, cell => cell.textContent);
  const terms = termsOf(form.querySelector("input").value, names);
  const rows = all.tBodies[0].rows;
  let shown = 0;
  for (const row of rows) {
    row.hidden = !terms.every(term => term(row));
    if (!row.hidden) shown += 1;
  }
  form.querySelector("output").value = `${shown} of ${rows.length} rows`;
}

if (form && all) {
  form.hidden = false;
  form.addEventListener("submit", event => event.preventDefault());
  let waiting = 0;
  form.querySelector("input").addEventListener("input", () => {
    clearTimeout(waiting);
    waiting = setTimeout(filterRows, 120);
  });
  filterRows();
  for (const link of document.querySelectorAll("[data-filter]")) {
    link.addEventListener("click", () => {
      form.querySelector("input").value = link.dataset.filter;
      filterRows();
    });
  }
  // A link to a row must find it even when the filter hides it.
  window.addEventListener("hashchange", () => {
    const row = /^#r\d+$/.test(location.hash) && document.getElementById(location.hash.slice(1));
    if (row && row.hidden) {
      form.querySelector("input").value = "";
      filterRows();
      row.scrollIntoView({ block: "center" });
    }
  });
}

// A picture over the page, with the next and the previous row's in the order shown.
function viewer() {
  const dialog = document.createElement("dialog");
  dialog.setAttribute("aria-label", "Picture");
  dialog.innerHTML = '<div class="bar"><button type="button">Previous</button><button type="button">Next</button>' +
    '<a target="_blank">Open the file</a><button type="button">Close</button></div><div class="frame"><img></div>';
  const [previous, next, close] = dialog.querySelectorAll("button");
  const image = dialog.querySelector("img");
  let at = null;
  const show = link => {
    at = link;
    image.src = dialog.querySelector("a").href = link.getAttribute("href");
    image.alt = `Row ${link.textContent}: ` + Array.from(link.closest("tr").cells).slice(1, 6).map(c => c.textContent).join(", ");
  };
  const step = by => {
    const links = Array.from(all.querySelectorAll("tbody tr:not([hidden]) a.drawn"));
    const link = links[links.indexOf(at) + by];
    if (link) show(link);
  };
  previous.addEventListener("click", () => step(-1));
  next.addEventListener("click", () => step(1));
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("keydown", event => {
    if (event.key === "ArrowLeft") step(-1);
    if (event.key === "ArrowRight") step(1);
  });
  document.body.append(dialog);
  return link => {
    show(link);
    dialog.showModal();
  };
}

if (all && all.querySelector("a.drawn")) {
  const open = viewer();
  all.addEventListener("click", event => {
    const link = event.target.closest("a.drawn");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    open(link);
  });
}
