package org.pendant.kit.icon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;
import org.pendant.kit.theme.Palette;
import org.pendant.kit.theme.PreviewLook;

final class SvgIconTest {
  private static final Pattern COLOUR = Pattern.compile("(?:fill|stroke)=\"([^\"]*)\"");

  private static JLabel label() {
    JLabel label = new JLabel("words");
    label.setForeground(new Color(0x123456));
    return label;
  }

  /** The colour in the middle of an icon of 16. */
  private static Color middle(SvgIcon icon, JLabel on, double scale) {
    int side = (int) (16 * scale);
    BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    graphics.scale(scale, scale);
    icon.paintIcon(on, graphics, 0, 0);
    return new Color(image.getRGB(side / 2, side / 2), true);
  }

  @Test
  void aGlyphIsInTheColourOfTheTextBesideIt() {
    for (boolean dark : new boolean[] {false, true}) {
      PreviewLook.change(dark);
      assertEquals(label().getForeground(), middle(Glyph.STOP.icon(16), label(), 1));
    }
  }

  @Test
  void aDrawingIsInTheColoursOfTheTheme() {
    SvgIcon held = SvgIcon.of("line/arrow-held", 16);
    PreviewLook.change(false);
    Color light = middle(held, label(), 1);
    assertEquals(Palette.ok(), light);
    PreviewLook.change(true);
    assertEquals(Palette.ok(), middle(held, label(), 1));
    assertNotEquals(light, middle(held, label(), 1));
  }

  @Test
  void aWhiteTextLeavesTheOtherColoursAsTheyAre() {
    PreviewLook.change(true);
    JLabel white = label();
    white.setForeground(Color.WHITE);
    assertEquals(Palette.ok(), middle(SvgIcon.of("line/arrow-held", 16), white, 1));
    assertEquals(Color.WHITE, middle(Glyph.STOP.icon(16), white, 1));
  }

  @Test
  void anIconInOneColourIsInThat() {
    PreviewLook.change(true);
    SvgIcon icon = SvgIcon.of("line/arrow-held", 16).in(Color.MAGENTA);
    assertEquals(Color.MAGENTA, middle(icon, label(), 1));
  }

  @Test
  void aDisabledIconIsGreyUnlessItShowsAState() {
    PreviewLook.change(false);
    JLabel disabled = label();
    disabled.setEnabled(false);
    Color grey = UIManager.getColor("Label.disabledForeground");
    SvgIcon held = SvgIcon.of("line/arrow-held", 16);
    assertEquals(grey.getRGB(), middle(held, disabled, 1).getRGB());
    assertEquals(grey.getRGB(), middle(held.in(Color.MAGENTA), disabled, 1).getRGB());
    assertEquals(Palette.ok(), middle(held.lit(), disabled, 1));
  }

  @Test
  void anIconFillsItsPlaceAtEveryScale() {
    PreviewLook.change(false);
    for (double scale : new double[] {1, 1.5, 2}) {
      assertEquals(label().getForeground(), middle(Glyph.STOP.icon(16), label(), scale));
    }
  }

  @Test
  void everyGlyphHasADrawing() {
    for (Glyph glyph : Glyph.values()) {
      assertTrue(glyph.icon(16).hasFound(), glyph::name);
    }
  }

  @Test
  void drawingsAreInTheLightColoursOfThePaletteAndInThatOfText()
      throws IOException, URISyntaxException {
    PreviewLook.change(true);
    Path folder =
        Path.of(SvgIcon.class.getResource("glyph/play.svg").toURI()).getParent().getParent();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(each -> each.toString().endsWith(".svg")).toList()) {
        for (MatchResult found : COLOUR.matcher(Files.readString(file)).results().toList()) {
          String colour = found.group(1);
          assertTrue(
              colour.equals("none")
                  || colour.equals("#1D2329")
                  || !Palette.ofLight(Color.decode(colour)).equals(Color.decode(colour)),
              () -> file + " has " + colour + ", which is not of the palette");
        }
      }
    }
  }
}
