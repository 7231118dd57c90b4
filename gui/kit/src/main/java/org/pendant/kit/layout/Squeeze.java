package org.pendant.kit.layout;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.LayoutManager2;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import javax.swing.JComponent;

/** Squeezing of a row: leaves out parts, one after the other, until what is left fits its width. */
public final class Squeeze {
  private final JComponent row;
  private final List<Part> parts;

  /** Something that can be left out, or shown in a smaller way. */
  @FunctionalInterface
  public interface Part {

    /** Shows it whole, or small. */
    void show(boolean whole);
  }

  /**
   * Fits a row, again after each change of its width.
   *
   * @param row whose layout knows its least width
   * @param parts what can be left out, the least important first
   */
  public Squeeze(JComponent row, List<Part> parts) {
    this.row = row;
    this.parts = List.copyOf(parts);
    row.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  /** Fits the row after its content has changed. */
  public void fit() {
    if (row.getWidth() <= 0) {
      return;
    }
    parts.forEach(each -> each.show(true));
    for (Part each : parts) {
      if (fits()) {
        break;
      }
      each.show(false);
    }
    row.revalidate();
  }

  /** Fits the row soon: when all in it have their new look, for instance. */
  public void fitLater() {
    EventQueue.invokeLater(this::fit);
  }

  private boolean fits() {
    forgetSizes(row);
    return row.getLayout().minimumLayoutSize(row).width <= row.getWidth();
  }

  /** Layouts keep sizes while their container waits to be laid out; these may be old by now. */
  private static void forgetSizes(Container container) {
    if (container.getLayout() instanceof LayoutManager2 layout) {
      layout.invalidateLayout(container);
    }
    for (Component each : container.getComponents()) {
      if (each instanceof Container inner) {
        forgetSizes(inner);
      }
    }
  }
}
