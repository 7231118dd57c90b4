package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.Settings;

/** What is painted of a window while its colours change. */
@OnDispatchThread
final class WindowBackgroundsTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings =
      new Settings() {
        @Override
        public Optional<String> get(String name) {
          return Optional.ofNullable(remembered.get(name));
        }

        @Override
        public void put(String name, String text) {
          remembered.put(name, text);
        }
      };

  /** Notes whether it is painted in other colours than those of now. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Part extends JLabel {
    private final TreeSet<String> wrong = new TreeSet<>();

    @Override
    protected void paintComponent(Graphics graphics) {
      Color now = UIManager.getColor("Label.foreground");
      if (!getForeground().equals(now)) {
        wrong.add(getForeground() + " instead of " + now);
      }
    }
  }

  @AfterEach
  void leaveNothing() {
    FlatLaf.setGlobalExtraDefaults(null);
    PreviewLook.change(false);
  }

  @Test
  void nothingIsPaintedHalfInTheOldColours() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    Look look = new Look(settings);
    look.setTheme(Theme.LIGHT);
    JFrame frame = new JFrame("colours");
    Part part = new Part();
    frame.add(part);
    frame.setSize(300, 200);
    frame.setVisible(true);
    try {
      for (Theme theme : new Theme[] {Theme.DARK, Theme.LIGHT, Theme.DARK}) {
        look.setTheme(theme);
        assertEquals(UIManager.getColor("control").getRGB(), frame.getBackground().getRGB());
      }
      assertEquals(new TreeSet<>(), part.wrong);
    } finally {
      frame.dispose();
    }
  }
}
