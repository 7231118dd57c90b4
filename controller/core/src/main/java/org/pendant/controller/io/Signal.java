package org.pendant.controller.io;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Digital signal.
 *
 * @param bank the group it belongs to
 * @param index its number in the group, from 0
 */
public record Signal(SignalBank bank, int index) {
  private static final Pattern NAME = Pattern.compile("(\\w+)\\[(\\d{1,2})\\]");

  /**
   * Checks the number.
   *
   * @throws IllegalArgumentException if the group has no such signal
   */
  public Signal {
    bank.check(index);
  }

  /**
   * The input called {@code name}, such as {@code digital_in[0]}.
   *
   * @throws IllegalArgumentException if there is none; the message names those there are
   */
  public static Signal input(String name) {
    Matcher parts = NAME.matcher(name);
    if (parts.matches()) {
      int index = Integer.parseInt(parts.group(2));
      for (SignalBank bank : SignalBank.values()) {
        if (bank.input() && bank.text().equals(parts.group(1)) && index < bank.size()) {
          return new Signal(bank, index);
        }
      }
    }
    throw new IllegalArgumentException("input is '" + name + "', must be one of " + validInputs());
  }

  private static String validInputs() {
    StringBuilder names = new StringBuilder();
    for (SignalBank bank : SignalBank.values()) {
      if (bank.input()) {
        names.append(names.isEmpty() ? "" : ", ").append(bank.text());
        names.append("[0] to [").append(bank.size() - 1).append(']');
      }
    }
    return names.toString();
  }

  @Override
  public String toString() {
    return bank.text() + "[" + index + "]";
  }
}
