/**
 * Scene view: the 3D view as a part of a window. Open {@link
 * org.pendant.desktop.scene.view.SceneView} first, then {@link
 * org.pendant.desktop.scene.view.PictureLoop}, which keeps drawing off the dispatch thread.
 */
package org.pendant.desktop.scene.view;
