// SPDX-License-Identifier: MIT
// Elements of the page. Text goes in as text and never as markup, so that names of files and plugins stay inert.

type Child = Node | string | null;

/** An element with attributes (null: left out) and children (null: left out). */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | null> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== null) made.setAttribute(name, value);
  made.append(...children.filter((child): child is Node | string => child !== null));
  return made;
}

/** A name that may be broken between its words. */
export const breakable = (name: string): Child[] => name.split(/(?<=[,:_=])/).flatMap((part) => [part, element("wbr")]);

export interface Choice<T> {
  label: string;
  value: T;
}

/** A labelled menu; `changed` is told the new value. */
export class Menu<T> {
  readonly node: HTMLLabelElement;
  private readonly select_ = element("select");
  private choices_: Choice<T>[] = [];

  constructor(label: string, name: string, choices: Choice<T>[], changed: () => void) {
    this.select_.name = name;
    this.node = element("label", {}, label, " ", this.select_);
    this.select_.addEventListener("change", changed);
    this.offer(choices);
  }

  /** New choices; the place of the chosen one is kept where there is one. */
  offer(choices: Choice<T>[]): void {
    const place = Math.min(Math.max(this.select_.selectedIndex, 0), choices.length - 1);
    this.choices_ = choices;
    this.select_.replaceChildren(...choices.map(({ label }, i) => element("option", { value: String(i) }, label)));
    this.select_.selectedIndex = place;
    this.select_.disabled = choices.length < 2;
  }

  choose(place: number): void {
    this.select_.selectedIndex = place;
  }

  /** The chosen value. Precondition: there is a choice. */
  get value(): T {
    return this.choices_[this.select_.selectedIndex]!.value;
  }
}

/** A section of the page under a heading. */
export function section(id: string, heading: string, ...children: Child[]): HTMLElement {
  return element(
    "section",
    { id, "aria-labelledby": `${id}-heading` },
    element("h2", { id: `${id}-heading` }, heading),
    ...children,
  );
}
