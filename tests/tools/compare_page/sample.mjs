// SPDX-License-Identifier: MIT
// Made-up data of a comparison, by the schema of the page: a torus and a small sphere apart from it, as one mesh,
// with combinations of every kind: exact, within a factor, estimates, a broken promise, one that did not run, one
// with a hostile name.
//
//   sample({ rings, sides, growth, hostile }) gives the data; page_of(template, data) the page as the engine writes it.

const around = 2 * Math.PI;
const [major, minor] = [1, 0.4];

const base64 = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");

/** Repeatable numbers in [0, 1). */
function random_numbers(seed) {
  let state = seed;
  return () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
}

function torus_point(u, v) {
  const reach = major + minor * Math.cos(v);
  return [reach * Math.cos(u), reach * Math.sin(u), minor * Math.sin(v)];
}

/** Faces of a grid that is closed in the first direction, and in the second too if `closed`. */
function grid_faces(first, rings, sides, closed) {
  const at = (i, j) => first + (i % rings) * sides + (j % sides);
  const faces = [];
  for (let i = 0; i < rings; ++i)
    for (let j = 0; j < (closed ? sides : sides - 1); ++j)
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
  return faces;
}

function surface_of(rings, sides) {
  const torus = [];
  for (let i = 0; i < rings; ++i)
    for (let j = 0; j < sides; ++j) torus.push({ u: (around * i) / rings, v: (around * j) / sides });
  const [belts, steps] = [12, 9];
  const sphere = [];
  for (let i = 0; i < belts; ++i)
    for (let j = 0; j < steps; ++j) {
      const [a, b] = [(around * i) / belts, Math.PI * ((j + 0.5) / steps - 0.5)];
      sphere.push([1.7 + 0.2 * Math.cos(a) * Math.cos(b), 0.2 * Math.sin(a) * Math.cos(b), 0.2 * Math.sin(b)]);
    }
  const positions = [...torus.map(({ u, v }) => torus_point(u, v)), ...sphere];
  const faces = [...grid_faces(0, rings, sides, true), ...grid_faces(torus.length, belts, steps, false)];
  return { torus, positions, faces };
}

const turn = (angle) => Math.abs(((angle + 3 * Math.PI) % around) - Math.PI);

/** Not the distance on a torus, but smooth and periodic like one. */
const distance = (a, b) => Math.hypot(major * turn(a.u - b.u), minor * turn(a.v - b.v));

/** A path in the plane of (u, v), on the torus. */
function path_points(a, b) {
  const shortest = (from, to) => ((to - from + 3 * Math.PI) % around) - Math.PI;
  const [du, dv] = [shortest(a.u, b.u), shortest(a.v, b.v)];
  return Array.from({ length: 41 }, (_, k) => torus_point(a.u + (du * k) / 40, a.v + (dv * k) / 40));
}

const length_of = (points) =>
  points.slice(1).reduce((sum, p, i) => sum + Math.hypot(...p.map((x, axis) => x - points[i][axis])), 0);

function paths_of(surface, from) {
  const n = surface.torus.length;
  return [Math.floor(n / 2), Math.floor(n / 3)].map((target) => {
    const points = path_points(surface.torus[from], surface.torus[target]);
    const length = length_of(points);
    return { target, distance: length * (1 + 2e-16), length, points: base64(Float32Array.from(points.flat())) };
  });
}

/** Half-decades from 1e-17 to 1e1. */
const decades = Array.from({ length: 37 }, (_, i) => -17 + i / 2);

function histogram_of(errors) {
  const counts = decades.slice(1).map(() => 0);
  let zero = 0;
  for (const e of errors) {
    if (e === 0) ++zero;
    else ++counts[Math.min(Math.max(Math.floor((Math.log10(e) + 17) * 2), 0), counts.length - 1)];
  }
  return { decades, counts, zero };
}

