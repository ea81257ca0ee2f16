// SPDX-License-Identifier: MIT
// The table of combinations: sorted by a click on a head, each row with details that unfold.
import { columns, type Column } from "./columns";
import { details } from "./details";
import { breakable, element } from "./element";
import { type Combination, type Figures, ran } from "./figures";
import { exactly, nothing } from "./format";
import { mark_of } from "./identity";

type Direction = "ascending" | "descending";

interface Entry {
  combination: Combination;
  place: number;
  rows: HTMLTableRowElement[];
}

function cell(column: Column, combination: Combination & { error: null }): HTMLTableCellElement {
  const value = column.value(combination);
  const text = column.text(value, combination);
  const title = column.title?.(combination) ?? (value === null ? "not measured" : exactly(value));
  const shown = column.kind === "number" && value !== null ? element("data", { value: exactly(value) }, text) : text;
  const kind = column.kind + (text.endsWith("BROKEN") ? " broken" : "");
  return element("td", { "data-column": column.id, class: kind, title }, shown);
}

function name_cell(combination: Combination, place: number, toggle: HTMLElement | null): HTMLElement {
  return element(
    "th",
    { scope: "row", "data-column": "name" },
    toggle,
    ran(combination) ? mark_of(place) : null,
    " ",
    ...breakable(combination.name),
  );
}

function failed_rows(combination: Combination, place: number): HTMLTableRowElement[] {
  const { text, status } = combination.error!;
  const said = element(
    "td",
    { class: "failed", colspan: String(columns.length) },
    element("span", {}, `did not run (status ${status}): ${text}`),
  );
  return [element("tr", { "data-combination": String(place) }, name_cell(combination, place, null), said)];
}

function rows_of(combination: Combination, place: number, source_names: string[]): HTMLTableRowElement[] {
  if (!ran(combination)) return failed_rows(combination, place);
  const id = `details-${place}`;
  const toggle = element("button", {
    type: "button",
    class: "toggle",
    "aria-expanded": "false",
    "aria-controls": id,
    "aria-label": `Details of ${combination.name}`,
  });
  const more = element("tr", { id, class: "more", hidden: "" });
  toggle.addEventListener("click", () => {
    if (!more.hasChildNodes())
      more.append(element("td", { colspan: String(columns.length + 1) }, details(combination, source_names)));
    more.hidden = !more.hidden;
    toggle.setAttribute("aria-expanded", String(!more.hidden));
  });
  const cells = columns.map((column) => cell(column, combination));
  return [element("tr", { "data-combination": String(place) }, name_cell(combination, place, toggle), ...cells), more];
}

/** Failed combinations and missing values come last in both directions; equal ones in the order of the data. */
function sorted(entries: Entry[], column: Column | null, direction: Direction): Entry[] {
  const sign = direction === "ascending" ? 1 : -1;
  const key = ({ combination }: Entry) => (column && ran(combination) ? column.value(combination) : null);
  return [...entries].sort((a, b) => {
    if (ran(a.combination) !== ran(b.combination)) return ran(a.combination) ? -1 : 1;
    if (!column) return sign * a.combination.name.localeCompare(b.combination.name) || a.place - b.place;
    const [x, y] = [key(a), key(b)];
    if (x === null || y === null) return Number(x === null) - Number(y === null) || a.place - b.place;
    return sign * (x < y ? -1 : x > y ? 1 : 0) || a.place - b.place;
  });
}

function group_row(): HTMLTableRowElement {
  const groups: { name: string; width: number }[] = [];
  for (const { group } of columns) {
    const last = groups.at(-1);
    if (last?.name === group) ++last.width;
    else groups.push({ name: group, width: 1 });
  }
  const heads = groups.map(({ name, width }) => element("th", { scope: "colgroup", colspan: String(width) }, name));
  return element("tr", { class: "groups" }, element("td"), ...heads);
}

/** The head of a column: a button; `sort` is told in which direction. */
function sort_head(
  id: string,
  kind: string,
  group: string,
  label: string,
  sort: (head: HTMLElement, direction: Direction) => void,
): HTMLElement {
  const button = element("button", { type: "button", "aria-label": group ? `${group}: ${label}` : null }, label);
  const head = element("th", { scope: "col", class: kind, "data-column": id }, button);
  button.addEventListener("click", () =>
    sort(head, head.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending"),
  );
  return head;
}

export function table({ combinations, sources }: Figures): HTMLElement {
  const source_names = sources.map(({ entry, row }) => (row === null ? entry : `row ${row}`));
  const entries = combinations.map((combination, place): Entry => ({
    combination,
    place,
    rows: rows_of(combination, place, source_names),
  }));
  const body = element("tbody", {}, ...entries.flatMap(({ rows }) => rows));
  const heads = element("tr");
  const sort_by = (column: Column | null) => (head: HTMLElement, direction: Direction) => {
    for (const other of heads.children) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", direction);
    body.append(...sorted(entries, column, direction).flatMap(({ rows }) => rows));
  };
  heads.append(sort_head("name", "words", "", "combination", sort_by(null)));
  heads.append(
    ...columns.map((column) => sort_head(column.id, column.kind, column.group, column.label, sort_by(column))),
  );
  const caption =
    `A click on a head sorts, ${nothing} is not measured. Source: median of a source. ` +
    "Over, under: the largest D/T − 1 of both signs. Errors compare targets that both reach.";
  return element(
    "div",
    { class: "scroll", tabindex: "0", role: "region", "aria-label": "Table of combinations" },
    element(
      "table",
      { class: "combinations" },
      element("caption", {}, caption),
      element("thead", {}, group_row(), heads),
      body,
    ),
  );
}
