package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class CardColumnsTest {
  private final JPanel sheet = new JPanel(new CardColumns(10, 400));

  private JPanel card(int width, int height) {
    JPanel card = new JPanel();
    card.setPreferredSize(new Dimension(width, height));
    sheet.add(card);
    return card;
  }

  private void layOut(int width) {
    sheet.setSize(width, 1000);
    sheet.doLayout();
  }

  @Test
  void thereAreAsManyColumnsAsFit() {
    JPanel first = card(100, 50);
    JPanel second = card(100, 80);
    JPanel third = card(100, 20);
    layOut(230);
    assertEquals(new Rectangle(10, 10, 100, 50), first.getBounds());
    assertEquals(new Rectangle(120, 10, 100, 80), second.getBounds());
    assertEquals(new Rectangle(10, 70, 100, 20), third.getBounds(), "below the shorter column");
  }

  @Test
  void aHiddenCardTakesNoPlaceAndSetsNoWidth() {
    card(300, 70).setVisible(false);
    JPanel first = card(100, 50);
    JPanel second = card(100, 80);
    layOut(230);
    assertEquals(new Rectangle(10, 10, 100, 50), first.getBounds());
    assertEquals(new Rectangle(120, 10, 100, 80), second.getBounds());
    assertEquals(100, sheet.getPreferredSize().height);
  }

  @Test
  void oneColumnIsAlwaysThere() {
    JPanel only = card(100, 50);
    layOut(60);
    assertEquals(10, only.getX());
  }

  @Test
  void aWideCardSpansColumns() {
    card(100, 50);
    JPanel wide = card(150, 30);
    layOut(340);
    assertEquals(new Rectangle(120, 10, 210, 30), wide.getBounds());
  }

  @Test
  void theHeightIsThatOfTheLongestColumn() {
    card(100, 50);
    card(100, 80);
    layOut(230);
    assertEquals(100, sheet.getPreferredSize().height);
  }
}
