package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.pendant.kit.theme.Palette;

/** What a table of variants looks like. */
final class VariantTableTest {
  @Test
  void colourOfAVariantStandsOutFromASelectedRowOfTheSameColour() {
    Color selected = new Color(0x2C5D8F);
    BufferedImage picture = new BufferedImage(60, 30, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = picture.createGraphics();
    pen.setColor(selected);
    pen.fillRect(0, 0, 60, 30);
    VariantTable.Swatch swatch = new VariantTable.Swatch(selected);

    swatch.paintIcon(null, pen, 5, 5);

    int middle = 5 + swatch.getIconHeight() / 2;
    assertEquals(selected.getRGB(), picture.getRGB(5 + swatch.getIconWidth() / 2, middle));
    assertEquals(Palette.card().getRGB(), picture.getRGB(5, middle));
    assertEquals(Palette.card().getRGB(), picture.getRGB(4 + swatch.getIconWidth(), middle));
    assertEquals(selected.getRGB(), picture.getRGB(5 + swatch.getIconWidth(), middle));
  }
}
