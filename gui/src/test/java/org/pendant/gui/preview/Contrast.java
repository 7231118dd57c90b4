package org.pendant.gui.preview;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import javax.swing.AbstractButton;
import javax.swing.JLabel;

/** Contrast of texts: whether they can be read. */
public final class Contrast {
  /** WCAG 2.2, success criterion 1.4.3, for texts of usual size. */
  public static final double READABLE = 4.5;

  /** WCAG 2.2, success criterion 1.4.11, for what is drawn. */
  public static final double VISIBLE = 3;

  private Contrast() {}

  /** WCAG 2.2, contrast ratio, from 1 to 21. */
  public static double of(Color one, Color other) {
    double lighter = Math.max(luminance(one), luminance(other));
    double darker = Math.min(luminance(one), luminance(other));
    return (lighter + 0.05) / (darker + 0.05);
  }

  private static double luminance(Color color) {
    double[] linear =
        DoubleStream.of(color.getRed(), color.getGreen(), color.getBlue())
            .map(value -> value / 255)
            .map(value -> value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4))
            .toArray();
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  }

  /** The enabled labels and buttons in a component whose text can hardly be read. */
  public static List<String> hardToRead(Component component) {
    List<String> found = new ArrayList<>();
    collect(component, component.getBackground(), found);
    return found;
  }

  private static void collect(Component component, Color under, List<String> found) {
    Color ground =
        component.isOpaque() && !(component instanceof AbstractButton)
            ? component.getBackground()
            : under;
    String text =
        switch (component) {
          case JLabel label -> label.getText();
          case AbstractButton button when !button.isSelected() -> button.getText();
          default -> null;
        };
    if (component.isEnabled() && text != null && !text.isBlank()) {
      double contrast = of(component.getForeground(), ground);
      if (contrast < READABLE) {
        found.add("%s: contrast %.1f".formatted(text, contrast));
      }
    }
    if (component instanceof Container container) {
      for (Component each : container.getComponents()) {
        collect(each, ground, found);
      }
    }
  }
}
