// Shows an SVG file in the page and compares its drawn paths with control points of ours, in the units of its svg element.
// text: the file; ours: for each path its subpaths, for each subpath its segments, for each segment its four control points.
// Returns for each path: ours' distance from Chromium's in units of the path's size, the difference of the two lengths,
// and whether a transform touches it.
((text, ours) => {
    const NEVER = "defs, symbol, clipPath, mask, marker, pattern, linearGradient, radialGradient, filter, metadata";
    const root = document.importNode(new DOMParser().parseFromString(text, "image/svg+xml").documentElement, true);
    document.body.replaceChildren(root);
    const drawn = [...root.querySelectorAll("path")].filter(
        path => !path.closest(NEVER) && path.checkVisibility({visibilityProperty: true}));
    if (drawn.length !== ours.length) return {paths: drawn.length};

    const at = ([a, b, c, d], t) => [0, 1].map(
        i => (1 - t) ** 3 * a[i] + 3 * (1 - t) ** 2 * t * b[i] + 3 * (1 - t) * t * t * c[i] + t ** 3 * d[i]);
    const far = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
    const toChord = (p, a, b) => {
        const along = [b[0] - a[0], b[1] - a[1]];
        const square = along[0] ** 2 + along[1] ** 2;
        const t = square > 0 ? ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / square : 0;
        const s = Math.min(1, Math.max(0, t));
        return far(p, [a[0] + s * along[0], a[1] + s * along[1]]);
    };
    const STEPS = 24;

    // A box around each segment's control points; a point is at least that far from the curve.
    const boxOf = points => [0, 1].map(i => [Math.min(...points.map(p => p[i])), Math.max(...points.map(p => p[i]))]);
    const toBox = (p, box) => Math.hypot(...box.map(([low, high], i) => Math.max(low - p[i], 0, p[i] - high)));

    // Distance of a point from a curve: the nearest chord, and then the curve above it and its neighbours.
    const toCurve = (p, segments, chords, boxes) => {
        let best = Infinity, where = null;
        segments.forEach((segment, j) => {
            if (toBox(p, boxes[j]) >= best) return;
            for (let i = 0; i < STEPS; ++i) {
                const distance = toChord(p, chords[j][i], chords[j][i + 1]);
                if (distance < best) { best = distance; where = [segment, i]; }
            }
        });
        let low = Math.max(0, (where[1] - 1) / STEPS), high = Math.min(1, (where[1] + 2) / STEPS);
        for (let i = 0; i < 40; ++i) {
            const left = low + (high - low) / 3, right = high - (high - low) / 3;
            if (far(p, at(where[0], left)) < far(p, at(where[0], right))) high = right; else low = left;
        }
        return far(p, at(where[0], (low + high) / 2));
    };

    const toRoot = root.getScreenCTM().inverse();
    return {paths: drawn.length, compared: drawn.map((path, number) => {
        const matrix = toRoot.multiply(path.getScreenCTM());
        const length = path.getTotalLength();
        const segments = ours[number].flat();
        if (segments.length === 0 || length === 0)
            return {distance: segments.length === 0 && length === 0 ? 0 : Infinity, moved: false};
        const chords = segments.map(s => Array.from({length: STEPS + 1}, (_, i) => at(s, i / STEPS)));
        const boxes = segments.map(boxOf);
        const all = chords.flat();
        const extent = i => all.reduce(([low, high], p) => [Math.min(low, p[i]), Math.max(high, p[i])], [Infinity, -Infinity]);
        const size = Math.hypot(...[0, 1].map(i => extent(i)[1] - extent(i)[0]));
        const count = Math.min(4000, Math.max(64, 6 * segments.length));
        const points = Array.from({length: count + 1}, (_, i) => {
            const p = path.getPointAtLength(length * i / count).matrixTransform(matrix);
            return [p.x, p.y];
        });
        const theirs = Math.max(...points.map(p => toCurve(p, segments, chords, boxes)));
        // The other way round, so that nothing of ours is missing there: every joint of ours lies near a point of theirs.
        const scale = Math.sqrt(Math.abs(matrix.a * matrix.d - matrix.b * matrix.c));
        const spacing = length * Math.hypot(matrix.a, matrix.b, matrix.c, matrix.d) / count;
        const back = Math.max(...segments.map(s => Math.min(...points.map(p => far(p, s[3]))))) - spacing;
        const turnsOnly = Math.abs(matrix.a - matrix.d) + Math.abs(matrix.b + matrix.c) < 1e-9 * scale ||
                          Math.abs(matrix.a + matrix.d) + Math.abs(matrix.b - matrix.c) < 1e-9 * scale;
        const ourLength = chords.reduce((sum, c) => sum + c.slice(1).reduce((s, p, i) => s + far(c[i], p), 0), 0);
        return {
            distance: Math.max(theirs, back) / size,
            length: turnsOnly ? Math.abs(ourLength / (length * scale) - 1) : 0,
            moved: matrix.a !== 1 || matrix.b !== 0 || matrix.c !== 0 || matrix.d !== 1 || matrix.e !== 0 || matrix.f !== 0,
        };
    })};
})
