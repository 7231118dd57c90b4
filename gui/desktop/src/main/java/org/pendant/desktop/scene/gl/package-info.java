/**
 * OpenGL renderer: draws the scene with OpenGL 3.3, with or without a window. Open {@link
 * org.pendant.desktop.scene.gl.OffscreenScene} first, then {@link
 * org.pendant.desktop.scene.gl.SceneRenderer}.
 */
package org.pendant.desktop.scene.gl;
