/**
 * Meshes: triangles of arms, of what stands around them, and of the marks drawn between. Open
 * {@link org.pendant.desktop.scene.mesh.ArmMeshes} first, then {@link
 * org.pendant.desktop.scene.mesh.Mesh}.
 */
package org.pendant.desktop.scene.mesh;
