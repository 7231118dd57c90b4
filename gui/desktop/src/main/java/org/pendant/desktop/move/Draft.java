package org.pendant.desktop.move;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.kit.text.Messages;

/**
 * Draft: numbers that show what the robot has, until the user types over one: then all of them stay
 * as they are, for a goal to be made of. A number that was not typed keeps its full precision.
 */
final class Draft {
  /** Said of numbers that the user has typed. */
  static final String GOAL = MoveTexts.text("goalNotWhereTheArmIs");

  /** What else must be true of a number. */
  @FunctionalInterface
  interface Check {
    /** Why number {@code index}, in m, rad or kg, cannot be; empty if it can. */
    Optional<String> problem(int index, double value);
  }

  private final Check check;
  private final double[] values;
  private final String[] texts;
  private final String[] problems;
  private List<DisplayUnit> units;
  private boolean edited;
  private Runnable typed = () -> {};

  /** Zeros in these units. */
  Draft(List<DisplayUnit> units, Check check) {
    this.units = List.copyOf(units);
    this.check = check;
    values = new double[units.size()];
    texts = new String[units.size()];
    problems = new String[units.size()];
    writeAll();
  }

  int size() {
    return values.length;
  }

  /** Shows what the robot has, in m, rad and kg; not while the user's numbers are shown. */
  void follow(double[] present) {
    if (!edited && !Arrays.equals(present, values)) {
      System.arraycopy(present, 0, values, 0, values.length);
      writeAll();
    }
  }

  /** Has {@code action} follow whenever the user types. */
  void whenTyped(Runnable action) {
    typed = action;
  }

  /** Shows numbers, in m, rad and kg, as if the user had typed them. */
  void put(double[] numbers) {
    edited = true;
    System.arraycopy(numbers, 0, values, 0, values.length);
    writeAll();
    checkAll();
    typed.run();
  }

  /** The user types. */
  void type(int index, String text) {
    edited = true;
    typed.run();
    texts[index] = text;
    problems[index] = "";
    try {
      double value = units.get(index).parse(text);
      problems[index] = check.problem(index, value).orElse("");
      values[index] = value;
    } catch (IllegalArgumentException e) {
      problems[index] = Messages.shown(e.getMessage());
    }
  }

  /** Follows the robot again. */
  void reset() {
    edited = false;
    writeAll();
  }

  /**
   * Shows the same in other units or another form.
   *
   * @param converted the numbers in m, rad and kg, in that form
   */
  void convert(List<DisplayUnit> others, double[] converted) {
    units = List.copyOf(others);
    System.arraycopy(converted, 0, values, 0, values.length);
    writeAll();
    if (edited) {
      checkAll();
    }
  }

  private void checkAll() {
    for (int i = 0; i < values.length; i++) {
      problems[i] = check.problem(i, values[i]).orElse("");
    }
  }

  private void writeAll() {
    for (int i = 0; i < values.length; i++) {
      texts[i] = units.get(i).text(values[i]);
      problems[i] = "";
    }
  }

  /** Whether the user has typed since the last {@link #reset}. */
  boolean edited() {
    return edited;
  }

  boolean valid() {
    return Arrays.stream(problems).allMatch(String::isEmpty);
  }

  /** The numbers in m, rad and kg; of a field with a problem the last that it had without. */
  double[] values() {
    return values.clone();
  }

  String text(int index) {
    return texts[index];
  }

  DisplayUnit unit(int index) {
    return units.get(index);
  }

  /** What is wrong with a number, as a sentence; empty if nothing is. */
  String problem(int index) {
    return problems[index];
  }

  /** The first of the problems; empty if there is none. */
  String problem() {
    return Arrays.stream(problems).filter(each -> !each.isEmpty()).findFirst().orElse("");
  }
}
