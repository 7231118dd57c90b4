package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;

final class PaletteTest {
  @Test
  void aColourThatWasTakenOnceFollowsTheTheme() {
    PreviewLook.change(false);
    JLabel label = new JLabel("2 things to complete");
    label.setForeground(Palette.warning());
    label.setBackground(Palette.tint(Palette.error(), 0.16));
    int light = label.getBackground().getRGB();
    PreviewLook.change(true);
    SwingUtilities.updateComponentTreeUI(label);
    assertEquals(new Color(0xF2B24C), label.getForeground());
    assertTrue(Contrast.of(label.getForeground(), UIManager.getColor("Panel.background")) >= 4.5);
    assertTrue(Contrast.of(label.getBackground(), new Color(light)) >= 4.5);
  }

  @Test
  void aBorderIsPaintedInTheColourOfTheTheme() {
    PreviewLook.change(true);
    JLabel label = new JLabel();
    label.setBorder(BorderFactory.createLineBorder(Palette.line()));
    label.setSize(8, 8);
    PreviewLook.change(false);
    BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
    label.paint(image.createGraphics());
    assertEquals(Palette.line().getRGB(), image.getRGB(0, 4));
    assertEquals(0xFFD5D9DE, image.getRGB(0, 4));
  }

  @Test
  void wordsAndLinesStandOutOnCardsInBothThemes() {
    List<Color> words =
        List.of(
            Palette.accent(), Palette.ok(), Palette.warning(), Palette.error(), Palette.quiet());
    for (boolean dark : new boolean[] {false, true}) {
      PreviewLook.change(dark);
      for (Color each : words) {
        assertContrast(Contrast.READABLE, each);
      }
      for (int i = 0; i < 8; i++) {
        assertContrast(Contrast.VISIBLE, Palette.series(i));
      }
    }
  }

  private static void assertContrast(double least, Color color) {
    double contrast = Contrast.of(color, Palette.card());
    assertTrue(contrast >= least, color + " on " + Palette.card() + " has contrast " + contrast);
  }
}
