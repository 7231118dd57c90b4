package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

@OnDispatchThread
final class LookTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings = new MemorySettings(remembered);

  @AfterEach
  void leaveNothing() {
    FlatLaf.setGlobalExtraDefaults(null);
    PreviewLook.change(false);
  }

  @Test
  void aPartThatWasInNoWindowTakesTheColoursOverWhenItIsAdded() {
    Look look = new Look(settings);
    look.setTheme(Theme.LIGHT);
    JPanel part = new JPanel();
    JLabel label = new JLabel("text");
    part.add(label);
    look.setTheme(Theme.DARK);
    new JPanel().add(part);
    assertEquals(UIManager.getColor("Panel.background"), part.getBackground());
    assertEquals(UIManager.getColor("Label.foreground"), label.getForeground());
  }

  /** Has a colour that its look knows nothing of, and a part that it takes it from. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Drawn extends JPanel implements LookFollower {
    private final JLabel part = new JLabel("text");
    private Color seen = Color.PINK;

    Drawn() {
      add(part);
    }

    @Override
    public void lookChanged() {
      seen = part.getForeground();
    }
  }

  @Test
  void whatHasColoursOfItsOwnTakesThemOverWithItsParts() {
    Look look = new Look(settings);
    look.setTheme(Theme.LIGHT);
    Drawn drawn = new Drawn();
    look.setTheme(Theme.DARK);
    JPanel around = new JPanel();
    around.add(drawn);
    assertEquals(UIManager.getColor("Label.foreground"), drawn.seen);
  }

  @Test
  void theChosenOfButtonsSideBySideStandsOutInBothThemes() {
    Look look = new Look(settings);
    for (Theme theme : new Theme[] {Theme.LIGHT, Theme.DARK}) {
      look.setTheme(theme);
      var chosen = UIManager.getColor("ToggleButton.selectedBackground");
      for (String other : new String[] {"background", "disabledBackground"}) {
        double contrast = Contrast.of(chosen, UIManager.getColor("ToggleButton." + other));
        assertTrue(contrast >= Contrast.VISIBLE, theme + ", " + other + ": " + contrast);
      }
      double words = Contrast.of(UIManager.getColor("ToggleButton.selectedForeground"), chosen);
      assertTrue(words >= Contrast.READABLE, theme + ", words: " + words);
    }
  }

  @Test
  void tracksOfScrollBarsAreDrawnWithoutSmoothing() {
    new Look(settings).setTheme(Theme.LIGHT);
    JScrollBar bar = new JScrollBar(JScrollBar.VERTICAL, 0, 10, 0, 100);
    bar.setSize(11, 100);
    bar.doLayout();
    BufferedImage picture = new BufferedImage(20, 100, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = picture.createGraphics();
    pen.setColor(Color.RED);
    pen.fillRect(0, 0, 20, 100);
    // between two pixels, where smoothing would mix the colours
    pen.translate(0.4, 0);
    bar.paint(pen);
    pen.dispose();
    Set<Integer> colors = new HashSet<>();
    for (int x = 0; x < 20; x++) {
      colors.add(picture.getRGB(x, 90));
    }
    assertEquals(
        Set.of(Color.RED.getRGB(), UIManager.getColor("ScrollBar.track").getRGB()), colors);
  }
}
