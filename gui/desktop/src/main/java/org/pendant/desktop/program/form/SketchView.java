package org.pendant.desktop.program.form;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** Sketch view: a small picture in a form, as wide as that. */
@SuppressWarnings("serial") // never written to a stream
final class SketchView extends JPanel implements FieldView {
  private static final int WIDTH = 200;
  private static final int HEIGHT = 150;

  private transient Sketch sketch = new Sketch.Arrow(0, 0, 0);

  SketchView(String name) {
    setName(name);
    setOpaque(false);
  }

  @Override
  public JComponent component() {
    return this;
  }

  @Override
  public void show(Item shown) {
    Item.Drawing drawing = (Item.Drawing) shown;
    getAccessibleContext().setAccessibleName(drawing.words());
    setToolTipText(drawing.words());
    if (!drawing.sketch().equals(sketch)) {
      sketch = drawing.sketch();
      repaint();
    }
  }

  @Override
  public Dimension getPreferredSize() {
    return UIScale.scale(new Dimension(WIDTH, HEIGHT));
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(0, getPreferredSize().height);
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setFont(getFont());
    SketchPainter painter = new SketchPainter(pen, getWidth(), getHeight());
    switch (sketch) {
      case Sketch.Places places -> painter.places(places.pattern());
      case Sketch.Arrow arrow -> painter.direction(arrow);
      case Sketch.Stack stack -> painter.stack(stack);
      case Sketch.Axes axes -> painter.axes(axes);
      case Sketch.Message message ->
          new MessagePainter(pen, getWidth(), getHeight()).paint(message);
    }
    pen.dispose();
  }
}
