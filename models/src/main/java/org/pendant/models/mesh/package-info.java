/** Meshes: solids that are made of triangles, read from files of other programs. */
package org.pendant.models.mesh;
