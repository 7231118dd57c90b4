package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JLabel;
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

  /** Counts how often it is painted. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Part extends JLabel {
    private int paintings;

    @Override
    protected void paintComponent(Graphics graphics) {
      paintings++;
    }
  }

  @AfterEach
  void leaveNothing() {
    FlatLaf.setGlobalExtraDefaults(null);
    PreviewLook.change(false);
  }

  @Test
  void nothingIsClearedAndPaintedWithoutABufferWhileColoursChange() {
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
        int before = part.paintings;
        look.setTheme(theme);
        assertEquals(before, part.paintings, "it waits for the next painting of all that changed");
      }
    } finally {
      frame.dispose();
    }
  }
}
