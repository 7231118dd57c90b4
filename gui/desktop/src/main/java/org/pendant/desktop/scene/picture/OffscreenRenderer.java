package org.pendant.desktop.scene.picture;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.Touching;
import org.pendant.desktop.scene.TraceRing;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.models.arm.ArmLibrary;

/** Picture renderer on an offscreen scene. */
final class OffscreenRenderer implements PictureRenderer {
  /** Half a minute of steady motion at millimetres a frame. */
  private static final int MAX_POINTS = 20_000;

  private final OffscreenScene scene;
  private final TraceRing ring = new TraceRing(MAX_POINTS);

  OffscreenRenderer(OffscreenScene scene) {
    this.scene = scene;
  }

  @Override
  public void trace(ArmState arm, double timeS) {
    ring.add(arm, timeS, 0);
  }

  @Override
  public void write(Picture picture, OutputStream out) throws IOException {
    // A picture in the making needs no file besides its own.
    ImageIO.setUseCache(false);
    ImageIO.write(image(picture), "png", out);
  }

  private BufferedImage image(Picture picture) {
    ArmState arm = picture.arm();
    Scene world = picture.world();
    SceneModel model =
        SceneModel.of(ArmLibrary.load(picture.robotId()), arm.actualPositionRad())
            .at(arm)
            .withWorld(
                world,
                new Touching(world)
                    .names(arm.kinematics(), arm.actualPositionRad(), arm.tool().inFlange()))
            .withSafety(safety(picture))
            .withDevices(DeviceSight.of(picture.devices(), picture.deviceStates(), false))
            .withTrace(ring.trace())
            .withTheme(picture.dark() ? SceneTheme.DARK : SceneTheme.LIGHT);
    double aspect = (double) picture.widthPx() / picture.heightPx();
    Camera camera = Camera.of(picture.view(), SceneBounds.of(model), aspect);
    return scene.render(model, camera, picture.widthPx(), picture.heightPx());
  }

  private static SafetySight safety(Picture picture) {
    return picture
        .limits()
        .map(
            limits ->
                SafetySight.of(
                    limits,
                    Optional.empty(),
                    picture.safety().stop(),
                    picture.safety().reduced(),
                    picture.arm().actualPositionRad(),
                    new SafetySight.Wanted(true, true, false, false)))
        .orElse(SafetySight.NONE);
  }

  @Override
  public void close() {
    scene.close();
  }
}
