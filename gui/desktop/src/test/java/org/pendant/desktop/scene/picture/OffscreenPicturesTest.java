package org.pendant.desktop.scene.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.GraphicsUnavailable;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.command.service.StandardView;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

final class OffscreenPicturesTest {

  /** The bytes of a picture; aborts the test where there is no OpenGL. */
  private static byte[] picture(StandardView view, boolean dark) throws IOException {
    return picture(ControllerOptions.headless(), view, dark, false);
  }

  private static byte[] picture(
      ControllerOptions options, StandardView view, boolean dark, boolean safety)
      throws IOException {
    Controller controller = new Controller(options);
    ArmState arm = controller.state().arm();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (PictureRenderer renderer = new OffscreenPictures().start()) {
      renderer.trace(arm, 0);
      renderer.write(
          new Picture(
              options.robotId(),
              arm,
              options.scene(),
              options.equipment().devices(),
              controller.state().devices(),
              safety ? Optional.of(controller.safety()) : Optional.empty(),
              controller.state().safety(),
              view,
              dark,
              120,
              80),
          out);
    } catch (GraphicsUnavailable e) {
      Assumptions.abort("no OpenGL on this machine: " + e.getMessage());
    }
    return out.toByteArray();
  }

  @Test
  void drawsAnImageOfTheSizeThatIsWanted() throws IOException {
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(picture(StandardView.ISO, false)));

    assertEquals(120, image.getWidth());
    assertEquals(80, image.getHeight());
  }

  @Test
  void viewsAndThemesDiffer() throws IOException {
    byte[] picture = picture(StandardView.ISO, false);

    assertFalse(Arrays.equals(picture, picture(StandardView.FRONT, false)));
    assertFalse(Arrays.equals(picture, picture(StandardView.ISO, true)));
  }

  @Test
  void safetyPlanesAreDrawnWhereTheyAreWanted() throws IOException {
    ControllerOptions bare = ControllerOptions.headless();
    ControllerOptions fenced =
        bare.withSafety(
            SafetyConfiguration.standard(bare.arm())
                .withPlanes(
                    new SafetyPlane("wall", 0, 0.6, 0, new Axis(0, -1, 0), Applies.BOTH, false)));
    byte[] hidden = picture(fenced, StandardView.ISO, false, false);

    assertArrayEquals(picture(StandardView.ISO, false), hidden);
    assertFalse(Arrays.equals(hidden, picture(fenced, StandardView.ISO, false, true)));
  }

  @Test
  void theGripperOfTheCellIsDrawn() throws IOException {
    ControllerOptions gripping =
        ControllerOptions.headless()
            .withEquipment(
                new CellEquipment(List.of(DeviceSetup.of("two-finger").orElseThrow()), List.of()));
    assertFalse(
        Arrays.equals(
            picture(StandardView.ISO, false), picture(gripping, StandardView.ISO, false, false)));
  }

  @Test
  void bodiesOfTheToolAreDrawnOnTheFlange() throws IOException {
    SceneObject plate =
        new SceneObject.Box(
            "plate",
            new Pose(0, 0, 0.05, 0, 0, 0),
            new Vector3(0.2, 0.2, 0.1),
            Material.DEFAULT,
            0.5);
    Scene tool =
        new Scene(
            List.of(),
            Optional.empty(),
            List.of(),
            List.of(plate),
            Wrench.ZERO,
            Scene.EMPTY.links());
    assertFalse(
        Arrays.equals(
            picture(StandardView.ISO, false),
            picture(ControllerOptions.headless().withScene(tool), StandardView.ISO, false, false)));
  }

  @Test
  void theCommandLineFindsThem() {
    assertInstanceOf(
        OffscreenPictures.class,
        ServiceLoader.load(PictureRenderer.Factory.class).findFirst().orElseThrow());
  }
}
