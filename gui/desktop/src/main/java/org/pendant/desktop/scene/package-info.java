/**
 * Scene: what the 3D view shows and from where, without a window and without OpenGL. Open {@link
 * org.pendant.desktop.scene.SceneModel} first, then {@link org.pendant.desktop.scene.Camera}.
 */
package org.pendant.desktop.scene;
