package org.pendant.desktop.sweep;

import java.awt.Component;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import org.pendant.sweep.plan.SamplingMethod;

/** Method cell: a way to choose variants, as people read it. */
@SuppressWarnings("serial") // never written to a stream
final class MethodCell extends DefaultListCellRenderer {
  @Override
  public Component getListCellRendererComponent(
      JList<?> list, Object value, int index, boolean selected, boolean focused) {
    Object shown = value instanceof SamplingMethod method ? title(method) : value;
    return super.getListCellRendererComponent(list, shown, index, selected, focused);
  }

  static String title(SamplingMethod method) {
    return switch (method) {
      case GRID -> "Grid";
      case LIST -> "List";
      case RANDOM -> "Random";
      case LATIN_HYPERCUBE -> "Latin hypercube";
      case SOBOL -> "Sobol";
      case SEARCH -> "Search for the best";
    };
  }

  /** What it means, in a sentence. */
  static String about(SamplingMethod method) {
    return switch (method) {
      case GRID -> "Every combination of all steps";
      case LIST -> "The first values of all, then the second of all";
      case RANDOM -> "Each value at random in its range";
      case LATIN_HYPERCUBE -> "At random, with each slice of each range once";
      case SOBOL -> "Points that fill the ranges evenly";
      case SEARCH -> "Goes to the best values by CMA-ES, within the limits";
    };
  }
}
