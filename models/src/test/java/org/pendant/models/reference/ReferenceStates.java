package org.pendant.models.reference;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The random states of one arm with what an independent implementation says about them. */
public final class ReferenceStates {
  private final Map<String, Integer> columns = new HashMap<>();
  private final List<double[]> rows = new ArrayList<>();

  private ReferenceStates() {}

  /** One random state. */
  public final class State {
    private final double[] row;

    private State(double[] row) {
      this.row = row;
    }

    /** The single number in column {@code name}. */
    public double number(String name) {
      return row[columns.get(name)];
    }

    /** The numbers in the columns {@code name_0} and following. */
    public double[] numbers(String name, int count) {
      double[] numbers = new double[count];
      System.arraycopy(row, columns.get(name + "_0"), numbers, 0, count);
      return numbers;
    }
  }

  /** Reads the states of an arm. */
  public static ReferenceStates of(String armId) {
    ReferenceStates states = new ReferenceStates();
    String file = armId + ".csv";
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                ReferenceStates.class.getResourceAsStream(file), StandardCharsets.US_ASCII))) {
      String[] names = in.readLine().split(",", -1);
      for (int i = 0; i < names.length; i++) {
        states.columns.put(names[i], i);
      }
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        String[] texts = line.split(",", -1);
        double[] row = new double[texts.length];
        for (int i = 0; i < row.length; i++) {
          row[i] = Double.parseDouble(texts[i]);
        }
        states.rows.add(row);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return states;
  }

  /** All states. */
  public List<State> all() {
    return rows.stream().map(State::new).toList();
  }
}
