package org.pendant.gui.scene.view;

import org.pendant.gui.scene.Camera;
import org.pendant.gui.scene.SceneModel;

/**
 * A picture that is wanted.
 *
 * @param model what to draw
 * @param camera from where
 * @param widthPx its width, device pixels
 * @param heightPx its height, device pixels
 */
record PictureRequest(SceneModel model, Camera camera, int widthPx, int heightPx) {

  /** The same picture with half as many pixels in a row. */
  PictureRequest coarse() {
    return new PictureRequest(model, camera, half(widthPx), half(heightPx));
  }

  private static int half(int px) {
    return Math.max(1, px / 2);
  }
}
