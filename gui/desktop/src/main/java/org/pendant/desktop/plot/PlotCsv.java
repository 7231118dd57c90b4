package org.pendant.desktop.plot;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import org.pendant.controller.disk.AtomicFile;

/**
 * CSV export: samples as comma-separated values: a header with ids and units, then one row a
 * sample. Numbers have full precision and a point, whatever the country; unknown values are empty.
 * Script variables have a row each frame, in which other quantities are empty unless they were
 * sampled in it.
 */
final class PlotCsv {
  private final List<ChartQuantity> quantities;
  private final double[] timeS;
  private final double[][] values;

  private PlotCsv(List<ChartQuantity> quantities, double[] timeS, double[][] values) {
    this.quantities = quantities;
    this.timeS = timeS;
    this.values = values;
  }

  /** Copies what is in a window, so that another thread can write it. */
  static PlotCsv of(History history, List<ChartQuantity> quantities, TimeWindow window) {
    double[] timeS =
        quantities.stream()
            .map(history::of)
            .distinct()
            .flatMapToDouble(series -> times(series, window))
            .sorted()
            .distinct()
            .toArray();
    double[][] values = new double[quantities.size()][];
    for (int k = 0; k < values.length; k++) {
      values[k] = column(history.of(quantities.get(k)), quantities.get(k), timeS);
    }
    return new PlotCsv(quantities, timeS, values);
  }

  private static DoubleStream times(TimeSeries series, TimeWindow window) {
    long begin = series.firstAtLeast(window.beginS());
    long end = series.firstAtLeast(Math.nextUp(window.endS()));
    return LongStream.range(begin, end).mapToDouble(series::timeS);
  }

  /** The values at some times; unknown where the series has no sample of exactly that time. */
  private static double[] column(TimeSeries series, ChartQuantity quantity, double[] timeS) {
    double[] column = new double[timeS.length];
    long number = timeS.length == 0 ? series.end() : series.firstAtLeast(timeS[0]);
    for (int i = 0; i < column.length; i++) {
      boolean sampled = number < series.end() && series.timeS(number) == timeS[i];
      column[i] = sampled ? series.value(quantity, number) : Double.NaN;
      number += sampled ? 1 : 0;
    }
    return column;
  }

  int rows() {
    return timeS.length;
  }

  /** Writes all of it. */
  void write(Appendable out) throws IOException {
    out.append("time_s");
    for (ChartQuantity each : quantities) {
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

  /** Writes all of it to a file, created or replaced as a whole; not for the dispatch thread. */
  void write(Path file) throws IOException {
    AtomicFile.write(
        file,
        out -> {
          try (Writer text = new BufferedWriter(new OutputStreamWriter(out, UTF_8))) {
            write(text);
          }
        });
  }
}
