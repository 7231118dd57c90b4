/**
 * Triangles: of arms, of what stands around them, and of the marks drawn between. Open {@link
 * org.pendant.gui.scene.mesh.ArmMeshes} first, then {@link org.pendant.gui.scene.mesh.Mesh}.
 */
package org.pendant.gui.scene.mesh;
