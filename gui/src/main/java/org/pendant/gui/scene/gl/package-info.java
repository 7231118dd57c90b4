/**
 * Draws the scene with OpenGL 3.3, with or without a window. Open {@link
 * org.pendant.gui.scene.gl.OffscreenScene} first, then {@link
 * org.pendant.gui.scene.gl.SceneRenderer}.
 */
package org.pendant.gui.scene.gl;
