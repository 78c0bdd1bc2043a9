/** Shapes for coarse pictures, in which most triangles are smaller than a pixel. */

import type { Mesh } from "./paint";

/** The axis that a normal is closest to, and its sign: 0 to 5. */
function sideOf(x: number, y: number, z: number): number {
    const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
    if (ax >= ay && ax >= az) return x < 0 ? 1 : 0;
    if (ay >= az) return y < 0 ? 3 : 2;
    return z < 0 ? 5 : 4;
}

/**
 * A mesh with one vertex, their mean, for all vertices in a cubic cell whose normals are closest to the same
 * axis, so that both sides of a thin part are kept apart. Triangles between three such vertices are left
 * [rossignac-borrel-1993]. Positions move by at most the diagonal of a cell.
 *
 * @param cell  the side of a cell, in the mesh's units
 * @returns the mesh itself, where it would not have half as many triangles
 */
export function coarser(mesh: Mesh, cell: number): Mesh {
    const { positions, normals, indices } = mesh;
    const count = positions.length / 3;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    positions.forEach((x, at) => {
        const axis = at % 3;
        low[axis] = Math.min(low[axis] as number, x);
        high[axis] = Math.max(high[axis] as number, x);
    });
    const cells = low.map((from, axis) => Math.floor(((high[axis] as number) - from) / cell) + 1);
    const [width = 1, height = 1, depth = 1] = cells;
    // Of so many cells none has two vertices, and numbers could not tell them apart.
    if (6 * width * height * depth > Number.MAX_SAFE_INTEGER) return mesh;

    const clusterOf = new Uint32Array(count);
    const clusters = new Map<number, number>();
    const sizes: number[] = [];
    const sums: number[] = []; // of positions and normals
    for (let vertex = 0; vertex < count; ++vertex) {
        const at = (axis: number): number => positions[3 * vertex + axis] as number;
        const normal = (axis: number): number => normals[3 * vertex + axis] as number;
        const cellAt = (axis: number): number =>
            Math.floor((at(axis) - (low[axis] as number)) / cell);
        const side = sideOf(normal(0), normal(1), normal(2));
        const key = side + 6 * (cellAt(0) + width * (cellAt(1) + height * cellAt(2)));
        let cluster = clusters.get(key);
        if (cluster === undefined) {
            cluster = sizes.length;
            clusters.set(key, cluster);
            sizes.push(0);
            sums.push(0, 0, 0, 0, 0, 0);
        }
        clusterOf[vertex] = cluster;
        sizes[cluster] = (sizes[cluster] as number) + 1;
        for (let axis = 0; axis < 3; ++axis) {
            const to = 6 * cluster + axis;
            sums[to] = (sums[to] as number) + at(axis);
            sums[to + 3] = (sums[to + 3] as number) + normal(axis);
        }
    }

    const left: number[] = [];
    for (let i = 0; i < indices.length; i += 3) {
        const corner = (k: number): number => clusterOf[indices[i + k] as number] as number;
        const [a, b, c] = [corner(0), corner(1), corner(2)];
        if (a !== b && b !== c && c !== a) left.push(a, b, c);
    }
    if (2 * left.length > indices.length) return mesh;
    const means = new Float32Array(3 * sizes.length);
    const facing = new Float32Array(3 * sizes.length);
    sizes.forEach((size, cluster) => {
        for (let axis = 0; axis < 3; ++axis) {
            means[3 * cluster + axis] = (sums[6 * cluster + axis] as number) / size;
            // Shaders normalise them.
            facing[3 * cluster + axis] = sums[6 * cluster + 3 + axis] as number;
        }
    });
    return { positions: means, normals: facing, indices: Uint32Array.from(left) };
}
