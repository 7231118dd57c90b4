package org.pendant.gui.plot;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Samples as comma-separated values: a header with ids and units, then one row a sample. Numbers
 * have full precision and a point, whatever the country; unknown values are empty.
 */
final class PlotCsv {
  private final List<Quantity> quantities;
  private final double[] timeS;
  private final double[][] values;

  private PlotCsv(List<Quantity> quantities, double[] timeS, double[][] values) {
    this.quantities = quantities;
    this.timeS = timeS;
    this.values = values;
  }

  /** Copies what is in a window, so that another thread can write it. */
  static PlotCsv of(History history, List<Quantity> quantities, TimeWindow window) {
    long begin = history.firstAtLeast(window.beginS());
    int count = (int) (history.firstAtLeast(Math.nextUp(window.endS())) - begin);
    double[] timeS = new double[count];
    double[][] values = new double[quantities.size()][count];
    for (int i = 0; i < count; i++) {
      timeS[i] = history.timeS(begin + i);
      for (int k = 0; k < values.length; k++) {
        values[k][i] = history.value(quantities.get(k), begin + i);
      }
    }
    return new PlotCsv(quantities, timeS, values);
  }

  int rows() {
    return timeS.length;
  }

  /** Writes all of it. */
  void write(Appendable out) throws IOException {
    out.append("time_s");
    for (Quantity each : quantities) {
      out.append(',').append(each.id());
      if (!each.unit().isEmpty()) {
        out.append(" [").append(each.unit()).append(']');
      }
    }
    out.append('\n');
    for (int i = 0; i < timeS.length; i++) {
      out.append(Double.toString(timeS[i]));
      for (double[] column : values) {
        out.append(',').append(Double.isNaN(column[i]) ? "" : Double.toString(column[i]));
      }
      out.append('\n');
    }
  }

  /** Writes all of it to a file, which is created or emptied; not for the dispatch thread. */
  void write(Path file) throws IOException {
    try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
      write(out);
    }
  }
}
