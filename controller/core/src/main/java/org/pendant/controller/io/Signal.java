package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Digital signal.
 *
 * @param bank the group it belongs to
 * @param index its number in the group, from 0
 */
public record Signal(SignalBank bank, int index) {
  private static final SignalBank[] INPUTS =
      Arrays.stream(SignalBank.values()).filter(SignalBank::input).toArray(SignalBank[]::new);
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
    throw new IllegalArgumentException(text("unknownInput", name, valid(INPUTS)));
  }

  /**
   * The signal called {@code name}, such as {@code tool_out[1]}.
   *
   * @throws IllegalArgumentException if there is none; the message names those there are
   */
  public static Signal named(String name) {
    Matcher parts = NAME.matcher(name);
    if (parts.matches()) {
      int index = Integer.parseInt(parts.group(2));
      for (SignalBank bank : SignalBank.values()) {
        if (bank.text().equals(parts.group(1)) && index < bank.size()) {
          return new Signal(bank, index);
        }
      }
    }
    throw new IllegalArgumentException(text("unknownSignal", name, valid(SignalBank.values())));
  }

  private static String valid(SignalBank... banks) {
    return Arrays.stream(banks)
        .map(bank -> bank.text() + "[0] to [" + (bank.size() - 1) + "]")
        .collect(Collectors.joining(", "));
  }

  @Override
  public String toString() {
    return bank.text() + "[" + index + "]";
  }
}
