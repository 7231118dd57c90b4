package org.pendant.desktop.scene.picture;

import org.pendant.command.service.GraphicsUnavailable;
import org.pendant.command.service.PictureRenderer;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.SceneUnavailable;

/** Factory of picture renderers that need no window. */
public final class OffscreenPictures implements PictureRenderer.Factory {

  @Override
  public PictureRenderer start() throws GraphicsUnavailable {
    try {
      return new OffscreenRenderer(OffscreenScene.open());
    } catch (SceneUnavailable e) {
      throw new GraphicsUnavailable(e.getMessage(), e);
    }
  }
}
