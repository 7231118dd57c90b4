package org.pendant.desktop.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * Memory list: which places of a memory are shown, with their values. A place is in use once it has
 * held something other than zero, or has a name.
 */
final class MemoryList {
  /** The longest 32-bit integer. */
  private static final int LONGEST = 11;

  private static final MathContext BRIEF = new MathContext(6);

  private final Memory memory;
  private final Forcing forcing;
  private final SignalLabels labels;
  private final double[] values;
  private final BitSet used = new BitSet();
  private List<Integer> shown = List.of();
  private String search = "";
  private boolean onlyUsed = true;
  private boolean programRuns;
  private long frame = -1;

  MemoryList(Memory memory, Forcing forcing, SignalLabels labels) {
    this.memory = memory;
    this.forcing = forcing;
    this.labels = labels;
    values = new double[memory.size()];
    choose();
  }

  Memory memory() {
    return memory;
  }

  /** Takes the newest snapshot. */
  void take(ControllerState state) {
    if (state.frame() < frame) {
      // another controller has been switched on
      used.clear();
    }
    frame = state.frame();
    programRuns = state.program().state() != ProgramState.STOPPED;
    boolean more = false;
    for (int i = 0; i < values.length; i++) {
      values[i] = memory.value(state, i);
      if (values[i] != 0 && !used.get(i)) {
        used.set(i);
        more = true;
      }
    }
    if (more) {
      choose();
    }
  }

  /**
   * Shows what is looked for.
   *
   * @param text a number, or a part of a name; blank for nothing in particular
   * @param inUse whether only places in use are shown while nothing is looked for
   */
  void filter(String text, boolean inUse) {
    search = text.strip().toLowerCase(Locale.ROOT);
    onlyUsed = inUse;
    choose();
  }

  private void choose() {
    shown = IntStream.range(0, memory.size()).filter(this::wanted).boxed().toList();
  }

  private boolean wanted(int index) {
    if (!search.isEmpty()) {
      return label(index).toLowerCase(Locale.ROOT).contains(search)
          || (search.chars().allMatch(Character::isDigit)
              ? Integer.toString(index).equals(search)
              : memory.name(index).contains(search));
    }
    return !onlyUsed || used.get(index) || !label(index).isEmpty();
  }

  /** The places to show, from the lowest. */
  List<Integer> shown() {
    return shown;
  }

  /** What people call a place; empty while it has no name. */
  String label(int index) {
    return labels.of(memory.id(index));
  }

  /** Names a place. */
  void name(int index, String label) {
    labels.name(memory.id(index), label);
  }

  /** What a place holds; what was asked for counts before the controller has set it. */
  double value(int index) {
    return memory.asked(forcing, index).orElse(values[index]);
  }

  /** The whole value of a place as a text. */
  String text(int index) {
    double value = value(index);
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  /** The value of a place, not too long to be read at a glance. */
  String brief(int index) {
    String text = text(index);
    double value = value(index);
    return text.length() <= LONGEST || !Double.isFinite(value)
        ? text
        : new BigDecimal(value).round(BRIEF).stripTrailingZeros().toString();
  }

  /** Whether the user has set this input away from rest. */
  boolean forced(int index) {
    return forcing.forced(memory.name(index));
  }

  /** Whether people may change values now. */
  boolean settable() {
    return memory.input() || !programRuns;
  }

  /** Changes a level. */
  void toggle(int index) {
    forcing.write(memory.write(index, value(index) == 0 ? 1 : 0));
  }

  /**
   * Sets a place to what the user typed.
   *
   * @throws IllegalArgumentException with a sentence for people if it does not take it
   */
  void set(int index, String text) {
    forcing.write(memory.write(index, parse(text)));
  }

  /**
   * Checks what the user typed.
   *
   * @throws IllegalArgumentException as {@link #set}
   */
  void check(String text) {
    var _ = parse(text);
  }

  private double parse(String text) {
    try {
      double value = Double.parseDouble(text.strip().replace(',', '.'));
      if (memory.accepts(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // the message below says what is wrong with it
    }
    throw new IllegalArgumentException(IoTexts.text("mustBe", text.strip(), memory.takes()));
  }
}
