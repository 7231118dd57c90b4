package org.pendant.desktop.help;

import java.awt.AWTError;
import java.awt.Font;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import org.pendant.command.doctor.DiskInspection;
import org.pendant.command.doctor.Finding;
import org.pendant.command.doctor.FindingText;
import org.pendant.command.doctor.FindingTexts;
import org.pendant.command.doctor.Inspection;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.SceneUnavailable;
import org.pendant.kit.settings.ConfigurationFolder;

/** Looks at what the window needs: a display, fonts, OpenGL and a place for its settings. */
public final class DesktopInspection implements Inspection {
  private static final FindingTexts TEXTS = FindingTexts.of(DesktopInspection.class);

  private static final FindingText DISPLAY = text("display");
  private static final FindingText FONTS = text("fonts");

  private static final FindingText OPENGL = FindingText.of("OpenGL");

  /** As drivers call renderers that draw with the processor. */
  private static final List<String> SOFTWARE =
      List.of("llvmpipe", "softpipe", "swrast", "Software");

  /** A word that is written with Chinese characters. */
  private static final String CHINESE = "\u4e2d\u6587";

  private static FindingText text(String key, Object... values) {
    return TEXTS.get(key, values);
  }

  @Override
  public List<Finding> findings() {
    return List.of(
        DiskInspection.folder(
            text("settings"), ConfigurationFolder.of(System.getProperties(), System.getenv())),
        display(),
        fonts(),
        graphics());
  }

  private static Finding display() {
    if (GraphicsEnvironment.isHeadless()) {
      return noDisplay(text("noScreenIsConnectedToThis"));
    }
    try {
      GraphicsDevice[] screens =
          GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices();
      return Finding.ok(
          DISPLAY,
          Arrays.stream(screens)
              .map(DesktopInspection::screen)
              .reduce((some, next) -> text("screens", some, next))
              .orElse(FindingText.of("")));
    } catch (AWTError | UnsatisfiedLinkError e) {
      return noDisplay(FindingText.message(String.valueOf(e.getMessage())));
    }
  }

  private static Finding noDisplay(FindingText reason) {
    return Finding.note(DISPLAY, text("thereIsNone", reason), text("theWindowDoesNotOpenEvery"));
  }

  private static FindingText screen(GraphicsDevice screen) {
    Rectangle bounds = screen.getDefaultConfiguration().getBounds();
    double scale = screen.getDefaultConfiguration().getDefaultTransform().getScaleX();
    return text("screen", bounds.width, bounds.height, "%.0f".formatted(100 * scale));
  }

  private static Finding fonts() {
    try {
      Font[] fonts = GraphicsEnvironment.getLocalGraphicsEnvironment().getAllFonts();
      FindingText found = text("besidesThoseThatPendantBrings", fonts.length);
      return Arrays.stream(fonts).anyMatch(each -> each.canDisplayUpTo(CHINESE) < 0)
          ? Finding.ok(FONTS, found)
          : Finding.note(
              FONTS, text("noneWithChineseCharacters", found), text("suchTextsAreBoxesOnDebian"));
    } catch (RuntimeException | LinkageError e) {
      // That is how Java tells that the system has none.
      return Finding.problem(
          FONTS, text("javaCannotUseAny", e.getMessage()), text("onDebianAndUbuntuAptInstall"));
    }
  }

  private static Finding graphics() {
    try (OffscreenScene scene = OffscreenScene.open()) {
      String renderer = scene.graphics();
      return SOFTWARE.stream().noneMatch(renderer::contains)
          ? Finding.ok(OPENGL, FindingText.of(renderer))
          : Finding.note(OPENGL, FindingText.of(renderer), text("theProcessorDrawsThe3dView"));
    } catch (SceneUnavailable e) {
      return Finding.note(OPENGL, FindingText.message(e.getMessage()), text("thereIsNo3dViewAnd"));
    }
  }
}
