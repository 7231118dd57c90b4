package org.pendant.desktop.scene.view;

import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.gl.Quality;

/**
 * Picture request: a picture that is wanted.
 *
 * @param model what to draw
 * @param camera from where
 * @param widthPx its width, device pixels
 * @param heightPx its height, device pixels
 * @param quality how well
 */
record PictureRequest(SceneModel model, Camera camera, int widthPx, int heightPx, Quality quality) {

  /** A picture as good as can be. */
  PictureRequest(SceneModel model, Camera camera, int widthPx, int heightPx) {
    this(model, camera, widthPx, heightPx, Quality.FULL);
  }

  /** The same picture, drawn as well as told. */
  PictureRequest as(Quality other) {
    return new PictureRequest(model, camera, widthPx, heightPx, other);
  }
}