function errors_summary(signed, truths) {
  const pairs = signed
    .map((e, i) => ({ size: Math.abs(e), truth: truths[i] }))
    .filter(({ size, truth }) => Number.isFinite(size) && truth > 0);
  const sizes = pairs.map(({ size }) => size).sort((a, b) => a - b);
  const mean = (list) => (list.length ? list.reduce((s, x) => s + x, 0) / list.length : null);
  const longest = Math.max(...pairs.map(({ truth }) => truth));
  const some = (keep) => {
    const list = pairs.filter(keep).map(({ size }) => size);
    return { compared: list.length, mean: mean(list), max: list.length ? Math.max(...list) : null };
  };
  const finite = signed.filter(Number.isFinite);
  const quantile = (q) => sizes[Math.ceil(q * sizes.length) - 1];
  return {
    compared: sizes.length,
    max_over: Math.max(...finite, 0),
    max_under: Math.max(...finite.map((e) => -e), 0),
    mean: mean(sizes),
    quantiles: Object.fromEntries(["0.5", "0.9", "0.99", "1"].map((q) => [q, quantile(Number(q))])),
    near: some(({ truth }) => truth < 0.05 * longest),
    far: some(({ truth }) => truth >= 0.25 * longest),
    histogram: histogram_of(sizes),
  };
}

const kinds = [
  {
    name: "delaunay_cut, chen_han",
    factor: 1,
    never_shorter: true,
    error: () => 0,
    seconds: 0.00729,
    held: true,
    paths: true,
    exponent: 1.5,
    counters: { windows: 52341, propagated_faces: 9177 },
  },
  {
    name: "delaunay_cut, cgal",
    factor: 1,
    never_shorter: true,
    error: (r) => (r() < 0.6 ? 0 : (r() - 0.5) * 3e-15),
    seconds: 0.2085,
    held: true,
    paths: true,
    exponent: 1.7,
    counters: { windows: 81002 },
  },
  {
    name: "delaunay_cut, aleksandrov:delta=0.1",
    factor: 1.1,
    never_shorter: true,
    error: (r, d) => (0.002 + 0.02 * r()) / (1 + 3 * d),
    seconds: 0.0481,
    held: true,
    paths: true,
    exponent: 1.1,
    counters: { nodes: 220120.5 },
  },
  {
    name: "delaunay_cut, edge_dijkstra",
    factor: null,
    never_shorter: true,
    error: (r, d, p) => 0.12 * Math.abs(Math.sin(3 * p.u) * Math.cos(2 * p.v)),
    seconds: 0.000244,
    held: null,
    paths: true,
    exponent: 1.02,
    counters: {},
  },
  {
    name: "advancing_front, heat",
    factor: null,
    never_shorter: false,
    error: (r, d, p) => 0.03 * Math.sin(2 * p.u + p.v) + 0.3 * Math.exp(-20 * d),
    seconds: 0.0019,
    held: null,
    paths: false,
    exponent: 1.15,
    counters: {},
  },
  {
    name: "advancing_front, boastful",
    factor: 1.01,
    never_shorter: true,
    error: (r, d, p) => -0.04 * Math.cos(p.u) ** 2,
    seconds: 0.013,
    held: false,
    paths: false,
    exponent: 1.3,
    counters: { pops: 1234567 },
  },
];

const hostile_name = `</script><img src=x onerror="window.hacked=1"><b>bold</b>`;

function growth_of(kind, surface, memory) {
  return [4, 2, 1].map((part) => {
    const faces = Math.round(surface.faces.length / part);
    return {
      rows: Math.round(surface.positions.length / part),
      vertices: Math.round(surface.positions.length / part),
      faces,
      prepare: (0.002 * kind.exponent) / part,
      per_source: kind.seconds * part ** -kind.exponent,
      peak_bytes: memory === null ? null : Math.round(memory / part),
      counters: Object.fromEntries(Object.entries(kind.counters).map(([name, n]) => [name, n * part ** -1.5])),
    };
  });
}

function invariants_of(kind) {
  const promised = kind.never_shorter;
  return [
    { name: "D >= Euclid", holds: kind.held !== false, worst: kind.held === false ? -0.04 : 0, promised },
    { name: "D(s,s) = 0", holds: true, worst: 0, promised: true },
    {
      name: "symmetry",
      holds: kind.factor === 1 ? true : kind.never_shorter ? null : false,
      worst: kind.never_shorter ? null : 0.021,
      promised: kind.factor === 1,
    },
    { name: "triangle inequality", holds: true, worst: 1e-16, promised: true },
  ];
}

/**
 * The distances and errors of one source at all vertices; not reached beyond the torus, not computed at the last few
 * of it.
 */
function search(kind, surface, from, random) {
  const { torus, positions } = surface;
  const truths = positions.map((_, i) => (i < torus.length ? distance(torus[from], torus[i]) : Infinity));
  const errors = truths.map((t, i) => (i < torus.length && t > 0 ? kind.error(random, t, torus[i]) : NaN));
  const distances = truths.map((t, i) => (t === 0 || t === Infinity ? t : t * (1 + errors[i])));
  if (!kind.never_shorter) for (let i = torus.length - 40; i < torus.length; ++i) distances[i] = errors[i] = NaN;
  return { truths, errors, distances };
}

