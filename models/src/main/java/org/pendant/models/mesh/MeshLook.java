package org.pendant.models.mesh;

import java.util.Optional;

/**
 * Mesh look: what can be told of a file of triangles, also of one that is no solid.
 *
 * @param triangles how many there are
 * @param xM how long they are along x, m, as along y and z
 * @param yM along y, m
 * @param zM along z, m
 * @param mesh the solid, if it is one
 * @param problem why it is none; empty if it is one
 */
public record MeshLook(
    int triangles,
    double xM,
    double yM,
    double zM,
    Optional<TriangleMesh> mesh,
    Optional<String> problem) {}
