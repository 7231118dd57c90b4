package org.pendant.window;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.pendant.command.service.StandardView;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.SceneUnavailable;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/** All arms side by side in one picture, each as large as there is room. */
final class ContactSheet {
  private static final int COLUMNS = 7;
  private static final int WIDTH_PX = 180;
  private static final int HEIGHT_PX = 226;

  private static final Joints POSTURE = Joints.of(-0.1, -1.95, -1.3, -1.46, 1.57, 0.3);

  private ContactSheet() {}

  /** Draws the picture into a file. */
  static void write(Path file) throws IOException, SceneUnavailable {
    List<String> ids = ArmLibrary.ids();
    int rows = Math.ceilDiv(ids.size(), COLUMNS);
    BufferedImage sheet =
        new BufferedImage(COLUMNS * WIDTH_PX, rows * HEIGHT_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = sheet.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
    graphics.setColor(new Color(0x2B2F34));
    try (OffscreenScene scene = OffscreenScene.open()) {
      for (int i = 0; i < ids.size(); i++) {
        ArmDescription arm = ArmLibrary.load(ids.get(i));
        int x = i % COLUMNS * WIDTH_PX;
        int y = i / COLUMNS * HEIGHT_PX;
        graphics.drawImage(picture(scene, arm), x, y, null);
        graphics.drawString(arm.displayName(), x + 10, y + 22);
      }
    }
    graphics.dispose();
    ImageIO.write(SmallPicture.of(sheet), "png", file.toFile());
  }

  private static BufferedImage picture(OffscreenScene scene, ArmDescription arm) {
    SceneModel model = SceneModel.of(arm, POSTURE);
    Camera camera =
        Camera.of(StandardView.ISO, SceneBounds.of(model), (double) WIDTH_PX / HEIGHT_PX);
    return scene.render(model, camera, WIDTH_PX, HEIGHT_PX);
  }
}
