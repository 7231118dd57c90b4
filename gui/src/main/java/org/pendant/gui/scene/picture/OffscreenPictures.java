package org.pendant.gui.scene.picture;

import org.pendant.gui.command.service.GraphicsUnavailable;
import org.pendant.gui.command.service.PictureRenderer;
import org.pendant.gui.scene.gl.OffscreenScene;
import org.pendant.gui.scene.gl.SceneUnavailable;

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
