package org.pendant.desktop.help;

import java.awt.AWTError;
import java.awt.Font;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.pendant.command.doctor.DiskInspection;
import org.pendant.command.doctor.Finding;
import org.pendant.command.doctor.Inspection;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.SceneUnavailable;
import org.pendant.kit.settings.ConfigurationFolder;

/** Looks at what the window needs: a display, fonts, OpenGL and a place for its settings. */
public final class DesktopInspection implements Inspection {
  private static final String DISPLAY = "Display";
  private static final String FONTS = "Fonts";

  /** As drivers call renderers that draw with the processor. */
  private static final List<String> SOFTWARE =
      List.of("llvmpipe", "softpipe", "swrast", "Software");

  /** A word that is written with Chinese characters. */
  private static final String CHINESE = "\u4e2d\u6587";

  @Override
  public List<Finding> findings() {
    return List.of(
        DiskInspection.folder(
            "Settings", ConfigurationFolder.of(System.getProperties(), System.getenv())),
        display(),
        fonts(),
        graphics());
  }

  private static Finding display() {
    if (GraphicsEnvironment.isHeadless()) {
      return noDisplay("no screen is connected to this session");
    }
    try {
      GraphicsDevice[] screens =
          GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices();
      return Finding.ok(
          DISPLAY,
          Arrays.stream(screens).map(DesktopInspection::screen).collect(Collectors.joining(", ")));
    } catch (AWTError | UnsatisfiedLinkError e) {
      return noDisplay(e.getMessage());
    }
  }

  private static Finding noDisplay(String reason) {
    return Finding.note(
        DISPLAY,
        "there is none: " + reason,
        "the window does not open; every other command works without");
  }

  private static String screen(GraphicsDevice screen) {
    Rectangle bounds = screen.getDefaultConfiguration().getBounds();
    double scale = screen.getDefaultConfiguration().getDefaultTransform().getScaleX();
    return "%dx%d at %.0f %%".formatted(bounds.width, bounds.height, 100 * scale);
  }

  private static Finding fonts() {
    try {
      Font[] fonts = GraphicsEnvironment.getLocalGraphicsEnvironment().getAllFonts();
      String found = fonts.length + " besides those that Pendant brings";
      return Arrays.stream(fonts).anyMatch(each -> each.canDisplayUpTo(CHINESE) < 0)
          ? Finding.ok(FONTS, found)
          : Finding.note(
              FONTS,
              found + ", none with Chinese characters",
              "such texts are boxes: on Debian and Ubuntu apt install fonts-noto-cjk");
    } catch (RuntimeException | LinkageError e) {
      // That is how Java tells that the system has none.
      return Finding.problem(
          FONTS,
          "Java cannot use any: " + e.getMessage(),
          "on Debian and Ubuntu apt install fontconfig fonts-dejavu-core libfreetype6");
    }
  }

  private static Finding graphics() {
    try (OffscreenScene scene = OffscreenScene.open()) {
      String renderer = scene.graphics();
      return SOFTWARE.stream().noneMatch(renderer::contains)
          ? Finding.ok("OpenGL", renderer)
          : Finding.note(
              "OpenGL",
              renderer,
              "the processor draws the 3D view; the driver of a graphics card would do it faster");
    } catch (SceneUnavailable e) {
      return Finding.note(
          "OpenGL", e.getMessage(), "there is no 3D view and no pendant render; all else works");
    }
  }
}