function result_of(kind, surface, from, growth) {
  const random = random_numbers(7);
  const searches = from.map((source) => search(kind, surface, source, random));
  const memory = kind.name.includes("cgal") ? null : Math.round(kind.seconds * 3e8 + 1e6);
  const result = {
    name: kind.name,
    stages: {
      tangent: "jet",
      control: "lipschitz",
      decimator: "greedy",
      reconstructor: kind.name.split(",")[0],
      solver: kind.name.split(", ")[1] ?? "hostile",
    },
    error: null,
    factor: kind.factor,
    never_shorter: kind.never_shorter,
    surface: { vertices: surface.positions.length, faces: surface.faces.length },
    seconds: {
      stages: { tangent: 0.0312, control: 0.1204, decimator: 0.0021, reconstructor: 0.2503 },
      prepare: 0.00197,
      per_source: kind.seconds,
      sources: from.map((_, i) => kind.seconds * (0.9 + 0.1 * i)),
    },
    memory: { peak_bytes: memory, prepared_bytes: 481234 },
    errors: errors_summary(
      searches.flatMap((s) => s.errors),
      searches.flatMap((s) => s.truths),
    ),
    reach_differs: kind.never_shorter ? 0 : 2,
    unreachable: from.length * (surface.positions.length - surface.torus.length),
    invariants: invariants_of(kind),
    ...(kind.factor > 1 && { certified: { largest: kind.factor - 1, mean: (kind.factor - 1) / 2, worst: 0 } }),
    guarantee: {
      stated: kind.factor,
      worst: kind.factor === null ? null : 1.0003,
      held: kind.held,
      why:
        kind.held === null
          ? "the solver states no factor"
          : kind.held
            ? "no distance above the factor"
            : "row 17 is shorter than the truth",
    },
    counters: kind.counters,
    growth: growth ? growth_of(kind, surface, memory) : [],
  };
  const view = searches.map(({ distances, errors }, i) => ({
    distances: base64(Float32Array.from(distances)),
    errors: base64(Float32Array.from(errors)),
    paths: kind.paths ? paths_of(surface, from[i]) : [],
  }));
  return { result, view };
}

/**
 * The data of a page. `hostile`: strings that would do harm as markup, everywhere. `growth`: figures of several
 * sizes.
 */
export function sample({ rings = 48, sides = 24, growth = true, hostile = false } = {}) {
  const surface = surface_of(rings, sides);
  const n = surface.torus.length;
  const from = [0, Math.floor(n / 2) + 5];
  const shown = hostile ? [...kinds, { ...kinds[3], name: hostile_name }] : kinds;
  const results = shown.map((kind) => result_of(kind, surface, from, growth));
  const failure = {
    name: hostile ? `failed ${hostile_name}` : "stars, chen_han",
    stages: { reconstructor: "stars", solver: "chen_han" },
    error: { text: `the stars of 17 points do not agree; use delaunay_cut${hostile ? hostile_name : ""}`, status: 4 },
  };
  return {
    schema: "geodrome-comparison/1",
    version: "0.1.0",
    input: {
      file: hostile ? `${hostile_name}.ply` : "torus.ply",
      kind: "mesh",
      rows: surface.positions.length,
      faces: surface.faces.length,
      diagonal: 4.031,
    },
    sources: from.map((row, i) => ({
      entry: String(row),
      row: i === 0 ? row : null,
      position: surface.positions[row],
    })),
    targets: surface.positions.length,
    truth: {
      kind: "exact",
      name: "chen_han",
      text: hostile ? `truth ${hostile_name}` : "Exact distances of chen_han on the surface of each combination.",
    },
    near: 0.05,
    far: 0.25,
    combinations: [...results.map(({ result }) => result), failure],
    view: {
      surfaces: [
        {
          positions: base64(Float32Array.from(surface.positions.flat())),
          triangles: base64(Uint32Array.from(surface.faces.flat())),
        },
      ],
      combinations: [...results.map(({ view }) => ({ surface: 0, sources: view })), null],
    },
  };
}

/** The page with its data, as the engine writes it. */
export function page_of(template, data) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  const script = `<script type="application/json" id="geodrome-comparison">${json}</script>`;
  return template.replace("<!--geodrome-comparison-->", () => script);
}
