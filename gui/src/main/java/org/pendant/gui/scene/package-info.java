/**
 * What the 3D view shows and from where, without a window and without OpenGL. Open {@link
 * org.pendant.gui.scene.SceneModel} first, then {@link org.pendant.gui.scene.Camera}.
 */
package org.pendant.gui.scene;
