package org.pendant.desktop.program.form;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import javax.swing.UIManager;

/** The arrow of a choice that folds out, for fields that are typed into. */
final class DownArrow extends FlatAbstractIcon {
  private static final int SIZE = 11;

  DownArrow() {
    super(SIZE, SIZE, null); // the colour is that of the theme when it is drawn
  }

  @Override
  protected void paintIcon(Component shownIn, Graphics2D pen) {
    Path2D arrow = new Path2D.Double();
    arrow.moveTo(1.5, 3.5);
    arrow.lineTo(5.5, 7.5);
    arrow.lineTo(9.5, 3.5);
    pen.setColor(UIManager.getColor("ComboBox.buttonArrowColor"));
    pen.setStroke(new BasicStroke(1));
    pen.draw(arrow);
  }
}
