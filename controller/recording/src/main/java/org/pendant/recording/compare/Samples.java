package org.pendant.recording.compare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;

/**
 * Samples: numbers of state quantities at times that rise, in units of the catalogue of quantities.
 * Immutable.
 */
public final class Samples {
  private final double[] timesS;
  private final List<StateQuantity> quantities;
  private final Map<String, double[][]> columns = new LinkedHashMap<>();

  private Samples(double[] timesS, List<StateQuantity> quantities, double[][] columns) {
    this.timesS = timesS;
    this.quantities = List.copyOf(quantities);
    int column = 0;
    for (StateQuantity each : quantities) {
      this.columns.put(each.name(), Arrays.copyOfRange(columns, column, column + each.size()));
      column += each.size();
    }
  }

  /** Gathers samples. */
  public static final class Builder {
    private static final int FIRST_ROWS = 1024;

    private final List<StateQuantity> quantities;
    private final double[] row;
    private final double[][] columns;
    private double[] timesS = new double[FIRST_ROWS];
    private int rows;

    /** For these quantities. */
    public Builder(List<StateQuantity> quantities) {
      this.quantities = List.copyOf(quantities);
      int size = quantities.stream().mapToInt(StateQuantity::size).sum();
      row = new double[size];
      columns = new double[size][FIRST_ROWS];
    }

    /** How many there are. */
    public int rows() {
      return rows;
    }

    /** The time of the last, s; there is one. */
    double lastS() {
      return timesS[rows - 1];
    }

    /**
     * Adds a row.
     *
     * @param timeS above that of the row before
     * @param numbers of all quantities in their order
     */
    void add(double timeS, double[] numbers) {
      if (rows > 0 && !(timeS > lastS())) {
        throw new IllegalArgumentException(
            "a sample is at " + timeS + " s, must be after " + lastS() + " s");
      }
      if (rows == timesS.length) {
        int more = rows + rows / 2;
        timesS = Arrays.copyOf(timesS, more);
        for (int i = 0; i < columns.length; i++) {
          columns[i] = Arrays.copyOf(columns[i], more);
        }
      }
      timesS[rows] = timeS;
      for (int i = 0; i < columns.length; i++) {
        columns[i][rows] = numbers[i];
      }
      rows++;
    }

    /** Adds what a snapshot has, at its robot time. */
    public void add(ControllerState state) {
      int at = 0;
      for (StateQuantity each : quantities) {
        each.getter().read(state, row, at);
        at += each.size();
      }
      add(state.timeS(), row);
    }

    /** All that were added. */
    public Samples build() {
      double[][] exact = new double[columns.length][];
      for (int i = 0; i < columns.length; i++) {
        exact[i] = Arrays.copyOf(columns[i], rows);
      }
      return new Samples(Arrays.copyOf(timesS, rows), quantities, exact);
    }
  }

  /** What they are samples of. */
  public List<StateQuantity> quantities() {
    return quantities;
  }

  /** Whether there are samples of a quantity. */
  public boolean has(StateQuantity quantity) {
    return columns.containsKey(quantity.name());
  }

  /** How many there are. */
  public int rows() {
    return timesS.length;
  }

  /** The time of row {@code row}, s. */
  public double timeS(int row) {
    return timesS[row];
  }

  /** The time of the first row, s; there is one. */
  public double firstS() {
    return timesS[0];
  }

  /** The time of the last row, s; there is one. */
  public double lastS() {
    return timesS[timesS.length - 1];
  }

  /** A number of row {@code row}. */
  public double value(StateQuantity quantity, int component, int row) {
    return columns.get(quantity.name())[component][row];
  }

  /** The numbers of a quantity in row {@code row}, in a new array. */
  public double[] values(StateQuantity quantity, int row) {
    double[] values = new double[quantity.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = value(quantity, i, row);
    }
    return values;
  }

  /** A number between two rows, on the straight line; before and after all, that of the end. */
  public double at(StateQuantity quantity, int component, double timeS) {
    double[] column = columns.get(quantity.name())[component];
    int row = rowBefore(timeS);
    if (row + 1 >= column.length || timeS <= timesS[row]) {
      return column[row];
    }
    double part = (timeS - timesS[row]) / (timesS[row + 1] - timesS[row]);
    return column[row] + part * (column[row + 1] - column[row]);
  }

  /** The last row that is not after a time, or the first. */
  public int rowBefore(double timeS) {
    int found = Arrays.binarySearch(timesS, timeS);
    return found >= 0 ? found : Math.max(0, -found - 2);
  }

  /** The rows from {@code from} up to {@code end}, which is not among them. */
  public Samples rows(int from, int end) {
    List<double[]> all = new ArrayList<>();
    for (StateQuantity each : quantities) {
      for (double[] column : columns.get(each.name())) {
        all.add(Arrays.copyOfRange(column, from, end));
      }
    }
    return new Samples(
        Arrays.copyOfRange(timesS, from, end), quantities, all.toArray(new double[0][]));
  }

  /** The same with another quantity, by component and row. */
  Samples with(StateQuantity quantity, double[][] numbers) {
    List<StateQuantity> more = new ArrayList<>(quantities);
    more.add(quantity);
    List<double[]> all = new ArrayList<>();
    quantities.forEach(each -> all.addAll(List.of(columns.get(each.name()))));
    all.addAll(List.of(numbers));
    return new Samples(timesS, more, all.toArray(new double[0][]));
  }
}
