package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

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
      case GRID -> text("grid");
      case LIST -> text("list");
      case RANDOM -> text("random");
      case LATIN_HYPERCUBE -> text("latinHypercube");
      case SOBOL -> text("sobol");
      case SEARCH -> text("searchForTheBest");
    };
  }

  /** What it means, in a sentence. */
  static String about(SamplingMethod method) {
    return switch (method) {
      case GRID -> text("everyCombinationOfAllSteps");
      case LIST -> text("theFirstValuesOfAllThen");
      case RANDOM -> text("eachValueAtRandomInIts");
      case LATIN_HYPERCUBE -> text("atRandomWithEachSliceOf");
      case SOBOL -> text("pointsThatFillTheRangesEvenly");
      case SEARCH -> text("goesToTheBestValuesBy");
    };
  }
}
